"""Independent checks of answers of ``berthing.distance``, and poses to ask it at."""

from __future__ import annotations

import numpy as np

from berthing.clearance.placed_distance import distance
from berthing.clearance.plane import plane_bound
from berthing.clearance.signed_distance import SignedDistance
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.capability import level
from berthing.geometry.convex_set import ConvexSet, norm
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.intersection import Intersection
from berthing.geometry.pose import Pose
from support.shapes import size

# Metres: of a bracket about the distance of sets apart, of 1 to 5 m; asked for by the project.
BRACKET = 1e-8
# Metres, where sets overlap.
DEPTH = 1e-5
# Fourth-order differences with this step (m, rad) of values good to 1e-10 err by about 1e-6.
STEP = 3e-5
# Of the gradient's length, or of 1 if that is shorter.
GRADIENT = 1e-5
# Of the bound as two codes round it, in terms of the sizes.
ROUNDING = 1e-10


def random_rotations(rng: np.random.Generator, count: int, dim: int) -> Array:
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


def faults(
    found: SignedDistance, a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose
) -> list[str]:
    """What is wrong with a batch of answers, by the package's own support and level functions."""
    scale = size(a) + size(b) + 1.0
    apart = found.lower_bound > 0.0
    open_by = found.upper_bound - found.lower_bound
    wrong = {
        "not finite": ~np.isfinite(found.distance),
        "bounds cross": open_by < -ROUNDING * scale,
        "distance outside its bounds": (found.distance > found.upper_bound + ROUNDING * scale)
        | (found.distance < found.lower_bound - ROUNDING * scale),
        "bounds too far apart": open_by > np.where(apart, BRACKET, DEPTH),
        "normal not unit": np.abs(norm(found.normal) - 1.0) > ROUNDING,
        "point not a member": _outside(a, pose_a, found.point_a)
        | _outside(b, pose_b, found.point_b),
        "points not along the normal": norm(
            found.point_b - found.point_a - found.distance[:, None] * found.normal
        )
        > 1e-6 * scale,
    }
    # A half-space has no finite support value but along its own normal, to 1e-12 rad.
    if not isinstance(a, HalfSpace) and not isinstance(b, HalfSpace):
        bound = plane_bound(a, pose_a, b, pose_b, found.normal)
        wrong["bound not proven"] = found.lower_bound > bound + ROUNDING * scale
    return [f"{name} at {np.flatnonzero(at).tolist()}" for name, at in wrong.items() if at.any()]


def _outside(shape: ConvexSet, pose: Pose, points: Array) -> Array:
    """Points farther out than 1e-6 of the size along the level's own slope."""
    own = pose.unrotate(points - pose.position)
    inwards = own * (1.0 - 1e-6) if not isinstance(shape, HalfSpace | Intersection) else own
    value = np.minimum(level(shape, own), level(shape, inwards))
    return np.asarray(value > 1e-6 * (size(shape) + 1.0))


def differences(a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose) -> tuple[Array, Array]:
    """Gradients by the pose of A and of B (k, 6) or (k, 3), by central differences, and where the
    one-sided slopes differ (k,): kinks, where the gradient is but one of many."""
    count = 6 if a.dim == 3 else 3
    columns, kinks = [], []
    at = distance(a, b, (pose_a, pose_b)).distance
    for i in range(2 * count):
        values = []
        for times in (-2.0, -1.0, 1.0, 2.0):
            moved = times * STEP
            first = _moved(pose_a, i, moved) if i < count else pose_a
            second = _moved(pose_b, i - count, moved) if i >= count else pose_b
            values.append(distance(a, b, (first, second)).distance)
        columns.append((8.0 * (values[2] - values[1]) - (values[3] - values[0])) / (12.0 * STEP))
        before, after = (
            2 * (at - values[1]) - (at - values[0]) / 2,
            (2 * (values[2] - at) - (values[3] - at) / 2),
        )
        kinks.append(np.abs(after - before) / STEP)
    return np.stack(columns, axis=-1), np.max(kinks, axis=0)


def _moved(pose: Pose, i: int, by: float) -> Pose:
    """Along the world's axis i, or about one through the pose's own origin."""
    d = pose.dim
    if i < d:
        return Pose(pose.position + by * np.eye(d)[i], pose.rotation)
    if d == 2:
        turn = Pose.planar(np.zeros(2), by).rotation
    else:
        turn = quaternion.rotation_matrix(quaternion.from_axis_angle(np.eye(3)[i - 3], by))
    return Pose(pose.position, turn @ pose.rotation)
