"""The tube holds every point of a part that is off by no more than it says, and is no wider."""

from __future__ import annotations

import math

import numpy as np
import pytest

from berthing.geometry import quaternion
from berthing.geometry.body import Part
from berthing.geometry.box import Box
from berthing.geometry.pose import Pose
from berthing.scenario.pair import Pair
from berthing.verify.replay import Replay
from berthing.verify.settings import INTEGRATOR_ATTITUDE_RAD, INTEGRATOR_POSITION_M
from berthing.verify.tube import EXACT, Tube, pair_tube, tube_of, tubes_of

HALF = np.array([2.0, 1.0, 0.5])


@pytest.mark.parametrize("angle", [1e-4, 0.3, 2.0, math.pi])
def test_no_point_leaves_it(make, angle: float) -> None:
    rng = np.random.default_rng(4)
    part = Part("hull", Box(HALF), make.placed([3.0, 0.0, 1.0]))
    tube = Tube(0.01, angle)
    corners = part.placement.apply(HALF * np.array(np.meshgrid(*[[-1, 1]] * 3)).reshape(3, -1).T)
    reached = 0.0
    for _ in range(200):
        axis, shift = rng.normal(size=3), rng.normal(size=3)
        turn = quaternion.rotation_matrix(quaternion.from_axis_angle(axis, angle))
        moved = Pose(0.01 * shift / np.linalg.norm(shift), turn).apply(corners)
        reached = max(reached, float(np.max(np.linalg.norm(moved - corners, axis=1))))
    assert reached <= tube.around(part) + 1e-12
    # The allowance is that of a ball about the part: not twice what a point can need.
    assert tube.around(part) < 2.0 * reached


def test_what_does_not_turn_needs_its_position_only(make) -> None:
    part = Part("hull", Box(HALF), make.placed([100.0, 0.0, 0.0]))
    assert Tube(0.02, 0.0).around(part) == 0.02
    assert EXACT.around(part) == 0.0
    assert Tube(0.02, 1e-9).around(part) > 0.02


def replay(position: float, attitude: float) -> Replay:
    return Replay("craft", position, attitude, 0.0, 0.0, 0.0, 0.0, 0.0)


def test_the_integrators_own_error_is_allowed_for() -> None:
    found = tubes_of([replay(1e-5, 1e-6)])["craft"]
    assert found == Tube(1e-5 + INTEGRATOR_POSITION_M, 1e-6 + INTEGRATOR_ATTITUDE_RAD)
    assert tube_of(replay(1e-5, 0.0)).attitude_rad == 0.0
    # A replay that failed has no tube that anything would fit in.
    assert tube_of(replay(math.inf, math.inf)).position_m == math.inf


def test_both_bodies_of_a_pair_count(make) -> None:
    one, other = make.vehicle(Box(HALF), name="one"), make.vehicle(Box(HALF), name="other")
    wall = make.structure(Box(HALF))
    tubes = {"one": Tube(1e-3, 0.0), "other": Tube(2e-3, 0.0)}
    a, b, c = one.body.parts[0], other.body.parts[0], wall.body.parts[0]
    assert pair_tube(Pair(one, a, other, b), tubes) == pytest.approx(3e-3)
    assert pair_tube(Pair(one, a, wall, c), tubes) == pytest.approx(1e-3)
    assert pair_tube(Pair(one, a, wall, c), {}) == 0.0
