"""Starts and goals in collision are refused, with the pair and the distance."""

from dataclasses import replace

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry.box import Box
from berthing.geometry.pose import Pose
from berthing.scenario.attitude import FixedAttitude, FreeAttitude
from berthing.scenario.goal import End
from berthing.scenario.horizon import Horizon
from berthing.scenario.margin import MarginOverride, MarginPolicy
from berthing.scenario.motion import ConstantVelocity
from berthing.verify.endpoints import check_endpoints

CUBE = Box(np.ones(3))


def case(make, start=(0, 0, 0), goal=(10, 0, 0), margins=0.1, motion=None, **of_goal):
    own = make.vehicle(
        CUBE, start=End(np.array(start, float)), goal=End(np.array(goal, float), **of_goal)
    )
    at = [make.placed([5, 0, 0])] if motion is None else ()
    return make.scenario([own], [make.structure(CUBE, at=at, motion=motion)], margins)


def refusal(whole) -> str:
    with pytest.raises(InputError) as caught:
        check_endpoints(whole)
    return str(caught.value)


def test_clear_ends_pass(make) -> None:
    check_endpoints(case(make))
    check_endpoints(case(make, start=(2.9, 0, 0)))


def test_a_start_too_close(make) -> None:
    message = refusal(case(make, start=(2.95, 0, 0)))
    assert message.startswith("craft.start: craft.p0 is too close to wall.p0")
    assert "0.05 m" in message
    assert "0.1 m" in message


def test_a_goal_inside(make) -> None:
    message = refusal(case(make, goal=(5, 0.5, 0)))
    assert message.startswith("craft.goal: craft.p0 overlaps wall.p0")
    assert "-1.5 m" in message


def test_contact_allowed_at_the_goal_only(make) -> None:
    late = MarginPolicy(0.1, (MarginOverride("craft", "wall", None, (8.0, 10.0)),))
    check_endpoints(case(make, goal=(7, 0, 0), margins=late))
    assert "craft.start" in refusal(case(make, start=(3, 0, 0), margins=late))


def test_a_goal_set_is_judged_by_its_best_member(make) -> None:
    check_endpoints(case(make, goal=(7.05, 0, 0), position_tolerance_m=0.06))
    assert "craft.goal" in refusal(case(make, goal=(7.05, 0, 0), position_tolerance_m=0.04))
    check_endpoints(case(make, goal=(7.05, 0, 0), attitude=FreeAttitude()))
    little = FixedAttitude(np.array([1.0, 0, 0, 0]), 0.001)
    assert "craft.goal" in refusal(case(make, goal=(7.05, 0, 0), attitude=little))
    much = FixedAttitude(np.array([1.0, 0, 0, 0]), 0.1)
    check_endpoints(case(make, goal=(7.05, 0, 0), attitude=much))


def test_structures_that_move(make) -> None:
    """It comes from x = −10 at 1 m/s: at the goal's place at t = 10 s, and away at the start."""
    motion = ConstantVelocity(Pose(np.array([-10.0, 0, 0]), np.eye(3)), np.array([1.0, 0, 0]))
    check_endpoints(case(make, motion=motion))
    assert "craft.goal" in refusal(case(make, start=(5, 0, 0), goal=(1, 0, 0), motion=motion))
    unknown = case(make, start=(5, 0, 0), goal=(1, 0, 0), motion=motion)
    unknown = replace(unknown, phases=(replace(unknown.phases[0], horizon=Horizon(1.0, 20.0)),))
    check_endpoints(unknown)
    riding = case(make, start=(5, 0, 0), goal=(1, 0, 0), motion=motion, frame="wall")
    riding = replace(riding, phases=(replace(riding.phases[0], horizon=Horizon(1.0, 20.0)),))
    assert "craft.goal" in refusal(riding)


def test_two_vehicles(make) -> None:
    def craft(name, start, goal):
        return make.vehicle(
            CUBE, name=name, start=End(np.array(start, float)), goal=End(np.array(goal, float))
        )

    a = craft("a", (0, 0, 0), (10, 0, 0))
    check_endpoints(make.scenario([a, craft("b", (0, 3, 0), (10, 3, 0))], []))
    message = refusal(make.scenario([a, craft("b", (0, 3, 0), (10, 2, 0))], []))
    assert message.startswith("a.goal: a.p0 is too close to b.p0")
