"""The checkers in NumPy alone say of a plan folder what ``berthing verify`` says."""

from __future__ import annotations

import json
import runpy
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from berthing.scenario.files import load
from berthing.scenario.point_mass import PointMass
from berthing.scenario.rigid_body import RigidBody
from berthing.verify.folder import verify_folder
from support.shipped import planned_folder, to_be_certified

EXAMPLES = Path(__file__).parents[2] / "examples"
CHECK, FLY = (
    runpy.run_path(str(EXAMPLES / name), run_name="example")["main"]
    for name in ("09_check_certificate.py", "10_fly_the_controls.py")
)
Change = Callable[[dict[str, Any]], object]


def edit(folder: Path, name: str, change: Change) -> None:
    path = folder / name
    document = json.loads(path.read_text(encoding="utf-8"))
    change(document)
    path.write_text(json.dumps(document), encoding="utf-8")


def test_a_sound_folder(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert verify_folder(folder).certified
    CHECK(folder)
    FLY(folder)
    said = capsys.readouterr().out
    assert "every clearance is proven" in said
    assert "craft stays within" in said


def rows(document: dict[str, Any]) -> list[list[float]]:
    """The intervals of the first pair."""
    found: list[list[float]] = document["phases"][0]["pairs"][0]["intervals"]
    return found


FORGED: dict[str, tuple[Change, str]] = {
    "normals flipped": (
        lambda d: [r.__setitem__(slice(3, 9), [-x for x in r[3:]]) for r in rows(d)],
        "claims more than",
    ),
    "bounds raised": (lambda d: rows(d)[0].__setitem__(2, 100.0), "claims more than"),
    "an interval missing": (lambda d: rows(d).pop(), "nothing proves"),
    "a pair missing": (lambda d: d["phases"][0]["pairs"].pop(), "nothing proves"),
    "another scenario": (lambda d: d.update(scenario_sha256="0" * 64), "another scenario"),
    "a tube below nothing": (
        lambda d: d["phases"][0]["tubes"][0].update(position_m=-1.0),
        "nonsense",
    ),
}


@pytest.mark.parametrize("change", FORGED.values(), ids=FORGED)
def test_a_forged_certificate(folder: Path, change: tuple[Change, str]) -> None:
    edit(folder, "certificate.json", change[0])
    with pytest.raises(ValueError, match=change[1]):
        CHECK(folder)


def first(document: dict[str, Any]) -> dict[str, Any]:
    """The first segment of the first vehicle."""
    found: dict[str, Any] = document["phases"][0]["vehicles"][0]["segments"][0]
    return found


UNFLOWN: dict[str, tuple[Change, str]] = {
    "other controls": (
        lambda d: [row.__setitem__(1, row[1] + 0.01) for row in first(d)["control"][:1]],
        "leaves its tube",
    ),
    "more than the limit": (
        lambda d: first(d)["control"][0].__setitem__(2, 0.051),
        "max_force_n is exceeded",
    ),
    "a quaternion that is none": (
        lambda d: first(d)["state"][0].__setitem__(6, 1.1),
        "not a unit one",
    ),
    "another start": (
        lambda d: first(d)["state"][0].__setitem__(2, 1e-4),
        "leaves its tube",
    ),
}


@pytest.mark.parametrize("change", UNFLOWN.values(), ids=UNFLOWN)
def test_what_does_not_fly(folder: Path, change: tuple[Change, str]) -> None:
    edit(folder, "interpolant.json", change[0])
    with pytest.raises(ValueError, match=change[1]):
        FLY(folder)


def test_a_goal_that_is_missed(folder: Path) -> None:
    def elsewhere(document: dict[str, Any]) -> None:
        goal = document["scenario"]["phases"][0]["vehicles"][0]["goal"]
        goal["position_m"] = [10, 0, 2e-6]

    edit(folder, "plan.json", elsewhere)
    with pytest.raises(ValueError, match="misses its goal"):
        FLY(folder)


@pytest.mark.parametrize("main", [CHECK, FLY])
def test_a_message_and_no_traceback(
    main: Callable[[str], None], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    name = Path(main.__code__.co_filename)
    (tmp_path / "plan.json").write_text("[[[", encoding="utf-8")
    monkeypatch.setattr(sys, "argv", [str(name), str(tmp_path)])
    with pytest.raises(SystemExit, match=r"not (proven|flown): "):
        runpy.run_path(str(name), run_name="__main__")


@pytest.mark.slow
@pytest.mark.parametrize("name", to_be_certified())
def test_shipped_plans(name: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = planned_folder(name, tmp_path_factory)
    assert verify_folder(folder).certified
    CHECK(folder)
    if all(isinstance(v.model, RigidBody | PointMass) for v in load(name).phases[0].vehicles):
        FLY(folder)
        return
    with pytest.raises(ValueError, match="is not in list"):
        FLY(folder)
