"""The bound that needs support functions only, and proves a clearance whatever gave its normal."""

from __future__ import annotations

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet, last_axis, norm
from berthing.geometry.pose import Pose


def plane_bound(a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose, n: Array) -> Array:
    """A lower bound on the signed distance of two placed sets, in metres.

    For ‖n‖ ≤ 1, x in A and y in B: ‖y − x‖ ≥ n·(y − x) ≥ n·(r_B − r_A) − h_A(R_Aᵀ n) − h_B(−R_Bᵀ n)
    (the hyperplane of Boyd and Vandenberghe, *Convex Optimization*, section 2.5). The largest
    value over unit n is the distance of sets apart, and minus the penetration depth of sets that
    overlap. Rounding adds up to about 1e-15 of the coordinates' size; a proof must allow for it.

    Args:
        a, b: sets of the same dimension d.
        pose_a, pose_b: their poses in the world; batch axes broadcast.
        n: (..., d), world frame, pointing from A to B; a vector longer than 1 is scaled to 1.

    Returns:
        (...), the broadcast of all batch axes.

    Raises:
        InputError: dimensions that do not fit, or a normal that is not finite.
    """
    check_dimensions(a, pose_a, b, pose_b)
    n = last_axis(n, a.dim, "plane_bound: n")
    if not np.all(np.isfinite(n)):
        raise InputError("plane_bound: n", "contains NaN or an infinite value", "finite numbers")
    n = n / np.maximum(norm(n), 1.0)[..., None]
    gap = np.einsum("...i,...i->...", n, pose_b.position - pose_a.position)
    extent_a = a.support(pose_a.unrotate(n))[0]
    extent_b = b.support(-pose_b.unrotate(n))[0]
    return np.asarray(gap - extent_a - extent_b)


def check_dimensions(a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose) -> None:
    """InputError unless both sets and both poses have the same number of dimensions."""
    found = (a.dim, pose_a.dim, b.dim, pose_b.dim)
    if len(set(found)) > 1:
        raise InputError(
            f"{type(a).__name__} and {type(b).__name__}",
            f"set, pose, set, pose have {found} dimensions",
            "the same number four times",
        )
