"""Fixed, free and partly free ends, in frames that rest, drift and spin: planned and certified."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.planner import plan
from berthing.result import CERTIFIED
from berthing.scenario.goal import InertialEnd
from support.documents import DURATION_S, box, puck, scenario, spacecraft, structure

MET = 1e-6
X, Y = np.eye(3)[:2]
HULL = [{"name": "hull", "shape": box(2, 1, 1)}]
WALL = structure("wall", [5, 0, 0], box(1, 3, 3))
DOCK = structure("dock", [9, 0, 0], box(2, 2, 2), motion={"type": "spin", "rate_rad_s": 0.01})
FERRY = structure(
    "ferry", [9, 0, 0], box(2, 2, 2),
    motion={"type": "constant-velocity", "velocity_m_s": [0, 0.02, 0]},
)  # fmt: skip


def arrive(goal: dict[str, Any], *structures: dict[str, Any]) -> tuple[Array, InertialEnd, float]:
    """The last state of a certified plan, the goal at that time, and the plan's cost."""
    given = scenario(spacecraft(parts=HULL, goal=goal), structures=structures)
    result = plan(given)
    assert result.outcome == CERTIFIED, (result.advice, result.attempts)
    assert result.plan is not None
    (last,) = result.plan.phases[0].vehicles[0].state(np.array([DURATION_S]))
    wanted = given.phases[0].vehicles[0].goal.resolve(DURATION_S, given)
    return last, wanted, result.plan.cost


def axis(q: Array, body: Array) -> Array:
    return quaternion.rotation_matrix(q) @ body


def turned(q: Array, wanted: InertialEnd) -> float:
    return float(wanted.attitude.error_rad(q))


def test_a_ball_of_positions_in_the_plane_is_entered_where_that_is_cheapest():
    """From rest to any velocity 5.5 m on: 3 m² d² / T³."""
    result = plan(
        scenario(
            puck(goal={"position_m": [6, 0], "position_tolerance_m": 0.5, "velocity_m_s": "free"})
        )
    )
    assert result.outcome == CERTIFIED
    assert result.plan is not None
    assert result.plan.cost == pytest.approx(3 * (2 * 5.5) ** 2 / DURATION_S**3, rel=1e-5)


@pytest.mark.slow
def test_any_attitude():
    last, wanted, free = arrive(
        {"position_m": [10, 0, 0], "attitude": "free", "rate_rad_s": "free"}, WALL
    )
    np.testing.assert_allclose(last[:6], [*wanted.position_m, 0, 0, 0], atol=MET)
    _, _, fixed = arrive({"position_m": [10, 0, 0]}, WALL)
    assert free <= fixed * (1 + 1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("tolerance", [0.0, 0.2])
def test_an_axis_that_points(tolerance):
    pointing = {"body_axis": [1, 0, 0], "points_along": [0, 1, 0], "tolerance_rad": tolerance}
    last, _, _ = arrive({"position_m": [10, 0, 0], "attitude": pointing}, WALL)
    angle = np.arccos(np.clip(axis(last[6:10], X) @ Y, -1, 1))
    assert angle <= tolerance + 1e-5
    assert angle >= tolerance - 1e-3  # it costs to turn further


@pytest.mark.slow
def test_a_ball_of_positions():
    last, wanted, _ = arrive(
        {"position_m": [10, 0, 0], "position_tolerance_m": 0.5, "velocity_m_s": "free"}, WALL
    )
    assert np.linalg.norm(last[:3] - wanted.position_m) == pytest.approx(0.5, abs=1e-4)
    np.testing.assert_allclose(last[10:13], 0.0, atol=MET)


@pytest.mark.slow
def test_a_cone_of_attitudes():
    q = quaternion.from_axis_angle(np.array([0.0, 0.0, 1.0]), np.float64(0.5 * np.pi))
    goal = {"position_m": [10, 0, 0], "attitude": q.tolist(), "attitude_tolerance_rad": 0.3}
    last, wanted, _ = arrive(goal, WALL)
    assert turned(last[6:10], wanted) == pytest.approx(0.3, abs=1e-4)


@pytest.mark.slow
def test_beside_a_ferry():
    last, wanted, _ = arrive({"position_m": [0, 2, 0], "frame": "ferry"}, FERRY)
    np.testing.assert_allclose(last[0:3], [9, 4, 0], atol=MET)
    np.testing.assert_allclose(last[3:6], [0, 0.02, 0], atol=MET)
    assert turned(last[6:10], wanted) < 1e-5


@pytest.mark.slow
@pytest.mark.parametrize(
    "attitude",
    [None, {"body_axis": [1, 0, 0], "points_along": [-1, 0, 0]}],
    ids=["fixed", "axis"],
)
def test_beside_a_dock_that_spins(attitude):
    goal = {"position_m": [2.5, 0, 0], "frame": "dock"}
    last, wanted, _ = arrive(goal | ({"attitude": attitude} if attitude else {}), DOCK)
    np.testing.assert_allclose(last[0:3], wanted.position_m, atol=MET)
    # The point of the dock's frame moves across its arm.
    arm = last[0:3] - [9, 0, 0]
    np.testing.assert_allclose(last[3:6], np.cross([0, 0, 0.01], arm), atol=MET)
    assert turned(last[6:10], wanted) < 1e-5
    spin = quaternion.rotation_matrix(last[6:10]) @ last[10:13]
    np.testing.assert_allclose(spin, [0, 0, 0.01], atol=MET)


def test_somewhere_beside_a_dock_that_spins():
    goal = {"position_m": [0, 2.5, 0], "position_tolerance_m": 0.3, "frame": "dock",
            "attitude": "free", "rate_rad_s": "free"}  # fmt: skip
    last, wanted, _ = arrive(goal, DOCK)
    assert np.linalg.norm(last[:3] - wanted.position_m) <= 0.3 + MET
