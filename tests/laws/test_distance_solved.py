"""Distances agree with answers found another way: a conic solver, and many directions."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import clarabel
import numpy as np
import pytest
from scipy.optimize import minimize

from berthing.clearance.plane import plane_bound
from berthing.clearance.separation import PairQuery
from berthing.clearance.support_search import sphere_samples
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capability import HasSmoothLevel, conic_form, level
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from support.cones import cone_rows, solved
from support.shapes import has_conic_form

Poses = Callable[[int, int, float], Pose]
Pair = tuple[ConvexSet, ConvexSet]
SOLVER_TOLERANCE = 2e-6
DIRECTIONS = {2: 4000, 3: 8000}
# From any direction to the nearest of those, at most, in rad.
REACH_RAD = {2: np.pi / 4000, 3: 2.0 * np.sqrt(4.0 / 8000)}


def solved_distance(pair: Pair, pose_a: Pose, pose_b: Pose) -> float:
    """min |R_B y + r_B − R_A x − r_A|, x in A and y in B; by cones where both have a form."""
    if all(has_conic_form(shape) for shape in pair):
        return _by_cones(pair, pose_a, pose_b)
    return _by_descent(pair, pose_a, pose_b)


def _by_cones(pair: Pair, pose_a: Pose, pose_b: Pose) -> float:
    """Variables: t, then those of A's form, then of B's."""
    dim, forms = pair[0].dim, [conic_form(shape) for shape in pair]
    columns, first_b = 1 + forms[0].size + forms[1].size, 1 + forms[0].size
    apart = np.zeros((1 + dim, columns))
    apart[0, 0] = 1.0
    apart[1:, 1 : 1 + dim] = -pose_a.rotation
    apart[1:, first_b : first_b + dim] = pose_b.rotation
    rows, offsets = [apart], [np.append(0.0, pose_b.position - pose_a.position)]
    cones: list[Any] = [clarabel.SecondOrderConeT(1 + dim)]
    for form, first in zip(forms, (1, first_b), strict=True):
        own_rows, own_offsets, own_cones = cone_rows(form, columns, first)
        rows.append(own_rows)
        offsets.append(own_offsets)
        cones += own_cones
    return solved(np.eye(1, columns)[0], np.concatenate(rows), np.concatenate(offsets), cones)


def _by_descent(pair: Pair, pose_a: Pose, pose_b: Pose) -> float:
    """Sequential quadratic programming on smooth inequalities, from between the centres."""
    dim = pair[0].dim
    shift = pose_a.unrotate(pose_b.position - pose_a.position)
    turn = pose_a.rotation.T @ pose_b.rotation
    sides = [_inequalities(shape) for shape in pair]
    size_a = sides[0].size

    def squared(z: Array) -> float:
        across = shift + turn @ z[size_a : size_a + dim] - z[:dim]
        return float(across @ across)

    found = minimize(
        squared,
        np.concatenate([0.5 * side.start for side in sides]),
        method="SLSQP",
        constraints=[
            {"type": "ineq", "fun": lambda z: sides[0].spare(z[:size_a])},
            {"type": "ineq", "fun": lambda z: sides[1].spare(z[size_a:])},
        ],
        options={"ftol": 1e-14, "maxiter": 200},
    )
    return float(np.sqrt(found.fun))


@dataclass(frozen=True)
class _Side:
    """A set as smooth functions that are ≥ 0 inside, of ``size`` variables, the point first."""

    size: int
    start: Array
    spare: Callable[[Array], Array]


def _inequalities(shape: ConvexSet) -> _Side:
    centre = shape.support(np.concatenate([np.eye(shape.dim), -np.eye(shape.dim)]))[1].mean(axis=0)
    if isinstance(shape, HasSmoothLevel) and not has_conic_form(shape):
        return _Side(shape.dim, centre, lambda x: np.atleast_1d(-level(shape, x)))
    form = conic_form(shape)

    def spare(z: Array) -> Array:
        rows = [form.linear_b - form.linear_A @ z]
        for block in form.blocks:
            head = block.head if block.slope is None else block.head + block.slope @ z
            inner = block.A @ z + block.b
            rows.append(np.array([head**2 - inner @ inner, head]))
        return np.concatenate(rows)

    return _Side(form.size, np.concatenate([centre, np.zeros(form.lift)]), spare)


def check_against_solver(pair: Pair, pose_a: Pose, pose_b: Pose, distance: float) -> None:
    solved = solved_distance(pair, pose_a, pose_b)
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
