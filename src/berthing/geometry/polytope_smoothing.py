"""How far a smoothed polytope is from the polytope, proven; and exponents for an error allowed.

P is the polytope, S the smoothed set. The Hausdorff distance is the larger of sup over x in P of
the distance to S, and the reverse.

Inner, S ⊂ P: the distance to a convex set is a convex function, so its largest value over P is at
a vertex of P. Its member of S nearest to it is found, and any member bounds the distance.

Outer, P ⊂ S: the largest distance is the largest h_S(u) − h_P(u) over unit vectors u. On the cone
of the normals of faces that meet at one vertex, h_P is linear and the difference sublinear, so
that its values at a grid of directions bound it on the whole cone (``direction_cover``).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from berthing.errors import InputError
from berthing.geometry import direction_cover
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import norm
from berthing.geometry.hulls import enclosed, inner_point, normal_cones
from berthing.geometry.log_sum_exp import LogSumExp
from berthing.geometry.smoothed_support import SmoothedSupport

if TYPE_CHECKING:
    from berthing.geometry.smoothed_polytope import SmoothedPolytope

# Newton's method for the shift: monotone, so that it ends when it stops to grow.
MAX_STEPS = 100
# Shifts are made larger by this, so that rounding leaves no vertex outside.
ROUNDING = 1e-14
# An exponent is accepted when it gives at least this much of the error allowed, or after so many
# attempts when it gives no more.
WORTHWHILE, ATTEMPTS = 0.98, 20
# An attempt aims at slightly less than is allowed.
AIM = 0.995


def outward_shift(A: Array, b: Array, Q: Array) -> float:
    """The least t ≥ 0 with Σ exp(Q_j (a_j·v − b_j − t)) ≤ 1 at every vertex v, in metres.

    The logarithm of the sum falls convexly with t, so Newton's method grows towards the root.
    """
    beyond = enclosed(A, b, "polytope")[2] @ A.T - b
    of_beyond = LogSumExp(np.diag(Q), np.zeros(len(Q)), 1.0)
    shift = np.zeros(len(beyond))
    for _ in range(MAX_STEPS):
        value, slope = of_beyond.along(beyond - shift[:, None], -np.ones_like(beyond))
        step = -value / slope
        shift += np.maximum(step, 0.0)
        if np.all(step <= ROUNDING * shift):
            break
    size = float(np.max(np.abs(b)))
    return float(np.max(shift)) * (1.0 + ROUNDING) + ROUNDING * size


def inner_error(finder: SmoothedSupport) -> float:
    """A bound on the Hausdorff distance of the set to its polytope, in metres."""
    nearest, _ = finder.hill.climb(finder.corners, finder.corners, pull=1.0)
    return float(np.max(norm(finder.corners - nearest)))


def outer_error(finder: SmoothedSupport, shift: float) -> float:
    """The same for a set whose faces lie ``shift`` farther out than the polytope's."""
    b = finder.b - shift
    corners = enclosed(finder.A, b, finder.where)[2]
    centre = inner_point(finder.A, b, finder.where)
    rows = normal_cones(finder.A, b, centre, finder.where)

    def beyond(u: Array) -> Array:
        point, residual = finder.points(u)
        reach = np.sum(u * point, axis=-1) + residual * finder.hill.size
        return np.asarray(reach - np.max(u @ corners.T, axis=-1))

    return direction_cover.largest(beyond, finder.A[rows])


def coarsest_allowed(
    build: Callable[[float], SmoothedPolytope], rows: int, size: float, allowed: float
) -> SmoothedPolytope:
    """The model with about the smallest exponent whose error is at most ``allowed`` metres.

    The error is nearly inverse to the exponent, so a few corrections do. An exponent that leaves
    nothing of the polytope is doubled; none is so small that faces at ``size`` metres are felt.
    """
    least = np.log(rows) / size
    exponent, best, empty = max(np.log(rows) / allowed, least), None, 0.0
    for _ in range(ATTEMPTS):
        try:
            model = build(exponent)
        except InputError:
            empty, exponent = exponent, 2.0 * exponent
            continue
        share = model.error_m / allowed
        if share <= 1.0 and (best is None or exponent < best.exponents[0]):
            best = model
        if WORTHWHILE <= share <= 1.0 or (share <= 1.0 and exponent <= least):
            break
        exponent = max(exponent * share / AIM, 0.5 * (empty + exponent) if empty else least)
    if best is None:
        raise InputError("error_m", f"is {allowed:g}", "an error that an exponent can reach")
    return best
