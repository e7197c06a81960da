"""Brackets, independent answers and gradients of ``berthing.distance``."""

from __future__ import annotations

from typing import Any

import clarabel
import numpy as np
from scipy import sparse
from scipy.optimize import minimize
from scipy.spatial import ConvexHull

from benchmarks._distance_poses import differences, random_poses
from benchmarks._distance_sets import PAIRS
from berthing.clearance.placed_distance import distance
from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.capability import HasVertices, conic_form
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.convex_set import ConvexSet, norm
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.pose import Pose
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.superellipsoid import Superellipsoid

# One-sided slopes that differ by more than this (m per m or rad) mark a kink of the distance.
KINK = 1e-2


def brackets(total: int, seed: int = 1) -> dict[str, Any]:
    """Widths of the proven brackets over all pairs of sets that the kernel takes."""
    rng, each = np.random.default_rng(seed), -(-total // len(PAIRS))
    apart, deep, wrong, worst = [], [], 0, ("", 0.0)
    for first, a, second, b in PAIRS:
        found = distance(a, b, random_poses(rng, a, b, each))
        width = found.upper_bound - found.lower_bound
        rounding = 1e-12 * (1.0 + a.bounding_radius + min(b.bounding_radius, 1.0))
        wrong += int(np.sum(~np.isfinite(found.distance) | (width < -rounding)))
        outside = found.lower_bound > 0.0
        apart.append(width[outside])
        deep.append(width[~outside])
        if outside.any() and np.max(width[outside]) > worst[1]:
            worst = (f"{first} – {second}", float(np.max(width[outside])))
    a_width, d_width = np.concatenate(apart), np.concatenate(deep)
    return {
        "poses": each * len(PAIRS),
        "pairs": len(PAIRS),
        "apart": len(a_width),
        "apart_widest_m": float(np.max(a_width)),
        "apart_widest_pair": worst[0],
        "apart_share_above_1e-8": float(np.mean(a_width > 1e-8)),
        "apart_99.9_percent_m": float(np.quantile(a_width, 0.999)),
        "overlapping": len(d_width),
        "overlapping_widest_m": float(np.max(d_width)),
        "not_finite_or_crossed": wrong,
    }


def against_conic(total: int, seed: int = 2) -> dict[str, Any]:
    """Pairs with conic forms, apart, against Clarabel."""
    pairs = [(a, b) for _, a, _, b in PAIRS if _is_conic(a) and _is_conic(b)]
    rng, each, errors = np.random.default_rng(seed), -(-total // len(pairs)), []
    for a, b in pairs:
        pose_a, pose_b = random_poses(rng, a, b, 2 * each)
        found = distance(a, b, (pose_a, pose_b))
        for i in np.flatnonzero(found.lower_bound > 1e-3)[:each]:
            errors.append(abs(conic_distance(a, pose_a[i], b, pose_b[i]) - found.distance[i]))
    return _errors(errors, len(pairs))


def _is_conic(shape: ConvexSet) -> bool:
    try:
        return shape.bounding_radius > 0.0 and conic_form(shape) is not None
    except CapabilityError:
        return False


def conic_distance(a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose) -> float:
    """min τ, ‖p_b − p_a‖ ≤ τ, over both conic forms, by an interior-point solver of others."""
    fa, fb, d = conic_form(a), conic_form(b), a.dim
    size = fa.size + fb.size + 1
    rows, right, cones = [], [], []
    for form, start in ((fa, 0), (fb, fa.size)):
        _rows_of(form, start, size, rows, right, cones)
    across = np.zeros((d + 1, size))
    across[0, -1] = -1.0
    across[1:, :d] = pose_a.rotation
    across[1:, fa.size : fa.size + d] = -pose_b.rotation
    rows.append(across)
    right.append(np.concatenate([[0.0], pose_b.position - pose_a.position]))
    cones.append(clarabel.SecondOrderConeT(d + 1))
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    settings.tol_gap_abs = settings.tol_gap_rel = settings.tol_feas = 1e-11
    q = np.zeros(size)
    q[-1] = 1.0
    matrix = sparse.csc_matrix(np.vstack(rows))
    zero = sparse.csc_matrix((size, size))
    solver = clarabel.DefaultSolver(zero, q, matrix, np.concatenate(right), cones, settings)
    return float(solver.solve().x[-1])


def _rows_of(
    form: ConicForm, start: int, size: int, rows: list[Array], right: list[Array], cones: list[Any]
) -> None:
    """As G z + s = h, s in the cones."""
    own = slice(start, start + form.size)
    if len(form.linear_b):
        lines = np.zeros((len(form.linear_b), size))
        lines[:, own] = form.linear_A
        rows.append(lines)
        right.append(form.linear_b)
        cones.append(clarabel.NonnegativeConeT(len(form.linear_b)))
    for block in form.blocks:
        cone = np.zeros((len(block.b) + 1, size))
        cone[0, own] = 0.0 if block.slope is None else -block.slope
        cone[1:, own] = -block.A
        rows.append(cone)
        right.append(np.concatenate([[block.head], block.b]))
        cones.append(clarabel.SecondOrderConeT(len(block.b) + 1))


def against_nlp(total: int, seed: int = 3) -> dict[str, Any]:
    """Smooth pairs, apart, against SciPy's SLSQP on closest points."""
    smooth = SmoothedPolytope | Superellipsoid
    pairs = [(a, b) for _, a, _, b in PAIRS if isinstance(a, smooth) and isinstance(b, smooth)]
    rng, each, errors = np.random.default_rng(seed), -(-total // len(pairs)), []
    for a, b in pairs:
        pose_a, pose_b = random_poses(rng, a, b, 3 * each)
        found = distance(a, b, (pose_a, pose_b))
        for i in np.flatnonzero(found.lower_bound > 1e-2)[:each]:
            errors.append(abs(nlp_distance(a, pose_a[i], b, pose_b[i]) - found.distance[i]))
    return _errors(errors, len(pairs))


def nlp_distance(a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose) -> float:
    """min ‖p_b − p_a‖² with level functions as constraints, from both centres; the best of a few
    restarts, each from where the last one ended."""
    d = a.dim

    def gap(z: Array) -> Array:
        return np.asarray(pose_b.apply(z[d:]) - pose_a.apply(z[:d]))

    def slope(z: Array) -> Array:
        e = gap(z)
        return np.concatenate([-2.0 * pose_a.unrotate(e), 2.0 * pose_b.unrotate(e)])

    none = np.zeros(d)
    constraints = [
        {
            "type": "ineq",
            "fun": lambda z: -float(a.level(z[:d])),
            "jac": lambda z: -np.concatenate([a.level_gradient(z[:d]), none]),
        },
        {
            "type": "ineq",
            "fun": lambda z: -float(b.level(z[d:])),
            "jac": lambda z: -np.concatenate([none, b.level_gradient(z[d:])]),
        },
    ]
    z = np.concatenate([getattr(s, "centre", none) for s in (a, b)])
    for _ in range(4):
        z = minimize(
            lambda z: float(gap(z) @ gap(z)), z, jac=slope, constraints=constraints,
            method="SLSQP", options={"ftol": 1e-16, "maxiter": 300},
        ).x  # fmt: skip
    return float(norm(gap(z)))


def against_hulls(total: int, seed: int = 4) -> dict[str, Any]:
    """Depths of polytopes against the hull of all differences of their vertices (SciPy, Qhull)."""
    pairs = [(a, b) for _, a, _, b in PAIRS if _has_corners(a) and _has_corners(b)]
    rng, each, errors = np.random.default_rng(seed), -(-total // len(pairs)), []
    for a, b in pairs:
        pose_a, pose_b = random_poses(rng, a, b, 4 * each)
        found = distance(a, b, (pose_a, pose_b))
        for i in np.flatnonzero(found.distance < 0.0)[:each]:
            first, second = pose_a[i].apply(a.vertices()), pose_b[i].apply(b.vertices())
            sums = (second[:, None] - first[None]).reshape(-1, a.dim)
            errors.append(abs(np.max(ConvexHull(sums).equations[:, -1]) - found.distance[i]))
    return _errors(errors, len(pairs))


def _has_corners(shape: ConvexSet) -> bool:
    return isinstance(shape, HasVertices)


def _errors(errors: list[float], pairs: int) -> dict[str, Any]:
    worst = np.array(errors)
    return {
        "poses": len(worst),
        "pairs": pairs,
        "largest_difference_m": float(np.max(worst)),
        "above_1e-7": int(np.sum(worst > 1e-7)),
    }


def gradients(total: int, seed: int = 5) -> dict[str, Any]:
    """Against central differences of fourth order; poses at a kink are counted apart."""
    pairs = [p for p in PAIRS if not isinstance(p[3], HalfSpace) and p[0] != "point"]
    rng, each, errors, kinks = np.random.default_rng(seed), -(-total // len(pairs)), [], 0
    for _, a, _, b in pairs:
        poses = random_poses(rng, a, b, each)
        found = distance(a, b, poses)
        given = np.concatenate([found.gradient_a, found.gradient_b], axis=-1)
        expected, bend = differences(a, poses[0], b, poses[1])
        smooth = bend < KINK
        kinks += int(np.sum(~smooth))
        relative = norm(given - expected) / np.maximum(norm(given), 1.0)
        errors.append(relative[smooth])
    all_errors = np.concatenate(errors)
    return {
        "poses": len(all_errors),
        "pairs": len(pairs),
        "at_kinks": kinks,
        "largest_relative_error": float(np.max(all_errors)),
        "above_1e-5": int(np.sum(all_errors > 1e-5)),
    }
