"""Starts and goals of every kind are met, by the scenario's own numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.scenario.goal import InertialEnd
from support.documents import DURATION_S, box, puck, scenario, spacecraft, structure
from support.solving import Solved, solved

MET = 1e-7
SPIN = {"type": "spin", "rate_rad_s": 0.02, "velocity_m_s": [0.0, 0.01, 0.0]}
TURN = [0.5, 0.5, -0.5, 0.5]


def ends(found: Solved) -> tuple[InertialEnd, InertialEnd]:
    scenario, vehicle = found.problem.scenario, found.problem.phase.vehicles[0]
    duration = found.outcome.motion.duration_s
    return vehicle.start.resolve(0.0, scenario), vehicle.goal.resolve(duration, scenario)


def last(found: Solved) -> Array:
    name = found.problem.phase.vehicles[0].name
    return found.outcome.motion.states[name][:, -1]


def heading(goal: dict[str, Any], **more: Any) -> Solved:
    """To a goal near a dock 8 m ahead that spins and drifts; nothing is kept apart from it."""
    dock = structure("dock", [8, 0, 0], box(1, 1, 1), motion=SPIN, attitude=TURN)
    given = scenario(spacecraft(goal=goal, **more), structures=[dock])
    found = solved(given, 3, 4, sites=[])
    assert found.outcome.solved
    return found


def test_a_plain_end_is_met_exactly() -> None:
    start = {"position_m": [1, 2, 3], "attitude": TURN, "velocity_m_s": [0.1, 0, 0.05],
             "rate_rad_s": [0.01, 0, 0.02]}  # fmt: skip
    goal = {"position_m": [10, 3, 0], "attitude": [0.6, 0, 0.8, 0], "velocity_m_s": [0, 0.1, 0],
            "rate_rad_s": [0, 0.01, 0]}  # fmt: skip
    found = heading(goal, start=start)
    states = found.outcome.motion.states["spacecraft"]
    for x, end in ((states[:, 0], start), (states[:, -1], goal)):
        np.testing.assert_allclose(x[0:3], end["position_m"], atol=MET)
        np.testing.assert_allclose(x[3:6], end["velocity_m_s"], atol=MET)
        assert quaternion.angle_between(x[6:10], np.array(end["attitude"])) < MET
        np.testing.assert_allclose(x[10:13], end["rate_rad_s"], atol=MET)
    assert np.linalg.norm(states[6:10, 0]) == pytest.approx(1.0, abs=1e-9)


@pytest.mark.parametrize("sign", [1, -1])
def test_the_shorter_way_round_whatever_the_sign_of_the_goal(sign) -> None:
    q = sign * quaternion.from_axis_angle(np.array([0.0, 0.0, 1.0]), 0.5)
    found = heading({"position_m": [0, 0, 0], "attitude": q.tolist()})
    # 12 J² θ²/T³ of the shorter way; the longer would cost 130 times that.
    assert found.outcome.cost == pytest.approx(12.0 * 25.0 * 0.25 / DURATION_S**3, rel=1e-6)


def test_free_velocity_and_rate_are_used() -> None:
    bound = heading({"position_m": [10, 0, 0]})
    free = heading({"position_m": [10, 0, 0], "velocity_m_s": "free", "rate_rad_s": "free"})
    # From rest to a place: 3 m² d²/T³ where the speed is free.
    assert bound.outcome.cost == pytest.approx(4.0 * free.outcome.cost, rel=1e-6)
    assert np.linalg.norm(last(free)[3:6]) > 0.1


def test_a_position_within_a_tolerance_stops_at_its_edge() -> None:
    found = heading({"position_m": [10, 3, 0], "position_tolerance_m": 0.5})
    gap = np.linalg.norm(last(found)[0:3] - [10, 3, 0])
    assert gap == pytest.approx(0.5, abs=1e-5)
    reach = np.sqrt(109.0) - 0.5
    assert found.outcome.cost == pytest.approx(12.0 * 9.0 * reach**2 / DURATION_S**3, rel=1e-6)


def test_an_attitude_within_a_tolerance_stops_at_its_edge() -> None:
    q = np.array([np.cos(0.4), 0.0, np.sin(0.4), 0.0])
    goal = {"position_m": [0, 0, 0], "attitude": q.tolist(), "attitude_tolerance_rad": 0.3}
    found = heading(goal)
    assert quaternion.angle_between(last(found)[6:10], q) == pytest.approx(0.3, abs=1e-5)
    assert found.outcome.cost == pytest.approx(12.0 * 25.0 * 0.5**2 / DURATION_S**3, rel=1e-5)


def test_a_free_attitude_does_not_turn() -> None:
    found = heading({"position_m": [10, 0, 0], "attitude": "free"}, start={
        "position_m": [0, 0, 0], "attitude": TURN,
    })  # fmt: skip
    assert quaternion.angle_between(last(found)[6:10], np.array(TURN)) < 1e-6


AXIS = {"body_axis": [1, 0, 0], "points_along": [0, 0, -2]}


def angle_of_axis(found: Solved) -> float:
    _, goal = ends(found)
    return float(goal.attitude.error_rad(last(found)[6:10]))


def test_an_axis_points_where_it_should_and_the_roll_is_free() -> None:
    start = {"position_m": [0, 0, 0], "attitude": [np.cos(0.3), np.sin(0.3), 0, 0]}
    found = heading({"position_m": [10, 0, 0], "attitude": AXIS}, start=start)
    assert angle_of_axis(found) < MET
    # A quarter turn about y, and no roll.
    least = 12.0 * (9.0 * 100.0 + 25.0 * (0.5 * np.pi) ** 2) / DURATION_S**3
    assert found.outcome.cost == pytest.approx(least, rel=1e-4)
    free = heading({"position_m": [10, 0, 0], "attitude": "free"}, start=start)
    axis = quaternion.rotation_matrix(last(free)[6:10]) @ AXIS["body_axis"]
    assert axis @ AXIS["points_along"] > -1.0


def test_an_axis_within_a_tolerance_stops_at_its_edge() -> None:
    goal = {"position_m": [0, 0, 0], "attitude": AXIS | {"tolerance_rad": 0.4}}
    found = heading(goal)
    assert angle_of_axis(found) == pytest.approx(0.4, abs=1e-5)
    turn = 0.5 * np.pi - 0.4
    assert found.outcome.cost == pytest.approx(12.0 * 25.0 * turn**2 / DURATION_S**3, rel=1e-5)


MOVING = [
    {"position_m": [0, 4, 1]},
    {"position_m": [0, 4, 1], "attitude": [0.8, 0, 0.6, 0], "velocity_m_s": [0, -0.02, 0]},
    {"position_m": [0, 4, 1], "attitude": "free", "rate_rad_s": "free"},
    {"position_m": [0, 4, 1], "attitude": AXIS},
    {"position_m": [0, 4, 1], "attitude": [0.8, 0, 0.6, 0], "attitude_tolerance_rad": 0.1,
     "position_tolerance_m": 0.2},
]  # fmt: skip


@pytest.mark.parametrize("goal", MOVING, ids=["still", "moving", "free", "axis", "tolerant"])
def test_a_goal_moves_with_the_structure_that_it_is_given_in(goal) -> None:
    found = heading(goal | {"frame": "dock"})
    x, (_, end) = last(found), ends(found)
    tolerance = end.position_tolerance_m
    assert np.linalg.norm(x[0:3] - end.position_m) <= tolerance + MET
    error = end.attitude.error_rad(x[6:10])
    assert error <= getattr(end.attitude, "tolerance_rad", 0.0) + MET
    rate = end.rate_rad_s(x[6:10])
    if rate is not None:
        np.testing.assert_allclose(x[10:13], rate, atol=MET)
        assert np.linalg.norm(rate) > 0.01
    if tolerance == 0.0:
        np.testing.assert_allclose(x[3:6], end.velocity_m_s, atol=MET)
        assert np.linalg.norm(end.velocity_m_s) > 0.01
    # Taken for inertial it would be metres away.
    assert np.linalg.norm(x[0:3] - goal["position_m"]) > 1.0


def test_a_start_may_be_in_a_moving_frame_too() -> None:
    start = {"position_m": [0, 4, 1], "attitude": [0.8, 0, 0.6, 0], "frame": "dock"}
    found = heading({"position_m": [0, -4, 1]}, start=start)
    x, (end, _) = found.outcome.motion.states["spacecraft"][:, 0], ends(found)
    np.testing.assert_allclose(x[0:3], end.position_m, atol=MET)
    np.testing.assert_allclose(x[3:6], end.velocity_m_s, atol=MET)
    assert end.attitude.error_rad(x[6:10]) < MET
    np.testing.assert_allclose(x[10:13], end.rate_rad_s(x[6:10]), atol=MET)


def test_a_free_horizon_meets_the_frame_when_it_arrives() -> None:
    dock = structure("dock", [8, 0, 0], box(1, 1, 1), motion=SPIN)
    vehicle = spacecraft(goal={"position_m": [0, 4, 1], "frame": "dock"})
    given = scenario(
        vehicle, structures=[dock], horizon={"min_s": 60, "max_s": 300}, cost={"time": 1e-4}
    )
    found = solved(given, 3, 4, sites=[])
    assert found.outcome.solved
    assert 61.0 < found.outcome.motion.duration_s < 299.0
    _, end = ends(found)
    np.testing.assert_allclose(last(found)[0:3], end.position_m, atol=MET)
    np.testing.assert_allclose(last(found)[3:6], end.velocity_m_s, atol=MET)


def test_a_planar_goal_turns_with_its_frame() -> None:
    gate = structure("gate", [6, 0], box(0.2, 0.2), motion=SPIN | {"velocity_m_s": [0, 0.01]})
    goal = {"position_m": [0, 2], "frame": "gate", "velocity_m_s": [0.01, 0]}
    found = solved(scenario(puck(goal=goal), structures=[gate]), 3, 4)
    assert found.outcome.solved
    _, end = ends(found)
    np.testing.assert_allclose(last(found), [*end.position_m, *end.velocity_m_s], atol=MET)
    assert np.linalg.norm(end.velocity_m_s) > 0.01


def test_rows_of_ends_are_named() -> None:
    found = heading({"position_m": [0, 4, 1], "attitude": AXIS, "frame": "dock"})
    rows = found.problem.layout.rows
    names = {block.label(0) for block in rows.blocks}
    kinds = ("position", "velocity", "rate", "axis", "axis direction")
    assert {f"goal[spacecraft, {kind}]" for kind in kinds} <= names
    assert {"start[spacecraft, attitude]", "start[spacecraft, quaternion norm]"} <= names
