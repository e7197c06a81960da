"""Brackets, independent answers and gradients of ``berthing.distance``."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.spatial import ConvexHull

from benchmarks._distance_conic import conic_distance
from benchmarks._distance_nlp import has_tip, is_smooth, nlp_distance
from benchmarks._distance_order import Repeated
from benchmarks._distance_poses import differences, random_poses
from benchmarks._distance_sets import PAIRS
from berthing.clearance.placed_distance import distance
from berthing.geometry.arrays import Array
from berthing.geometry.capability import HasVertices
from berthing.geometry.convex_set import ConvexSet, norm
from berthing.geometry.intersection import Intersection
from berthing.geometry.pose import Pose

# Of differences (m, rad), beside the usual one.
SHORT_STEP = 1e-6
# The seed of the first draw of poses for gradients; those of the next follow.
FIRST_DRAW = 5
# One-sided slopes that differ by more than this (m per m or rad) mark a kink of the distance.
KINK = 1e-2


def brackets(total: int, seed: int = 1) -> dict[str, Any]:
    """Widths of the proven brackets over all pairs of sets that the kernel takes, and whether they
    hold in another order too."""
    rng, each = np.random.default_rng(seed), -(-total // len(PAIRS))
    apart, deep, wrong, worst, repeated = [], [], 0, ("", 0.0), Repeated()
    for first, a, second, b in PAIRS:
        poses = random_poses(rng, a, b, each)
        found = distance(a, b, poses)
        repeated.ask(a, b, poses, found, seed)
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
        **repeated.as_dict(),
    }


def against_conic(total: int, seed: int = 2) -> dict[str, Any]:
    """All pairs, apart, against Clarabel, with its exponential and power cones for smooth sets."""
    return _against([(a, b) for _, a, _, b in PAIRS], conic_distance, 1e-3, total, seed)


def _against(
    pairs: list[tuple[ConvexSet, ConvexSet]],
    solve: Callable[[ConvexSet, Pose, ConvexSet, Pose], float],
    at_least_m: float,
    total: int,
    seed: int,
) -> dict[str, Any]:
    """At ``total`` or a few more poses, as many of each pair, all of them apart."""
    rng, each, errors = np.random.default_rng(seed), -(-total // len(pairs)), []
    for a, b in pairs:
        left = each
        while left > 0:
            pose_a, pose_b = random_poses(rng, a, b, 2 * left + 10)
            found = distance(a, b, (pose_a, pose_b))
            for i in np.flatnonzero(found.lower_bound > at_least_m)[:left]:
                errors.append(abs(solve(a, pose_a[i], b, pose_b[i]) - found.distance[i]))
                left -= 1
    return _errors(errors, len(pairs))


def against_nlp(total: int, seed: int = 3) -> dict[str, Any]:
    """Pairs with a superellipsoid or smoothed polytope, apart, against SciPy's SLSQP.

    Not with cones: at their tip no smooth function describes them, and SLSQP gets stuck there.
    """
    pairs = [
        (a, b)
        for _, a, _, b in PAIRS
        if (is_smooth(a) or is_smooth(b)) and not (has_tip(a) or has_tip(b))
    ]
    return _against(pairs, nlp_distance, 1e-2, total, seed)


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


def gradients(total: int, of_intersections: bool, draws: int) -> dict[str, Any]:
    """Against central differences of fourth order, in several draws of ``total`` poses or a few
    more; the better one of two steps, for the longer one is too long for points a tenth of a
    millimetre apart. A wrong gradient would match neither. Poses at a kink are counted apart, as
    are pairs with an intersection."""
    pairs = [
        pair for pair in PAIRS
        if of_intersections == any(isinstance(pair[k], Intersection) for k in (1, 3))
    ]  # fmt: skip
    each, errors, kinks, worst = -(-total // len(pairs)), [], 0, ("", 0.0)
    for seed in range(FIRST_DRAW, FIRST_DRAW + draws):
        rng = np.random.default_rng(seed)
        for first, a, second, b in pairs:
            relative, bend = gradient_errors(a, b, random_poses(rng, a, b, each))
            smooth = bend < KINK
            kinks += int(np.sum(~smooth))
            errors.append(relative[smooth])
            if smooth.any() and np.max(relative[smooth]) > worst[1]:
                worst = (f"{first} – {second}", float(np.max(relative[smooth])))
    all_errors = np.concatenate(errors)
    return {
        "draws": draws,
        "poses": len(all_errors),
        "pairs": len(pairs),
        "at_kinks": kinks,
        "largest_relative_error": worst[1],
        "of_the_pair": worst[0],
        "above_1e-5": int(np.sum(all_errors > 1e-5)),
        "above_1e-6": int(np.sum(all_errors > 1e-6)),
    }


def gradient_errors(a: ConvexSet, b: ConvexSet, poses: tuple[Pose, Pose]) -> tuple[Array, Array]:
    """Of each pose, in terms of the gradient's length, or of 1 if that is shorter; and how much the
    slopes to both sides differ."""
    found = distance(a, b, poses)
    given = np.concatenate([found.gradient_a, found.gradient_b], axis=-1)
    usual, bend = differences(a, poses[0], b, poses[1])
    near = differences(a, poses[0], b, poses[1], SHORT_STEP)[0]
    off = np.minimum(norm(given - usual), norm(given - near))
    return np.asarray(off / np.maximum(norm(given), 1.0)), bend
