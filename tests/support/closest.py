"""Closest points of two sets, found by solvers that the package does not use."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import clarabel
import numpy as np
from scipy.optimize import minimize

from berthing.geometry.arrays import Array
from berthing.geometry.capability import HasSmoothLevel, conic_form, level
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from support.cones import cone_rows, solution
from support.shapes import has_conic_form

Pair = tuple[ConvexSet, ConvexSet]


def solved_points(pair: Pair, pose_a: Pose, pose_b: Pose) -> tuple[Array, Array]:
    """The points x of A and y of B, in the world, that are nearest to each other.

    By a conic solver where both have a conic form, and by sequential quadratic programming where
    one has not.
    """
    solve = _by_cones if all(has_conic_form(shape) for shape in pair) else _by_descent
    x, y = solve(pair, pose_a, pose_b)
    return pose_a.apply(x), pose_b.apply(y)


def _by_cones(pair: Pair, pose_a: Pose, pose_b: Pose) -> tuple[Array, Array]:
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
    cost = np.eye(1, columns)[0]
    _, z = solution(cost, np.concatenate(rows), np.concatenate(offsets), cones)
    return z[1 : 1 + dim], z[first_b : first_b + dim]


def _by_descent(pair: Pair, pose_a: Pose, pose_b: Pose) -> tuple[Array, Array]:
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
    return found.x[:dim], found.x[size_a : size_a + dim]


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
