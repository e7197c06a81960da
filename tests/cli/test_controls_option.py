"""``--controls`` and ``--sample-time``: commands as flight computers hold them, checked so."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from support.documents import box, puck, scenario, structure

SAMPLE_S = 2.0


@pytest.fixture
def given(tmp_path: Path) -> str:
    """A puck past a block that leaves it room, as a file."""
    low = structure("low", [3, -3.0], box(0.5, 2.5))
    file = tmp_path / "puck.json"
    file.write_text(json.dumps(scenario(puck(), structures=[low]).document), encoding="utf-8")
    return str(file)


def segments(folder: str) -> list[dict]:
    document = json.loads(Path(folder, "interpolant.json").read_text(encoding="utf-8"))
    (own,) = document["phases"][0]["vehicles"]
    found: list[dict] = own["segments"]
    return found


@pytest.mark.slow
@pytest.mark.parametrize(
    ("controls", "rows", "words"),
    [("piecewise-constant", 1, "held for 2 s at a time"),
     ("piecewise-linear", 2, "linear over 2 s at a time")],
)  # fmt: skip
def test_held_commands_are_planned_and_certified(run, given, controls, rows, words) -> None:
    done = run("plan", given, "--out", "flown", "--controls", controls,
               "--sample-time", str(SAMPLE_S))  # fmt: skip
    assert done.exit_code == 0, done.output
    assert words in done.stdout
    own = segments("flown")
    assert len(own) == 50
    assert {len(s["control"]) for s in own} == {rows}
    assert all(s["t1_s"] - s["t0_s"] == pytest.approx(SAMPLE_S) for s in own)
    again = run("verify", "flown")
    assert again.exit_code == 0, again.output
    # Conditions of optimality are the continuous problem's.
    assert "Pontryagin" not in done.stdout


@pytest.mark.slow
def test_another_command_is_not_what_was_certified(run, given) -> None:
    run("plan", given, "--out", "flown", "--controls", "piecewise-constant",
        "--sample-time", str(SAMPLE_S))  # fmt: skip
    path = Path("flown", "interpolant.json")
    document = json.loads(path.read_text(encoding="utf-8"))
    document["phases"][0]["vehicles"][0]["segments"][20]["control"][0][0] += 1e-3
    path.write_text(json.dumps(document), encoding="utf-8")
    assert run("verify", "flown").exit_code == 4


@pytest.mark.parametrize(
    ("words", "named"),
    [(("--controls", "wavy"), "controls"),
     (("--controls", "piecewise-constant", "--sample-time", "0"), "sample_time_s"),
     (("--controls", "piecewise-constant", "--sample-time", "-1"), "sample_time_s")],
)  # fmt: skip
def test_what_cannot_be_flown_is_refused(run, given, words, named: str) -> None:
    done = run("plan", given, "--out", "flown", *words)
    assert done.exit_code == 2
    assert named in done.output.replace("-", "_")
    assert not Path("flown").exists()
