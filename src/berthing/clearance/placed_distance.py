"""``berthing.distance``: how far apart two sets or bodies are, at one pose or many."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import numpy as np

from berthing.clearance.compiled_distance import compiled_distance, takes
from berthing.clearance.given_poses import GivenPoses, read_poses
from berthing.clearance.queried_distance import queried_distance
from berthing.clearance.signed_distance import SignedDistance, pose_gradients
from berthing.errors import CapabilityError, InputError
from berthing.geometry.body import Body
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.pose import Pose


def distance(
    A: ConvexSet | Body, B: ConvexSet | Body, poses: GivenPoses | tuple[GivenPoses, GivenPoses]
) -> SignedDistance:
    """Signed distance of A and B, with witness points, normal, proof and gradients.

    Args:
        A, B: convex sets, or bodies, of the same dimension. Of bodies, the closest parts count.
        poses: of B in A's frame; or a tuple of two, poses of A and of B in the world. Each is a
            ``Pose``, or numbers (..., 7) of position and quaternion q_IB, scalar first, in the
            plane (..., 3) of position and angle. One pose or a batch; batches broadcast. A batch
            is fastest in the order of a path, for each search starts where the last one ended.

    Raises:
        InputError: sets or poses whose dimensions or batches do not fit, numbers that are not
            finite, quaternions that are not of length 1.
        CapabilityError: two half-spaces.

    >>> import berthing as bt
    >>> found = bt.distance(bt.Box([2, 1, 1]), bt.Sphere(0.5), [4, 0, 0, 1, 0, 0, 0])
    >>> float(found.distance), found.normal.tolist()
    (1.5, [1.0, 0.0, 0.0])
    """
    for name, given in (("A", A), ("B", B)):
        if not isinstance(given, ConvexSet | Body):
            raise InputError(f"distance: {name}", f"is a {type(given).__name__}", "a set or body")
    if A.dim != B.dim:
        raise InputError("distance", f"of {A.dim} and {B.dim} dimensions", "the same")
    if isinstance(poses, tuple):
        if len(poses) != 2:
            found = f"is a tuple of {len(poses)}"
            raise InputError("distance: poses", found, "poses of A and poses of B")
        pose_a = read_poses(poses[0], A.dim, "distance: poses of A")
        pose_b = read_poses(poses[1], A.dim, "distance: poses of B")
    else:
        pose_a, pose_b = Pose.identity(A.dim), read_poses(poses, A.dim, "distance: poses")
    try:
        np.broadcast_shapes(pose_a.batch_shape, pose_b.batch_shape)
    except ValueError:
        shapes = f"has the batches {pose_a.batch_shape} and {pose_b.batch_shape}"
        raise InputError("distance: poses", shapes, "batches that broadcast") from None
    return _of_bodies(A, pose_a, B, pose_b)


def _of_bodies(
    a: ConvexSet | Body, pose_a: Pose, b: ConvexSet | Body, pose_b: Pose
) -> SignedDistance:
    """That of the closest parts at each pose."""
    moved = isinstance(a, Body) or isinstance(b, Body)
    found = [
        _seen_from(of_sets(*placed_a, *placed_b), moved, pose_a, pose_b)
        for placed_a, placed_b in product(_placed(a, pose_a), _placed(b, pose_b))
    ]
    if len(found) == 1:
        return found[0]
    stacked = SignedDistance.joined(found, (len(found),))
    closest = np.argmin(stacked.distance, axis=0)
    return stacked[(closest, *np.indices(closest.shape))]


def _placed(thing: ConvexSet | Body, pose: Pose) -> list[tuple[ConvexSet, Pose]]:
    if isinstance(thing, ConvexSet):
        return [(thing, pose)]
    return [(part.shape, pose.compose(part.placement)) for part in thing.parts]


def _seen_from(found: SignedDistance, moved: bool, pose_a: Pose, pose_b: Pose) -> SignedDistance:
    """With gradients by the poses of the bodies, not of their parts."""
    if not moved:
        return found
    middle = 0.5 * (found.point_a + found.point_b)
    by_a, by_b = pose_gradients(found.normal, middle, pose_a, pose_b)
    return replace(found, gradient_a=by_a, gradient_b=by_b)


def of_sets(a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose) -> SignedDistance:
    """That of two sets at poses known to be sound; CapabilityError for two half-spaces."""
    if isinstance(a, HalfSpace) and isinstance(b, HalfSpace):
        raise CapabilityError("two half-spaces have no distance: they meet, or never will")
    if takes(a, b):
        return compiled_distance(a, pose_a, b, pose_b)
    return queried_distance(a, pose_a, b, pose_b)
