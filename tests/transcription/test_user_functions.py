"""Costs and constraints of the user's own as rows, and ends of models that turn in the plane."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from berthing.geometry import quaternion
from berthing.geometry.body import Body, Part
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.scenario.attitude import FixedAttitude, FreeAttitude
from berthing.scenario.cost import Cost, RunningCost
from berthing.scenario.goal import End
from berthing.scenario.limits import Limits
from berthing.scenario.path_constraint import PathConstraint
from berthing.scenario.scenario import Scenario
from berthing.scenario.user_function import UserFunction
from berthing.scenario.vehicle import Vehicle
from support import users
from support.documents import DURATION_S, box, puck, scenario, structure
from support.solving import posed, solved

DISTANCE_M, MASS_KG = 6.0, 2.0


def changed(given: Scenario, cost: Cost | None = None, *constraints: PathConstraint) -> Scenario:
    """``given`` with another cost and path constraints on its first vehicle."""
    phase = given.phases[0]
    first = replace(phase.vehicles[0], path_constraints=constraints)
    phase = replace(phase, cost=cost or phase.cost, vehicles=(first, *phase.vehicles[1:]))
    return replace(given, phases=(phase,))


def energy(t, x, u, p, xp):
    return p["weight"] * xp.sumsqr(u)


def test_a_running_cost_replaces_the_energy() -> None:
    function = UserFunction("energy", energy, {"weight": 2.0})
    plain = solved(scenario(puck()))
    own = solved(changed(scenario(puck()), Cost(0.0, 0.0, (RunningCost("puck", function, 1e-4),))))
    assert plain.outcome.cost == pytest.approx(12 * (MASS_KG * DISTANCE_M) ** 2 / DURATION_S**3)
    assert own.outcome.cost == pytest.approx(2 * plain.outcome.cost, rel=1e-6)


def test_a_running_cost_of_time_and_state_is_integrated() -> None:
    """∫ t (x₀/6 m) dt along 3τ² − 2τ³, which is all that the energy leaves free to it."""
    function = UserFunction("late", lambda t, x, u, p, xp: 1e-9 * t * x[0] / DISTANCE_M)
    added = Cost(1.0, 0.0, (RunningCost("puck", function),))
    plain, own = solved(scenario(puck())), solved(changed(scenario(puck()), added))
    expected = 1e-9 * DURATION_S**2 * (3 / 4 - 2 / 5)
    assert own.outcome.cost - plain.outcome.cost == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("scheme_degree", [3, 4])
def test_a_constraint_on_the_state_holds_at_the_points(scheme_degree) -> None:
    top = UserFunction("slow", lambda t, x, u, p, xp: x[2] ** 2 + x[3] ** 2 - p["v"] ** 2,
                       {"v": 0.07})  # fmt: skip
    slow = PathConstraint("slow", top, tolerance=1e-5, scale=0.01)
    found = solved(changed(scenario(puck()), None, slow), 6, scheme_degree)
    assert found.outcome.solved
    square = np.sum(found.outcome.motion.states["puck"][2:4] ** 2, axis=0)
    # Below zero by the tolerance, which makes room for what happens between the nodes.
    assert np.max(square) == pytest.approx(0.07**2 - 1e-5, abs=1e-8)
    blocks = [b for b in found.problem.layout.rows.blocks if b.label(0).startswith("path[")]
    assert sum(b.size for b in blocks) == found.problem.mesh.point_count
    assert blocks[0].label(1).startswith("path[puck, slow, t = ")


def test_the_backoff_spares_the_ends_of_the_phase() -> None:
    """The start lies on zero exactly, 1 m before it nothing else may."""
    behind = UserFunction("behind", lambda t, x, u, p, xp: -1.0 - x[0])
    given = scenario(puck(start={"position_m": [-1, 0]}))
    constraint = PathConstraint("behind", behind, tolerance=1e-2, scale=0.5)
    found = solved(changed(given, None, constraint), 3, 3)
    assert found.outcome.solved
    x = found.outcome.motion.states["puck"][0]
    assert x[0] == pytest.approx(-1.0, abs=1e-8)
    assert np.min(x[1:]) >= -1.0 + 1e-2 - 1e-7
    rows = [b for b in found.problem.layout.rows.blocks if b.label(0).startswith("path[")]
    upper = found.problem.layout.rows.bounds()[1][rows[0].offset :][: rows[0].size]
    np.testing.assert_allclose(upper, [0.0, *[-0.02] * (rows[0].size - 2), 0.0])


def test_a_constraint_on_the_control_holds_at_the_ends_of_segments_too() -> None:
    top = UserFunction("weak", lambda t, x, u, p, xp: xp.vector(u[0] - 0.0065, -u[0] - 0.0065))
    found = solved(changed(scenario(puck()), None, PathConstraint("weak", top, 1e-6, 0.01)), 6, 3)
    assert found.outcome.solved
    control = found.trajectory.vehicle("puck").control(np.linspace(0, DURATION_S, 601))[:, 0]
    breaks = np.arange(1, 7) * DURATION_S / 6
    at_ends = found.trajectory.vehicle("puck").control(np.nextafter(breaks, 0))[:, 0]
    assert np.max(np.abs(at_ends)) <= 0.0065 + 1e-7
    assert np.max(np.abs(control)) <= 0.0065 * 1.01
    labels = {b.label(0) for b in found.problem.layout.rows.blocks}
    assert "path[puck, weak 0, t = 100.0 s]" in labels


def test_what_cannot_hold_is_named() -> None:
    high = UserFunction("fast", lambda t, x, u, p, xp: 0.2 - x[2])
    found = solved(changed(scenario(puck()), None, PathConstraint("fast", high)), iterations=100)
    assert not found.outcome.solved


def rover_scenario(goal: End, *structures) -> Scenario:
    model = users.rover()
    body = Body((Part("hull", Sphere(0.3, 2), Pose.identity(2)),))
    start = End(np.zeros(2), attitude=FixedAttitude(planar(0.0)), states={"steering_rad": 0.0})
    limits = Limits(
        np.array([-0.2, -0.2]), np.array([0.2, 0.2]),
        np.array([-np.inf, -np.inf, -np.inf, -1.0, -0.6]),
        np.array([np.inf, np.inf, np.inf, 1.0, 0.6]),
    )  # fmt: skip
    base = scenario(puck(), structures=structures, horizon={"duration_s": 30})
    rover = Vehicle("rover", body, model, limits, start, goal)
    return replace(base, phases=(replace(base.phases[0], vehicles=(rover,)),))


def planar(angle: float):
    return quaternion.from_axis_angle(np.array([0.0, 0.0, 1.0]), np.float64(angle))


def test_a_rover_arrives_as_told() -> None:
    goal = End(np.array([6.0, 2.0]), 0.0, FixedAttitude(planar(0.8)), np.zeros(2), np.zeros(3),
               states={"steering_rad": 0.1})  # fmt: skip
    found = solved(rover_scenario(replace(goal, rate_rad_s=None)), 6, 4)
    assert found.outcome.solved
    first, last = found.outcome.motion.states["rover"][:, [0, -1]].T
    np.testing.assert_allclose(last, [6, 2, 0.8, 0, 0.1], atol=1e-6)
    np.testing.assert_allclose(first[[0, 1, 2, 4]], 0.0, atol=1e-8)


def test_a_rover_arrives_beside_what_spins() -> None:
    """In the frame of a table that turns from 0 to 0.6 rad; the heading relative to it is 0.2."""
    spin = {"type": "spin", "rate_rad_s": 0.02}
    table = structure("table", [6, 2], box(0.1, 0.1), motion=spin)
    goal = End(np.array([0.0, -1.0]), 0.0, FixedAttitude(planar(0.2)), None, None, "table")
    found = solved(rover_scenario(goal, table), 6, 4)
    assert found.outcome.solved
    last = found.outcome.motion.states["rover"][:, -1]
    turn = Pose.planar(np.array([6.0, 2.0]), 0.6)
    np.testing.assert_allclose(last[0:2], turn.apply(np.array([0.0, -1.0])), atol=1e-6)
    assert last[2] == pytest.approx(0.8, abs=1e-6)


def test_rate_rows_in_the_plane() -> None:
    """The rate is that of the table, 0.02 rad/s, and 0.1 rad/s beside it."""
    spin = {"type": "spin", "rate_rad_s": 0.02}
    table = structure("table", [6, 2], box(0.1, 0.1), motion=spin)
    goal = End(np.array([0.0, -1.0]), 0.1, FreeAttitude(), None, np.array([0, 0, 0.1]), "table")
    found = solved(rover_scenario(goal, table), 6, 4)
    assert found.outcome.solved
    last = found.outcome.motion.states["rover"][:, -1]
    assert last[3] * np.tan(last[4]) == pytest.approx(0.12, abs=1e-6)


def test_problems_of_a_model_without_rates() -> None:
    base = scenario(puck())
    model = users.sliding(
        workspace_dim=2, states=("x_m", "y_m", "vx_m_s", "vy_m_s"), controls=("fx_n", "fy_n"),
        derivative=lambda t, x, u, p, xp: xp.vector(x[2:4], u / 2.0),
        place=lambda x, p, xp: x[0:2], rates=None,
    )  # fmt: skip
    still = {"vx_m_s": 0.0, "vy_m_s": 0.0}
    ends = [End(np.array(p), attitude=FreeAttitude(), states=still) for p in ([0, 0], [6, 0])]
    body = base.phases[0].vehicles[0].body
    own = Vehicle("puck", body, model, Limits.unbounded(4, 2), *ends)
    found = solved(replace(base, phases=(replace(base.phases[0], vehicles=(own,)),)))
    assert found.outcome.cost == pytest.approx(12 * (MASS_KG * DISTANCE_M) ** 2 / DURATION_S**3)


def test_rows_of_a_user_are_posed_once_each() -> None:
    top = UserFunction("slow", lambda t, x, u, p, xp: x[2] - 1.0)
    one, two = (
        posed(changed(scenario(puck()), None, *constraints))
        for constraints in ((), (PathConstraint("slow", top),))
    )
    assert two.layout.rows.size - one.layout.rows.size == one.mesh.point_count
