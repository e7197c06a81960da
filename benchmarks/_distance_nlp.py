"""The distance as a nonlinear program in closest points, for a solver of others (SciPy's SLSQP)."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.optimize import minimize

from berthing.geometry.arrays import Array
from berthing.geometry.capability import conic_form
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.convex_set import ConvexSet, norm
from berthing.geometry.pose import Pose
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.superellipsoid import Superellipsoid

MOST_RESTARTS, MOST_STARTS = 6, 4
# Of the starts beside the centres, in terms of the bounding radius.
BESIDE = 0.1
# Metres: answers that agree; rows of points that are taken for members.
AGREED, MEMBER = 1e-9, 1e-9
# Metres: a restart that gains less ends the search.
GAIN = 1e-13


def nlp_distance(a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose) -> float:
    """min ‖p_b − p_a‖², from both centres and from beside them until two answers agree.

    The least of them: each is the distance of two members, and the solver stops short at times,
    where squared cones have no slope.
    """
    d, cut, total = a.dim, size_of(a), size_of(a) + size_of(b)
    rng, found = np.random.default_rng(0), [np.inf]
    for attempt in range(MOST_STARTS):
        z = np.zeros(total)
        for shape, at in ((a, 0), (b, cut)):
            beside = attempt * BESIDE * shape.bounding_radius * rng.normal(size=d)
            z[at : at + d] = _middle(shape) + (beside if np.all(np.isfinite(beside)) else 0.0)
        length = _solved(a, pose_a, b, pose_b, z)
        if abs(length - min(found)) < AGREED:
            return min(length, *found)
        found.append(length)
    return min(found)


def _solved(a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose, z: Array) -> float:
    """From z, restarted from where the last run ended; infinity for points that are no members."""
    d, cut, total = a.dim, size_of(a), len(z)

    def gap(z: Array) -> Array:
        return np.asarray(pose_b.apply(z[cut : cut + d]) - pose_a.apply(z[:d]))

    def slope(z: Array) -> Array:
        e, full = gap(z), np.zeros(total)
        full[:d], full[cut : cut + d] = -2.0 * pose_a.unrotate(e), 2.0 * pose_b.unrotate(e)
        return full

    constraints = [*_inside(a, slice(0, cut), total), *_inside(b, slice(cut, total), total)]
    best = np.inf
    for _ in range(MOST_RESTARTS):
        z = minimize(
            lambda z: float(gap(z) @ gap(z)), z, jac=slope, constraints=constraints,
            method="SLSQP", options={"ftol": 1e-16, "maxiter": 300},
        ).x  # fmt: skip
        length = float(norm(gap(z)))
        if abs(best - length) < GAIN:
            break
        best = length
    outside = max(
        float(np.max(np.abs(c["fun"](z)) if c["type"] == "eq" else -c["fun"](z)))
        for c in constraints
    )
    return length if outside < MEMBER else np.inf


def size_of(shape: ConvexSet) -> int:
    """Variables: the point, and the helping ones of a conic form; a point's are fixed."""
    return shape.dim if shape.bounding_radius == 0.0 or is_smooth(shape) else conic_form(shape).size


def is_smooth(shape: ConvexSet) -> bool:
    """Whether its level is to be used, for want of a conic form or to have another way."""
    return isinstance(shape, SmoothedPolytope | Superellipsoid)


def has_tip(shape: ConvexSet) -> bool:
    """Whether a block of the set's conic form slopes."""
    if is_smooth(shape) or shape.bounding_radius == 0.0:
        return False
    return any(block.slope is not None for block in conic_form(shape).blocks)


def _middle(shape: ConvexSet) -> Array:
    return np.asarray(getattr(shape, "centre", np.zeros(shape.dim)))


def _inside(shape: ConvexSet, own: slice, total: int) -> list[dict[str, Any]]:
    """Membership as functions ≥ 0 of all variables, those of the set at ``own``."""
    if shape.bounding_radius == 0.0:
        return [_constraint("eq", lambda x: x, lambda x: np.eye(shape.dim), own, total)]
    if is_smooth(shape):
        return [
            _constraint(
                "ineq",
                lambda x: -np.atleast_1d(shape.level(x)),
                lambda x: -np.atleast_2d(shape.level_gradient(x)),
                own,
                total,
            )
        ]
    form = conic_form(shape)
    return [_constraint("ineq", *_rows(form), own, total)]


def _rows(form: ConicForm) -> tuple[Any, Any]:
    """Lines as they are; cones as squares."""

    def value(z: Array) -> Array:
        rows = [form.linear_b - form.linear_A @ z]
        for block in form.blocks:
            rest = block.A @ z + block.b
            rows.append(np.array([block.head * block.head - rest @ rest]))
        return np.concatenate(rows)

    def slope(z: Array) -> Array:
        rows = [-form.linear_A]
        for block in form.blocks:
            rows.append(-2.0 * ((block.A @ z + block.b) @ block.A)[None])
        return np.concatenate(rows)

    return value, slope


def _constraint(kind: str, value: Any, slope: Any, own: slice, total: int) -> dict[str, Any]:
    def spread(z: Array) -> Array:
        rows = slope(z[own])
        wide = np.zeros((len(rows), total))
        wide[:, own] = rows
        return wide

    return {"type": kind, "fun": lambda z: value(z[own]), "jac": spread}
