"""Signed distance of two placed convex sets, with the normal that proves it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.clearance.answer import PairMethod, padded
from berthing.clearance.coal_pair import CoalPair
from berthing.clearance.coal_shapes import has_coal_shape
from berthing.clearance.conic_pair import ConicPair
from berthing.clearance.half_space_pair import HalfSpacePair
from berthing.clearance.plane import check_dimensions
from berthing.clearance.support_pair import SupportPair
from berthing.errors import CapabilityError, InputError
from berthing.geometry.arrays import Array
from berthing.geometry.capability import conic_form
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.offset import Offset
from berthing.geometry.pose import Pose


@dataclass(frozen=True, eq=False)
class Separation:
    """How far apart two placed sets are, d their dimension.

    Attributes:
        distance: in metres; negative for sets that overlap: the shortest translation that parts
            them, with a minus sign.
        normal: unit (d,), world frame, from A to B.
        point_a, point_b: points of A and B (d,), world frame, metres, with
            point_b − point_a = distance · normal. They are not unique, for example for parallel
            faces; nothing should be differentiated through them.
        lower_bound: the plane bound of ``normal``, in metres: a proof, up to rounding.
    """

    distance: float
    normal: Array
    point_a: Array
    point_b: Array
    lower_bound: float


def separation(a: ConvexSet, pose_a: Pose, b: ConvexSet, pose_b: Pose) -> Separation:
    """Signed distance of A at ``pose_a`` and B at ``pose_b``, both single poses.

    Raises:
        InputError: dimensions that do not fit, or a batch of poses.
        CapabilityError: two half-spaces.
    """
    return PairQuery(a, b).query(pose_a, pose_b)


class PairQuery:
    """Distance queries of one pair of sets, many poses.

    The objects of the collision library are made once and reused, so one PairQuery must not be
    used by two threads at a time. Answers do not depend on earlier queries.

    Args:
        a, b: sets of the same dimension d.

    Exact primitives and polytopes go to the collision library, other sets with a conic form to a
    cone solver, and the rest, smooth sets among them, to a slow search by support functions.

    Raises:
        InputError: dimensions that differ.
        CapabilityError: two half-spaces.
    """

    def __init__(self, a: ConvexSet, b: ConvexSet) -> None:
        if a.dim != b.dim:
            raise InputError(
                f"{type(a).__name__} and {type(b).__name__}",
                f"have {a.dim} and {b.dim} dimensions",
                "the same",
            )
        self.a, self.b, self.dim = a, b, a.dim
        core_a, self._pad_a = _core(a)
        core_b, self._pad_b = _core(b)
        self._method = _method(core_a, core_b)

    def query(self, pose_a: Pose, pose_b: Pose) -> Separation:
        """The separation at two single poses.

        Raises:
            InputError: dimensions that do not fit, or a batch of poses.
        """
        check_dimensions(self.a, pose_a, self.b, pose_b)
        if pose_a.batch_shape or pose_b.batch_shape:
            raise InputError("PairQuery.query", "was given a batch of poses", "single poses")
        turn = pose_a.rotation
        rotation, position = turn.T @ pose_b.rotation, (pose_b.position - pose_a.position) @ turn
        answer = padded(self._method.one(rotation, position), self._pad_a, self._pad_b)
        return Separation(
            answer.distance,
            turn @ answer.normal,
            turn @ answer.point_a + pose_a.position,
            turn @ answer.point_b + pose_a.position,
            answer.proven,
        )

    def batch(self, poses_a: Pose, poses_b: Pose) -> tuple[Array, Array, Array]:
        """Distances (k,), normals (k, d) and lower bounds (k,) at k pairs of poses.

        Args:
            poses_a, poses_b: batches of length k; one of them may be a single pose.

        Raises:
            InputError: dimensions or batches that do not fit.
        """
        check_dimensions(self.a, poses_a, self.b, poses_b)
        try:
            shape = np.broadcast_shapes(poses_a.batch_shape, poses_b.batch_shape)
        except ValueError:
            shape = ()
        if len(shape) != 1:
            found = f"{poses_a.batch_shape} and {poses_b.batch_shape}"
            raise InputError("PairQuery.batch", f"was given batches {found}", "(k,) and (k,) or ()")
        relative = poses_a.inverse().compose(poses_b)
        distance, normal, proven = self._method.many(relative.rotation, relative.position)
        pads = self._pad_a + self._pad_b
        return distance - pads, poses_a.rotate(normal), proven - pads


def _core(shape: ConvexSet) -> tuple[ConvexSet, float]:
    """The set without the distance that it is padded by, and that distance in metres."""
    if not isinstance(shape, Offset):
        return shape, 0.0
    core, padding = _core(shape.base)
    return core, padding + shape.radius


def _method(a: ConvexSet, b: ConvexSet) -> PairMethod:
    """The fastest that can take both sets."""
    if isinstance(a, HalfSpace) or isinstance(b, HalfSpace):
        return HalfSpacePair(a, b)
    if has_coal_shape(a) and has_coal_shape(b):
        return CoalPair(a, b)
    try:
        conic_form(a), conic_form(b)
    except CapabilityError:
        return SupportPair(a, b)
    return ConicPair(a, b)
