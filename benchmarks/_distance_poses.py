"""Poses that distances are asked at, and central differences about them; the tests use them too."""

from __future__ import annotations

import numpy as np

from berthing.clearance.placed_distance import distance
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet, norm
from berthing.geometry.pose import Pose

# Fourth-order differences with this step (m, rad) of values good to 1e-13 err by about 1e-8.
STEP = 1e-5


def size(shape: ConvexSet) -> float:
    """Bounding radius in metres; 1 m for a half-space."""
    return shape.bounding_radius if np.isfinite(shape.bounding_radius) else 1.0


def random_rotations(rng: np.random.Generator, count: int, dim: int) -> Array:
    """(count, dim, dim)."""
    if dim == 2:
        return Pose.planar(np.zeros((count, 2)), rng.uniform(-np.pi, np.pi, count)).rotation
    return quaternion.rotation_matrix(rng.normal(size=(count, 4)))


def random_poses(
    rng: np.random.Generator, a: ConvexSet, b: ConvexSet, count: int
) -> tuple[Pose, Pose]:
    """Any attitudes; from one about the other's centre to half as far again as they can touch."""
    away = rng.normal(size=(count, a.dim))
    away *= (size(a) + size(b) + 0.01) / norm(away)[:, None]
    at_a = rng.normal(size=(count, a.dim))
    at_b = at_a + rng.uniform(0.0, 1.5, size=(count, 1)) * away
    turned = [random_rotations(rng, count, a.dim) for _ in range(2)]
    return Pose(at_a, turned[0]), Pose(at_b, turned[1])


def differences(
    a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose, step: float = STEP
) -> tuple[Array, Array]:
    """Gradients by the pose of A and of B (k, 12) or (k, 6), by central differences, and where the
    one-sided slopes differ (k,): kinks, where the gradient is but one of many."""
    count = 6 if a.dim == 3 else 3
    columns, kinks = [], []
    at = distance(a, b, (pose_a, pose_b)).distance
    for i in range(2 * count):
        near = []
        for times in (-2.0, -1.0, 1.0, 2.0):
            first = moved(pose_a, i, times * step) if i < count else pose_a
            second = moved(pose_b, i - count, times * step) if i >= count else pose_b
            near.append(distance(a, b, (first, second)).distance)
        columns.append((8.0 * (near[2] - near[1]) - (near[3] - near[0])) / (12.0 * step))
        before = 2.0 * (at - near[1]) - 0.5 * (at - near[0])
        after = 2.0 * (near[2] - at) - 0.5 * (near[3] - at)
        kinks.append(np.abs(after - before) / step)
    return np.stack(columns, axis=-1), np.max(kinks, axis=0)


def moved(pose: Pose, i: int, by: float) -> Pose:
    """Along the world's axis i, or about one through the pose's own origin."""
    d = pose.dim
    if i < d:
        return Pose(pose.position + by * np.eye(d)[i], pose.rotation)
    if d == 2:
        turn = Pose.planar(np.zeros(2), by).rotation
    else:
        turn = quaternion.rotation_matrix(quaternion.from_axis_angle(np.eye(3)[i - 3], by))
    return Pose(pose.position, turn @ pose.rotation)
