"""The paper's own method on its own problems."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from typer.testing import CliRunner

import berthing as bt
from berthing.cli import app
from berthing.planner import plan
from berthing.result import CERTIFIED, NOT_CERTIFIED
from support import outside
from support.shipped import planned_smaller, to_be_certified

ALIKE = 0.01
"""Of costs: two formulations of one problem."""

PRINTED_COST = 0.0081, 0.0083
"""Of the model as printed, which lets the true boxes through each other."""

OUTSIDE_SAMPLES = 6001
OVERLAP_M = 1e-6
"""Of the outside checker, whose distances end at zero."""


@pytest.mark.slow
@pytest.mark.parametrize("name", ["scenario-a", "scenario-b", "scenario-b-tight"])
def test_closest_points_reach_the_optimum_of_planes(name: str) -> None:
    given = bt.load(name)
    plane, kkt = (
        plan(given, options=replace(given.solver, formulation=form)) for form in ("plane", "kkt")
    )
    for result in (plane, kkt):
        assert result.outcome == CERTIFIED, (result.advice, result.attempts)
    assert plane.plan is not None
    assert kkt.plan is not None
    assert kkt.plan.formulation == "kkt"
    assert kkt.plan.cost == pytest.approx(plane.plan.cost, rel=ALIKE)
    # The last answer is one of closest points, not of planes.
    assert any(", kkt" in a.guess and a.outcome == "solved" for a in kkt.attempts)


@pytest.mark.slow
def test_scenario_a_as_printed_is_rejected(tmp_path: Path) -> None:
    folder = tmp_path / "printed"
    done = CliRunner().invoke(app, ["plan", "scenario-a-printed", "--out", str(folder)])
    assert done.exit_code == 4, done.output
    document = json.loads((folder / "plan.json").read_text())
    assert document["outcome"] == NOT_CERTIFIED
    assert document["formulation"] == "kkt"
    assert document["scheme"] == "lgl-global"
    assert PRINTED_COST[0] <= document["cost"] <= PRINTED_COST[1]
    found = document["verification"]
    assert not found["certified"]
    assert found["closest_pair"] == "spacecraft.hull|T1.plate"
    assert 40.0 < found["closest_time_s"] < 65.0
    assert any("spacecraft.hull, T1.plate" in why and "overlap" in why for why in found["reasons"])
    # So says the checker that shares no code with the package: the true boxes overlap.
    assert found["closest_distance_m"] < -0.1
    assert outside.least_distance(folder, OUTSIDE_SAMPLES) < OVERLAP_M
    # Flying the controls and the ends are right all the same: they see nothing of it.
    assert found["replay_position_error_m"] < 1e-2
    assert max(end["position_m"] for end in found["ends"]) < 1e-6
    again = CliRunner().invoke(app, ["verify", str(folder)])
    assert again.exit_code == 4, again.output


def test_only_the_printed_case_is_planned_smaller_than_it_is() -> None:
    assert planned_smaller("scenario-a-printed")
    assert "scenario-a-printed" not in to_be_certified()
    assert {"scenario-a", "scenario-b", "scenario-b-tight", "free-space", "point-mass-2d",
            "point-mass-3d", "spinning-structure", "two-vehicles-swap",
            "offset-mass-wrench"} <= set(to_be_certified())  # fmt: skip
    printed, plain = bt.load("scenario-a-printed"), bt.load("scenario-a")
    for one, other in zip(printed.pairs(printed.phases[0]), plain.pairs(plain.phases[0]),
                          strict=True):  # fmt: skip
        # They are checked against the same sets.
        assert type(one.part_b.shape) is type(other.part_b.shape)
        assert type(one.part_b.planning_shape) is not type(one.part_b.shape)
