"""Distances agree with answers found another way: a conic solver, and many directions."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from berthing.clearance.plane import plane_bound
from berthing.clearance.separation import PairQuery
from berthing.clearance.support_search import sphere_samples
from berthing.geometry.box import Box
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from support.closest import solved_points

Poses = Callable[[int, int, float], Pose]
Pair = tuple[ConvexSet, ConvexSet]
SOLVER_TOLERANCE = 2e-6
DIRECTIONS = {2: 4000, 3: 8000}
# From any direction to the nearest of those, at most, in rad.
REACH_RAD = {2: np.pi / 4000, 3: 2.0 * np.sqrt(4.0 / 8000)}


def check_against_solver(pair: Pair, pose_a: Pose, pose_b: Pose, distance: float) -> None:
    solved = float(np.linalg.norm(np.subtract(*solved_points(pair, pose_a, pose_b))))
    assert max(distance, 0.0) == pytest.approx(solved, abs=SOLVER_TOLERANCE)


def check_depth(pair: Pair, pose_a: Pose, pose_b: Pose, distance: float) -> None:
    """No plane proves more than the distance, and some plane nearby proves almost as much."""
    dim, sizes = pair[0].dim, pair[0].bounding_radius + pair[1].bounding_radius
    n = sphere_samples(DIRECTIONS[dim], dim)
    best = float(np.max(plane_bound(pair[0], pose_a, pair[1], pose_b, n)))
    assert best <= distance + 2e-6 * sizes
    lever = sizes + float(np.linalg.norm(pose_b.position - pose_a.position))
    assert best >= distance - REACH_RAD[dim] * lever


def test_agrees_with_another_solver(pair: Pair, poses: Poses, count: int) -> None:
    at_a, at_b = poses(count, pair[0].dim, 3.0), poses(count, pair[0].dim, 3.0)
    distance = PairQuery(*pair).batch(at_a, at_b)[0]
    for i in range(count):
        check_against_solver(pair, at_a[i], at_b[i], distance[i])


def test_depth_agrees_with_many_directions(pair: Pair, poses: Poses, count: int) -> None:
    # Two points have no depth, and one plane alone separates from a half-space.
    if not 0.0 < max(part.bounding_radius for part in pair) < np.inf:
        return
    at_a, at_b = poses(count, pair[0].dim, 0.6), poses(count, pair[0].dim, 0.6)
    distance = PairQuery(*pair).batch(at_a, at_b)[0]
    for i in range(count):
        check_depth(pair, at_a[i], at_b[i], distance[i])


def test_the_checks_notice_a_wrong_distance() -> None:
    pair = (Box([1.0, 1.0, 1.0]), Box([1.0, 1.0, 1.0]))
    here = Pose.identity()
    near, over = (Pose(np.array([x, 0.2, 0.1]), np.eye(3)) for x in (2.5, 1.5))
    check_against_solver(pair, here, near, 0.5)
    check_depth(pair, here, over, -0.5)
    with pytest.raises(AssertionError):
        check_against_solver(pair, here, near, 0.5001)
    with pytest.raises(AssertionError):
        check_depth(pair, here, over, -0.6)
    with pytest.raises(AssertionError):
        check_depth(pair, here, over, -0.2)
