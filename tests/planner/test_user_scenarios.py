"""Scenarios with functions of the user's own, planned and certified."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from berthing.planner import plan
from berthing.result import CERTIFIED, Result
from berthing.scenario.cost import Cost, RunningCost
from berthing.scenario.files import load
from berthing.scenario.path_constraint import PathConstraint
from berthing.scenario.scenario import Scenario
from berthing.scenario.user_function import UserFunction
from support import users
from support.documents import DURATION_S, box, puck, scenario, spacecraft, structure

WALL = structure("wall", [5, -2, 0], box(1, 5, 3))
ROVER = Path(__file__).parents[2] / "examples" / "rover" / "rover.yaml"
HULL = [{"name": "hull", "shape": box(2, 1, 1)}]


def certified(given: Scenario) -> Result:
    result = plan(given)
    assert result.outcome == CERTIFIED, (result.advice, result.attempts)
    return result


def changed(given: Scenario, cost: Cost | None = None, **fields) -> Scenario:
    phase = given.phases[0]
    first = replace(phase.vehicles[0], **fields)
    return replace(given, phases=(replace(phase, cost=cost or phase.cost, vehicles=(first,)),))


def constraint(function, tolerance=1e-4, scale=1.0, **p) -> PathConstraint:
    return PathConstraint("own", UserFunction("own", function, p), tolerance, scale)


def test_a_speed_limit_holds_between_the_nodes_to_a_tight_tolerance():
    """Where it acts the state is a curve, whose square overshoots between nodes by 1e-6 or so."""
    slow = constraint(
        lambda t, x, u, p, xp: xp.sumsqr(x[2:4]) / p["most"] ** 2 - 1.0, 1e-6, most=0.07
    )
    result = certified(changed(scenario(puck()), path_constraints=(slow,)))
    assert result.plan is not None
    assert result.verification is not None
    own = result.plan.phases[0].vehicle("puck")
    speed = np.linalg.norm(own.state(np.linspace(0, DURATION_S, 5001))[:, 2:4], axis=1)
    assert 0.069 < np.max(speed) <= 0.07 * (1 + 1e-6)
    assert result.verification.model_check == "independent"


def test_a_cost_of_the_users_own_is_reported_as_it_is():
    h = RunningCost("puck", UserFunction("h", lambda t, x, u, p, xp: 3.0 * xp.sumsqr(u)), 1e-4)
    result = certified(changed(scenario(puck()), Cost(0.0, 0.0, (h,))))
    assert result.plan is not None
    assert result.plan.cost == pytest.approx(3 * 12 * (2 * 6) ** 2 / DURATION_S**3, rel=1e-5)
    assert result.verification is not None
    assert result.verification.hamiltonian_relative_drift < 1e-5


@pytest.mark.slow
def test_a_twin_of_the_rigid_body_costs_what_it_does():
    given = scenario(spacecraft(parts=HULL), structures=[WALL])
    known = certified(given)
    model = users.twin(given.phases[0].vehicles[0].model)
    own = certified(changed(given, model=model))
    assert known.plan is not None
    assert own.plan is not None
    assert own.plan.cost == pytest.approx(known.plan.cost, rel=5e-3)
    assert own.verification is not None
    assert own.verification.model_check == "same_source"
    assert own.verification.clearance_lower_bound_m >= 0.1


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(8))
def test_the_rover_of_the_examples_holds_its_wheels_between_the_nodes_too(seed):
    given = load(ROVER)
    result = plan(given, options=replace(given.solver, seed=seed))
    assert result.outcome == CERTIFIED, (result.advice, result.attempts)
    assert result.plan is not None
    own = result.plan.phases[0].vehicle("rover")
    x = own.state(np.linspace(own.t0_s, own.t1_s, 5001))
    pull = np.abs(x[:, 3] ** 2 * np.tan(x[:, 4]))
    # The constraint acts, and is kept to its tolerance.
    assert 0.0598 < np.max(pull) <= 0.06 + 1e-4


@pytest.mark.slow
def test_a_cone_before_the_goal():
    """|y|, |z| ≤ tan 20° (10 − x) + 0.02 from x = 6 m on: a line of sight, its apex at the goal."""

    def cone(t, x, u, p, xp):
        room = p["slope"] * (10.0 - x[0]) + 0.02 + 10.0 * xp.maximum(6.0 - x[0], 0.0)
        return xp.vector(x[1] - room, -x[1] - room, x[2] - room, -x[2] - room)

    given = scenario(spacecraft(parts=HULL), structures=[WALL])
    result = certified(
        changed(given, path_constraints=(constraint(cone, 1e-3, slope=np.tan(np.deg2rad(20))),))
    )
    assert result.plan is not None
    x = result.plan.phases[0].vehicles[0].state(np.linspace(0, DURATION_S, 3001))
    late = x[x[:, 0] > 6.0]
    assert np.all(np.abs(late[:, 1]) <= np.tan(np.deg2rad(20)) * (10 - late[:, 0]) + 0.0211)
