"""Distances agree with answers found another way: a conic solver, and many directions."""

from __future__ import annotations

from collections.abc import Callable

import clarabel
import numpy as np
import pytest
from scipy import sparse

from berthing.clearance.plane import plane_bound
from berthing.clearance.separation import PairQuery
from berthing.clearance.support_search import sphere_samples
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capability import conic_form
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose

Poses = Callable[[int, int, float], Pose]
Pair = tuple[ConvexSet, ConvexSet]
COUNT = 6
SOLVER_TOLERANCE = 2e-6
DIRECTIONS = {2: 4000, 3: 8000}
# From any direction to the nearest of those, at most, in rad.
REACH_RAD = {2: np.pi / 4000, 3: 2.0 * np.sqrt(4.0 / 8000)}


def solved_distance(pair: Pair, pose_a: Pose, pose_b: Pose) -> float:
    """min t with ‖R_B y + r_B − R_A x − r_A‖ ≤ t, x in A and y in B, variables (t, x, y)."""
    dim = pair[0].dim
    apart = np.concatenate([np.zeros((dim, 1)), -pose_a.rotation, pose_b.rotation], axis=1)
    rows = [np.concatenate([np.eye(1, 1 + 2 * dim), apart])]
    offsets = [np.append(0.0, pose_b.position - pose_a.position)]
    cones: list[object] = [clarabel.SecondOrderConeT(1 + dim)]
    for i, shape in enumerate(pair):
        form = conic_form(shape)

        def placed(A: Array, column: int = 1 + i * dim) -> Array:
            wide = np.zeros((len(A), 1 + 2 * dim))
            wide[:, column : column + dim] = A
            return wide

        if len(form.linear_b):
            rows.append(-placed(form.linear_A))
            offsets.append(form.linear_b)
            cones.append(clarabel.NonnegativeConeT(len(form.linear_b)))
        for block in form.blocks:
            rows += [np.zeros((1, 1 + 2 * dim)), placed(block.A)]
            offsets += [np.array([block.head]), block.b]
            cones.append(clarabel.SecondOrderConeT(1 + len(block.b)))
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    answer = clarabel.DefaultSolver(
        sparse.csc_matrix((1 + 2 * dim, 1 + 2 * dim)),
        np.eye(1, 1 + 2 * dim)[0],
        sparse.csc_matrix(-np.concatenate(rows)),
        np.concatenate(offsets),
        cones,
        settings,
    ).solve()
    assert answer.status == clarabel.SolverStatus.Solved
    return float(answer.obj_val)


def check_against_solver(pair: Pair, pose_a: Pose, pose_b: Pose, distance: float) -> None:
    solved = solved_distance(pair, pose_a, pose_b)
    assert max(distance, 0.0) == pytest.approx(solved, abs=SOLVER_TOLERANCE)


def check_depth(pair: Pair, pose_a: Pose, pose_b: Pose, distance: float) -> None:
    """No plane proves more than the distance, and some plane nearby proves almost as much."""
    dim, size = pair[0].dim, pair[0].bounding_radius + pair[1].bounding_radius
    n = sphere_samples(DIRECTIONS[dim], dim)
    best = float(np.max(plane_bound(pair[0], pose_a, pair[1], pose_b, n)))
    assert best <= distance + 2e-6 * size
    lever = size + float(np.linalg.norm(pose_b.position - pose_a.position))
    assert best >= distance - REACH_RAD[dim] * lever


def test_agrees_with_a_conic_solver(pair: Pair, poses: Poses) -> None:
    at_a, at_b = poses(COUNT, pair[0].dim, 3.0), poses(COUNT, pair[0].dim, 3.0)
    distance = PairQuery(*pair).batch(at_a, at_b)[0]
    for i in range(COUNT):
        check_against_solver(pair, at_a[i], at_b[i], distance[i])


def test_depth_agrees_with_many_directions(pair: Pair, poses: Poses) -> None:
    if max(part.bounding_radius for part in pair) == 0.0:
        return
    at_a, at_b = poses(COUNT, pair[0].dim, 0.6), poses(COUNT, pair[0].dim, 0.6)
    distance = PairQuery(*pair).batch(at_a, at_b)[0]
    for i in range(COUNT):
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
