"""The shipped cases, from a name to a certified folder, checked from outside."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from berthing.cli import app
from support import outside

# B's vehicle meets no constraint: 12 m² d² / T³ with d = 9.5 m (public problem data).
COST_B = 12 * 9 * 9.5**2 / 150**3
# The limit of A's cost is 0.00893; more than this is another passage, or a loose plan.
COST_A = 0.0090
# The outside checker's cylinders bulge by 0.5 mm, and its distances are good to 1e-6.
OUTSIDE_SLACK_M = 6e-4
OUTSIDE_SAMPLES = 6001


def plan(name: str, folder: Path, *more: str) -> dict:
    result = CliRunner().invoke(app, ["plan", name, "--out", str(folder), "--json", *more])
    assert result.exit_code == 0, result.output
    return json.loads((folder / "plan.json").read_text())


@pytest.fixture(scope="module")
def folder_b(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("plans") / "b"
    plan("scenario-b", folder)
    return folder


def check(folder: Path, document: dict) -> None:
    verification = document["verification"]
    assert document["outcome"] == "certified"
    assert verification["clearance_lower_bound_m"] >= 0.1
    assert outside.least_distance(folder, OUTSIDE_SAMPLES) >= 0.1 - OUTSIDE_SLACK_M
    replay = verification["replays"][0]
    assert replay["end_position_error_m"] <= 1e-3
    assert replay["end_attitude_error_rad"] <= np.deg2rad(0.01)
    last = outside.table(folder, "trajectory.csv")[-1]
    goal = document["scenario"]["phases"][0]["vehicles"][0]["goal"]
    reached = [float(last[key]) for key in ("x_m", "y_m", "z_m")]
    assert np.allclose(reached, goal["position_m"], atol=1e-6, rtol=0)
    assert abs(abs(float(last["qw"])) - 1.0) <= 1e-6
    still = [float(last[k]) for k in ("vx_m_s", "vy_m_s", "vz_m_s", "wx_rad_s", "wy_rad_s")]
    assert np.allclose(still, 0.0, atol=1e-6)


def test_scenario_b(folder_b: Path) -> None:
    document = json.loads((folder_b / "plan.json").read_text())
    check(folder_b, document)
    assert document["cost"] == pytest.approx(COST_B, abs=5e-7)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [0, 7])
def test_scenario_a(tmp_path: Path, seed: int) -> None:
    document = plan("scenario-a", tmp_path / "a", "--seed", str(seed))
    check(tmp_path / "a", document)
    assert document["cost"] <= COST_A


@pytest.mark.slow
def test_scenario_b_tight(tmp_path: Path) -> None:
    check(tmp_path / "tight", plan("scenario-b-tight", tmp_path / "tight"))


def test_free_space_is_the_closed_form(tmp_path: Path) -> None:
    document = plan("free-space", tmp_path / "free")
    assert document["cost"] == pytest.approx(12 * 9 * 109 / 150**3, abs=1e-9)
    assert document["verification"]["hamiltonian_relative_drift"] <= 1e-6


def test_the_outside_checker_sees_a_collision(folder_b: Path, tmp_path: Path) -> None:
    moved = tmp_path / "moved"
    shutil.copytree(folder_b, moved)
    document = json.loads((moved / "plan.json").read_text())
    document["scenario"]["structures"][0]["position_m"][1] -= 0.8
    (moved / "plan.json").write_text(json.dumps(document))
    assert outside.least_distance(folder_b, 301) >= 0.1
    assert outside.least_distance(moved, 301) < 0.25


def _edit(folder: Path, name: str, change: Callable[[dict], None]) -> None:
    document = json.loads((folder / name).read_text())
    change(document)
    (folder / name).write_text(json.dumps(document))


def _segments(document: dict) -> list[dict]:
    return document["phases"][0]["vehicles"][0]["segments"]


def _shift(document: dict) -> None:
    for segment in _segments(document):
        segment["state"][0][1] += 0.05


def _stretch(document: dict) -> None:
    for segment in _segments(document):
        segment["t0_s"] *= 1.05
        segment["t1_s"] *= 1.05


def _swap_quaternion(document: dict) -> None:
    for segment in _segments(document):
        for row in segment["state"]:
            row[6:10] = [*row[7:10], row[6]]


def _drop_structure(document: dict) -> None:
    document["scenario"]["structures"].pop()


@pytest.mark.parametrize(
    ("name", "change"),
    [
        ("interpolant.json", _shift),
        ("interpolant.json", _stretch),
        ("interpolant.json", _swap_quaternion),
        ("plan.json", _drop_structure),
    ],
)
def test_a_broken_plan_fails_verify(
    folder_b: Path, tmp_path: Path, name: str, change: Callable[[dict], None]
) -> None:
    broken = tmp_path / "broken"
    shutil.copytree(folder_b, broken)
    runner = CliRunner()
    assert runner.invoke(app, ["verify", str(broken)]).exit_code == 0
    _edit(broken, name, change)
    assert runner.invoke(app, ["verify", str(broken)]).exit_code in (2, 4)


@pytest.mark.slow
def test_a_tolerance_settles_the_hamiltonian(tmp_path: Path) -> None:
    document = plan("scenario-b-tight", tmp_path / "settled", "--tolerance", "0.015")
    verification = document["verification"]
    assert document["outcome"] == "certified"
    assert verification["hamiltonian_relative_drift"] <= 0.015
    assert "refine" in document["wall_time_s"]
