"""Ends are met as sets, in whatever frame they are given."""

from dataclasses import replace

import numpy as np
import pytest

from berthing.geometry import quaternion
from berthing.geometry.box import Box
from berthing.geometry.pose import Pose
from berthing.scenario.attitude import AxisAttitude, FixedAttitude, FreeAttitude
from berthing.scenario.goal import End
from berthing.scenario.motion import ConstantSpin
from berthing.trajectory import PhaseTrajectory
from berthing.verify.boundary import end_errors

CUBE = Box(np.ones(3))
QUARTER = np.array([np.sqrt(0.5), 0, 0, np.sqrt(0.5)])


def goal_error(make, goal: End, *structures, position=(3, 1, 0), turn=np.pi / 2):
    own = make.vehicle(CUBE, goal=goal)
    whole = make.scenario([own], structures)
    flown = make.glide(own, (0, 0, 0), position, turn)
    start, end = end_errors(whole, whole.phases[0], PhaseTrajectory("main", (flown,)))
    assert start.reasons == []
    return end


def test_met_and_missed(make) -> None:
    goal = End(np.array([3.0, 1, 0]), 0.0, FixedAttitude(QUARTER), np.zeros(3), np.zeros(3))
    assert goal_error(make, goal).reasons == []
    assert goal_error(make, replace(goal, attitude=FixedAttitude(-QUARTER))).reasons == []
    off = goal_error(make, replace(goal, position_m=np.array([3.0, 1, 2e-6])))
    assert off.position_m == pytest.approx(2e-6)
    assert "position" in off.reasons[0]
    assert goal_error(make, replace(goal, position_m=np.array([3.0, 1, 5e-7]))).reasons == []
    assert "velocity" in goal_error(make, replace(goal, velocity_m_s=np.full(3, 1e-5))).reasons[0]
    assert "rate" in goal_error(make, replace(goal, rate_rad_s=np.full(3, 1e-5))).reasons[0]
    turned = goal_error(make, replace(goal, attitude=FixedAttitude(np.array([1.0, 0, 0, 0]))))
    assert turned.attitude_rad == pytest.approx(np.pi / 2)
    assert "attitude" in turned.reasons[0]


def test_tolerances_and_freedom(make) -> None:
    wide = End(np.array([3.0, 1, 0.05]), 0.06, FixedAttitude(np.array([1.0, 0, 0, 0]), 1.6))
    assert goal_error(make, wide).reasons == []
    assert goal_error(make, replace(wide, position_tolerance_m=0.04)).position_m == pytest.approx(
        0.01
    )
    narrow = replace(wide, attitude=FixedAttitude(np.array([1.0, 0, 0, 0]), 1.5))
    assert goal_error(make, narrow).attitude_rad == pytest.approx(np.pi / 2 - 1.5)
    assert goal_error(make, replace(wide, attitude=FreeAttitude())).reasons == []
    axis = AxisAttitude(np.array([1.0, 0, 0]), np.array([0.0, 1, 0]))
    assert goal_error(make, replace(wide, attitude=axis)).reasons == []
    other = AxisAttitude(np.array([1.0, 0, 0]), np.array([0.0, 0, 1]))
    assert goal_error(make, replace(wide, attitude=other)).attitude_rad == pytest.approx(np.pi / 2)


def test_in_the_frame_of_a_structure_that_turns(make) -> None:
    """At t = 10 s the hub has turned by 90°: the goal moves with it."""
    rate = np.pi / 20
    hub = make.structure(
        CUBE, motion=ConstantSpin(Pose.identity(), np.array([0, 0, 1.0]), rate, np.zeros(3))
    )
    goal = End(
        np.array([3.0, 0, 0]), 0.0, FixedAttitude(np.array([1.0, 0, 0, 0])), None, None, "wall"
    )
    assert goal_error(make, goal, hub, position=(0, 3, 0)).reasons == []
    assert goal_error(make, goal, hub, position=(3, 0, 0)).position_m == pytest.approx(np.sqrt(18))
    still = replace(goal, velocity_m_s=np.zeros(3), rate_rad_s=np.zeros(3))
    missed = goal_error(make, still, hub, position=(0, 3, 0))
    assert missed.velocity_m_s == pytest.approx(3.0 * rate)
    assert missed.rate_rad_s == pytest.approx(rate)


def test_the_start_is_checked_too(make) -> None:
    own = make.vehicle(CUBE, start=End(np.array([0.0, 0, 0.01])), goal=End(np.array([3.0, 0, 0])))
    whole = make.scenario([own], [])
    flown = PhaseTrajectory("main", (make.glide(own, (0, 0, 0), (3, 0, 0)),))
    start, goal = end_errors(whole, whole.phases[0], flown)
    assert "start[craft, position, t = 0 s] is missed by 0.01 m" in start.reasons
    assert goal.reasons == []
    assert quaternion.angle_between(np.array([1.0, 0, 0, 0]), QUARTER) == pytest.approx(np.pi / 2)
