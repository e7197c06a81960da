"""Whether answers depend on the poses before, and upper bounds by other means than the kernel's."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks._distance_poses import size
from berthing.clearance.placed_distance import distance
from berthing.clearance.plane import plane_bound
from berthing.clearance.signed_distance import SignedDistance
from berthing.clearance.support_search import sphere_samples
from berthing.geometry.arrays import Array
from berthing.geometry.capability import level
from berthing.geometry.convex_set import ConvexSet, norm
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.intersection import Intersection
from berthing.geometry.pose import Pose

# Of bounds, in terms of the sizes: two interior-point methods leave this much.
ROUNDING = 4e-9
# Support points of intersections take long: of such a pair one pose in so many is asked again.
SELDOM = 10
# Poses of a pair whose upper bounds are looked at, and directions for sets that overlap.
LOOKED_AT, DIRECTIONS = 10, 32


@dataclass
class Repeated:
    """What was found when poses were asked again in another order, over all pairs so far."""

    poses: int = 0
    crossed: int = 0
    apart_m: float = 0.0
    overlapping_m: float = 0.0
    upper_bounds: int = 0
    upper_bounds_wrong: int = 0

    def ask(
        self, a: ConvexSet, b: ConvexSet, poses: tuple[Pose, Pose], found: SignedDistance, seed: int
    ) -> None:
        """Shuffled, so that every search starts elsewhere."""
        order = np.random.default_rng(seed).permutation(len(found.distance))
        if isinstance(a, Intersection) or isinstance(b, Intersection):
            order = order[: -(-len(order) // SELDOM)]
        again = distance(a, b, (poses[0][order], poses[1][order]))
        self.compare(found[order], again, size(a) + size(b) + 1.0)
        few = slice(0, LOOKED_AT)
        wrong = upper_bounds_wrong(found[few], a, poses[0][few], b, poses[1][few])
        self.upper_bounds += len(wrong)
        self.upper_bounds_wrong += int(np.sum(wrong))

    def compare(self, first: SignedDistance, second: SignedDistance, scale: float) -> None:
        """Both bracket the same number: neither lower bound may lie above the other's upper one."""
        slack = ROUNDING * scale
        crossed = (first.lower_bound > second.upper_bound + slack) | (
            second.lower_bound > first.upper_bound + slack
        )
        differ = np.abs(first.distance - second.distance)
        apart = (first.lower_bound > 0.0) & (second.lower_bound > 0.0)
        self.poses += len(differ)
        self.crossed += int(np.sum(crossed | ~np.isfinite(differ)))
        self.apart_m = max(self.apart_m, float(np.max(differ[apart], initial=0.0)))
        self.overlapping_m = max(self.overlapping_m, float(np.max(differ[~apart], initial=0.0)))

    def as_dict(self) -> dict[str, Any]:
        """Under the names of the table."""
        return {
            "asked_again_in_another_order": self.poses,
            "brackets_of_both_that_exclude_each_other": self.crossed,
            "apart_they_differ_by_m": self.apart_m,
            "overlapping_they_differ_by_m": self.overlapping_m,
            "upper_bounds_checked": self.upper_bounds,
            "upper_bounds_wrong": self.upper_bounds_wrong,
        }


def upper_bounds_wrong(
    found: SignedDistance, a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose
) -> Array:
    """Flags (k,). Apart, the bound is the distance of two points, which must be members; where sets
    overlap, no direction of a sample may prove more than it."""
    slack = ROUNDING * (size(a) + size(b) + 1.0)
    between = norm(found.point_b - found.point_a)
    wrong = between > found.upper_bound + slack
    wrong |= outside(a, pose_a, found.point_a) | outside(b, pose_b, found.point_b)
    deep = np.flatnonzero(found.lower_bound <= 0.0)
    wrong[deep] = False
    if isinstance(a, HalfSpace) or isinstance(b, HalfSpace):
        return np.asarray(wrong)
    n = np.repeat(sphere_samples(DIRECTIONS, a.dim)[:, None], len(deep), axis=1)
    bound = plane_bound(a, pose_a[deep], b, pose_b[deep], n)
    wrong[deep] = np.any(bound > found.upper_bound[deep] + slack, axis=0)
    return np.asarray(wrong)


def outside(shape: ConvexSet, pose: Pose, points: Array) -> Array:
    """Points farther out than 1e-6 of the size along the level's own slope."""
    own = pose.unrotate(points - pose.position)
    inwards = own * (1.0 - 1e-6) if not isinstance(shape, HalfSpace | Intersection) else own
    value = np.minimum(level(shape, own), level(shape, inwards))
    return np.asarray(value > 1e-6 * (size(shape) + 1.0))
