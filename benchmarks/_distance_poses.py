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
    at = distance(a, b, (pose_a, pose_b)).distance
    by_a = distance(a, b, (moved(pose_a, step), pose_b)).distance
    by_b = distance(a, b, (pose_a, moved(pose_b, step))).distance
    far_below, below, above, far_above = np.moveaxis(np.concatenate([by_a, by_b]), 1, 0)
    slopes = (8.0 * (above - below) - (far_above - far_below)) / (12.0 * step)
    before = 2.0 * (at - below) - 0.5 * (at - far_below)
    after = 2.0 * (above - at) - 0.5 * (far_above - at)
    return slopes.T, np.max(np.abs(after - before) / step, axis=0)


def moved(pose: Pose, step: float) -> Pose:
    """(6 or 3, 4, k): along each of the world's axes and about each one through the pose's own
    origin, by -2, -1, 1 and 2 steps."""
    d, by = pose.dim, step * np.array([-2.0, -1.0, 1.0, 2.0])
    still = np.broadcast_to(np.eye(d), (d, 4, d, d))
    if d == 2:
        turns = Pose.planar(np.zeros((4, 2)), by).rotation[None]
    else:
        about = np.repeat(np.eye(3)[:, None], 4, axis=1)
        turns = quaternion.rotation_matrix(quaternion.from_axis_angle(about, by))
    shifts = np.concatenate([by[:, None] * np.eye(d)[:, None], np.zeros((len(turns), 4, d))])
    return Pose(
        pose.position + shifts[:, :, None],
        np.concatenate([still, turns])[:, :, None] @ pose.rotation,
    )
