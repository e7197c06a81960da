"""A folder is judged by its files alone, and bad files are bad input, never a crash."""

import json
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.scenario.normal import document_sha256
from berthing.trajectory_io import write_interpolant
from berthing.verify.folder import read_plan, verify_folder

FILES = ("plan.json", "interpolant.json", "nodes.csv", "trajectory.csv")


def edited(path: Path, change) -> None:
    document = json.loads(path.read_text(encoding="utf-8"))
    change(document)
    path.write_text(json.dumps(document), encoding="utf-8")


def reasons(folder: Path) -> str:
    found = verify_folder(folder)
    assert not found.certified
    return "\n".join(found.reasons)


def test_a_sound_folder_is_certified(make, folder: Path) -> None:
    found = verify_folder(str(folder))
    assert found.certified, found.reasons
    assert found.backoff_m == 1e-3
    whole, made = make.document_plan()
    scenario, plan = read_plan(folder)
    assert scenario.document == whole.document
    for read, written in zip(
        plan.phases[0].vehicles[0].segments, made.phases[0].vehicles[0].segments, strict=True
    ):
        np.testing.assert_array_equal(read.state, written.state)
        np.testing.assert_array_equal(read.control, written.control)


def test_a_dropped_structure(folder: Path) -> None:
    edited(folder / "plan.json", lambda d: d["scenario"]["structures"].pop())
    assert "scenario: interpolant.json was made for the scenario" in reasons(folder)
    # Whoever edits plan.json's own fingerprint too is still given away by the other file.
    edited(
        folder / "plan.json",
        lambda d: d.update(scenario_sha256=document_sha256(d["scenario"])),
    )
    found = reasons(folder)
    assert "interpolant.json was made" in found
    assert "plan.json was made" not in found


def test_a_lowered_margin_and_a_shrunk_body(folder: Path) -> None:
    edited(folder / "plan.json", lambda d: d["scenario"]["margins"].update(default_m=0.05))
    assert "was made for the scenario" in reasons(folder)


def test_another_trajectory_than_the_tables(make, folder: Path) -> None:
    whole, _ = make.document_plan()
    own = make.glide(whole.phases[0].vehicles[0], (0, 0.0, 0), (10, 0.0, 0.0), np.pi / 2, 100.0, 21)
    sha = document_sha256(whole.document)
    write_interpolant(folder / "interpolant.json", make.plan([own]).phases, sha)
    assert verify_folder(folder).certified, "the same motion in other pieces"
    own = make.glide(
        whole.phases[0].vehicles[0], (0, 0.0, 0), (10, 0.0, 0.01), np.pi / 2, 100.0, 20
    )
    write_interpolant(folder / "interpolant.json", make.plan([own]).phases, sha)
    found = reasons(folder)
    assert "trajectory.csv[craft, t = " in found
    assert "nodes.csv[craft, t = " in found
    assert "goal[craft, position" in found


def lines(folder: Path, name: str) -> list[str]:
    return (folder / name).read_text(encoding="utf-8").splitlines()


def rewrite(folder: Path, name: str, content: list[str]) -> None:
    (folder / name).write_text("\n".join(content) + "\n", encoding="utf-8")


def test_a_table_cut_short_or_edited(folder: Path) -> None:
    content = lines(folder, "trajectory.csv")
    rewrite(folder, "trajectory.csv", content[:-1])
    assert "does not run from 0 to 100 s" in reasons(folder)
    cells = content[500].split(",")
    cells[3] = str(float(cells[3]) + 1e-4)
    rewrite(folder, "trajectory.csv", [*content[:500], ",".join(cells), *content[501:]])
    assert "trajectory.csv[craft, t = 49.9 s] differs from the interpolant" in reasons(folder)
    rewrite(folder, "trajectory.csv", [line.replace("craft", "tug") for line in content])
    assert "trajectory.csv has the vehicles ['tug']" in reasons(folder)


def test_nodes_edited_or_missing(folder: Path) -> None:
    content = lines(folder, "nodes.csv")
    cells = content[5].split(",")
    cells[2] = str(float(cells[2]) + 1e-4)
    rewrite(folder, "nodes.csv", [*content[:5], ",".join(cells), *content[6:]])
    assert "nodes.csv[craft, t = " in reasons(folder)
    rewrite(folder, "nodes.csv", content[:1])
    assert "nodes.csv has nodes of []" in reasons(folder)


@pytest.mark.parametrize("name", FILES)
def test_a_missing_file(folder: Path, name: str) -> None:
    (folder / name).unlink()
    with pytest.raises(InputError, match=f"{name}: is missing"):
        verify_folder(folder)


def test_no_folder(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="is not a folder"):
        verify_folder(tmp_path / "nowhere")


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize(
    "content", [b"", b"\xff\xfe\x00", b"[1, 2", b"{}", b"null", b"\x00" * 50, b'"' * 999]
)
def test_rubbish_in_a_file(folder: Path, name: str, content: bytes) -> None:
    (folder / name).write_bytes(content)
    with pytest.raises(InputError) as caught:
        verify_folder(folder)
    assert name in str(caught.value)


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize("share", [0.02, 0.3, 0.77, 0.999])
def test_a_truncated_file_is_never_certified(folder: Path, name: str, share: float) -> None:
    path = folder / name
    content = path.read_bytes()
    path.write_bytes(content[: int(share * len(content))])
    with suppress(InputError):
        assert not verify_folder(folder).certified


