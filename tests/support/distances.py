"""Independent checks of answers of ``berthing.distance``."""

from __future__ import annotations

import numpy as np
from benchmarks._distance_order import outside
from benchmarks._distance_poses import size

from berthing.clearance.plane import plane_bound
from berthing.clearance.signed_distance import SignedDistance
from berthing.geometry.convex_set import ConvexSet, norm
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.intersection import Intersection
from berthing.geometry.pose import Pose

# Metres: of a bracket about the distance of sets apart, of 1 to 5 m; asked for by the project.
BRACKET = 1e-8
# Metres, where sets overlap.
DEPTH = 1e-5
# Of the gradient's length, or of 1 if that is shorter.
GRADIENT = 1e-5
# Of the bound as two codes round it, in terms of the sizes; or as two interior-point methods
# leave it.
ROUNDING, SOLVED = 1e-10, 4e-9
# Of the points' distance from the line along the normal, in terms of the sizes.
ASIDE = 1e-6


def faults(
    found: SignedDistance, a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose
) -> list[str]:
    """What is wrong with a batch of answers, by the package's own support and level functions."""
    scale = size(a) + size(b) + 1.0
    apart = found.lower_bound > 0.0
    open_by = found.upper_bound - found.lower_bound
    # Points whose distance is u, and u - w along the normal, lie about root(2 u w) beside it.
    beside = np.sqrt(2.0 * np.maximum(found.upper_bound, 0.0) * np.maximum(open_by, 0.0))
    wrong = {
        "not finite": ~np.isfinite(found.distance),
        "bounds cross": open_by < -ROUNDING * scale,
        "distance outside its bounds": (found.distance > found.upper_bound + ROUNDING * scale)
        | (found.distance < found.lower_bound - ROUNDING * scale),
        "bounds too far apart": open_by > np.where(apart, BRACKET, DEPTH),
        "normal not unit": np.abs(norm(found.normal) - 1.0) > ROUNDING,
        "point not a member": outside(a, pose_a, found.point_a) | outside(b, pose_b, found.point_b),
        "points not along the normal": norm(
            found.point_b - found.point_a - found.distance[:, None] * found.normal
        )
        > ASIDE * scale + np.where(apart, beside, 0.0),
    }
    # A half-space has no finite support value but along its own normal, to 1e-12 rad.
    if not isinstance(a, HalfSpace) and not isinstance(b, HalfSpace):
        bound = plane_bound(a, pose_a, b, pose_b, found.normal)
        solved = isinstance(a, Intersection) or isinstance(b, Intersection)
        slack = (SOLVED if solved else ROUNDING) * scale
        wrong["bound not proven"] = found.lower_bound > bound + slack
    return [f"{name} at {np.flatnonzero(at).tolist()}" for name, at in wrong.items() if at.any()]
