"""Signed distances by ``PairQuery``, a pose at a time: for sets that the kernel does not know."""

from __future__ import annotations

import numpy as np

from berthing.clearance.separation import PairQuery, Separation
from berthing.clearance.signed_distance import SignedDistance, pose_gradients
from berthing.geometry.convex_set import ConvexSet, norm
from berthing.geometry.pose import Pose


def queried_distance(a: ConvexSet, poses_a: Pose, b: ConvexSet, poses_b: Pose) -> SignedDistance:
    """At poses of batch shapes () or (...).

    Of sets that overlap nothing is proven from inside but that they do: their upper bound is 0.

    Raises:
        CapabilityError: two half-spaces.
    """
    query = PairQuery(a, b)
    batch = np.broadcast_shapes(poses_a.batch_shape, poses_b.batch_shape)
    found = []
    for index in np.ndindex(*batch):
        at_a = poses_a[index] if poses_a.batch_shape else poses_a
        at_b = poses_b[index] if poses_b.batch_shape else poses_b
        found.append(_answer(query.query(at_a, at_b), at_a, at_b))
    if not found:
        return _none(a.dim, batch)
    return SignedDistance.joined(found, batch)


def _answer(found: Separation, pose_a: Pose, pose_b: Pose) -> SignedDistance:
    middle = 0.5 * (found.point_a + found.point_b)
    by_a, by_b = pose_gradients(found.normal, middle, pose_a, pose_b)
    between = float(norm(found.point_b - found.point_a))
    upper = max(between, found.lower_bound) if found.distance > 0.0 else 0.0
    return SignedDistance(
        np.array(found.distance), found.normal, found.point_a, found.point_b,
        np.array(found.lower_bound), np.array(upper), by_a, by_b,
    )  # fmt: skip


def _none(dim: int, batch: tuple[int, ...]) -> SignedDistance:
    """Of no poses."""
    number, vector = np.zeros(batch), np.zeros((*batch, dim))
    gradient = np.zeros((*batch, 3 if dim == 2 else 6))
    return SignedDistance(number, vector, vector, vector, number, number, gradient, gradient)