@pytest.mark.parametrize(
    "value", ["NaN", "Infinity", "1e999", "9" * 400, "9" * 5000, '"1"', "null", "1e30"]
)
@pytest.mark.parametrize("key", ["state", "control", "t0_s", "t1_s"])
def test_a_bad_number_in_the_interpolant(folder: Path, key: str, value: str) -> None:
    path = folder / "interpolant.json"
    text = path.read_text(encoding="utf-8")
    start = text.index(f'"{key}": ', text.index('"segments"')) + len(key) + 4
    while text[start] == "[":
        start += 1
    end = start + min(text[start:].index(","), text[start:].index("]"))
    path.write_text(text[:start] + value + text[end:], encoding="utf-8")
    with pytest.raises(InputError):
        verify_folder(folder)


CHANGES = {
    "schema": lambda d: d.update(schema_version=2),
    "schema text": lambda d: d.update(schema_version="1"),
    "basis": lambda d: d.update(basis="monomial"),
    "no phases": lambda d: d.update(phases=[]),
    "phases text": lambda d: d.update(phases="main"),
    "phase name": lambda d: d["phases"][0].update(phase="other"),
    "vehicle": lambda d: d["phases"][0]["vehicles"][0].update(vehicle="tug"),
    "twice": lambda d: d["phases"][0]["vehicles"].append(d["phases"][0]["vehicles"][0]),
    "model": lambda d: d["phases"][0]["vehicles"][0].update(model="point-mass"),
    "names": lambda d: d["phases"][0]["vehicles"][0]["state_names"].reverse(),
    "names numbers": lambda d: d["phases"][0]["vehicles"][0].update(state_names=[1]),
    "no segments": lambda d: d["phases"][0]["vehicles"][0].update(segments=[]),
    "ragged": lambda d: d["phases"][0]["vehicles"][0]["segments"][0]["state"][0].pop(),
    "columns": lambda d: d["phases"][0]["vehicles"][0]["segments"][0].update(control=[[1.0]]),
    "flat": lambda d: d["phases"][0]["vehicles"][0]["segments"][0].update(control=[1.0]),
    "key": lambda d: d["phases"][0]["vehicles"][0]["segments"][0].pop("t0_s"),
    "interpolation": lambda d: d["phases"][0]["vehicles"][0].update(control_interpolation="?"),
    "no fingerprint": lambda d: d.pop("scenario_sha256"),
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES.keys())
def test_an_interpolant_of_another_form(folder: Path, change) -> None:
    edited(folder / "interpolant.json", change)
    with pytest.raises(InputError):
        verify_folder(folder)


PLAN_CHANGES = {
    "schema": lambda d: d.update(schema_version=7),
    "no scenario": lambda d: d.pop("scenario"),
    "scenario text": lambda d: d.update(scenario="scenario-a"),
    "scenario key": lambda d: d["scenario"].update(wings=2),
    "no vehicles": lambda d: d["scenario"]["phases"][0].pop("vehicles"),
    "no verification": lambda d: d.pop("verification"),
    "backoff": lambda d: d["verification"].update(backoff_m="small"),
    "cost": lambda d: d.update(cost=None),
    "formulation": lambda d: d.pop("formulation"),
    "surrogate": lambda d: d["scenario"].update(description="\ud800"),
}


@pytest.mark.parametrize("change", PLAN_CHANGES.values(), ids=PLAN_CHANGES.keys())
def test_a_plan_json_of_another_form(folder: Path, change) -> None:
    edited(folder / "plan.json", change)
    with pytest.raises(InputError):
        verify_folder(folder)


def test_a_scenario_without_a_document_is_said_to_be_one(make, tmp_path: Path) -> None:
    whole, made = make.document_plan()
    make.write_folder(tmp_path, replace(whole, document={}), made)
    with pytest.raises(InputError, match="put together in Python and has no document"):
        verify_folder(tmp_path)


@pytest.mark.parametrize("cell", ["nan", "inf", "-1e999", "much", "1,2"])
@pytest.mark.parametrize("name", ["nodes.csv", "trajectory.csv"])
def test_a_bad_cell(folder: Path, name: str, cell: str) -> None:
    content = lines(folder, name)
    cells = content[7].split(",")
    cells[4] = cell
    rewrite(folder, name, [*content[:7], ",".join(cells), *content[8:]])
    with pytest.raises(InputError, match=name):
        verify_folder(folder)


def test_nested_without_end(folder: Path) -> None:
    (folder / "plan.json").write_text('{"a": ' + "[" * 200_000, encoding="utf-8")
    with pytest.raises(InputError):
        verify_folder(folder)


@pytest.mark.slow
@pytest.mark.parametrize("name", FILES)
def test_flipped_bytes_never_crash(folder: Path, name: str) -> None:
    path, rng = folder / name, np.random.default_rng(1)
    content = path.read_bytes()
    for _ in range(60):
        broken = bytearray(content)
        for place in rng.integers(0, len(content), 3):
            broken[place] = rng.integers(32, 127)
        path.write_bytes(bytes(broken))
        with suppress(InputError):
            verify_folder(folder)
