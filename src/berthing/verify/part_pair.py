"""One pair of convex parts as the certificate sees it: balls, and exact queries at instants."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from berthing.clearance.plane import plane_bound
from berthing.clearance.separation import PairQuery
from berthing.geometry.arrays import Array
from berthing.geometry.body import Part
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.enclosing import centred_ball
from berthing.geometry.pose import Pose
from berthing.verify.frames import lifted
from berthing.verify.pair_motion import RelativePose


@dataclass(frozen=True)
class Ball:
    """A ball that holds a part: centre in the body's frame (3,), radius in m.

    That of a half-space is infinite, its centre on the plane.
    """

    centre: Array
    radius: float


@dataclass(frozen=True)
class Samples:
    """Queries (k,): distance (m), unit normal from A to B (k, 3) in B's frame, plane bound (m)."""

    distance: Array
    normal: Array
    bound: Array


class PartPair:
    """A part of A and one of B, in the frame of body B."""

    def __init__(self, part_a: Part, part_b: Part) -> None:
        self.part_a, self.part_b = part_a, part_b
        self.ball_a, self.ball_b = enclosing_ball(part_a), enclosing_ball(part_b)
        self._query: PairQuery | None = None

    def sample(self, pose: RelativePose) -> Samples:
        """Query at A's frames (k,) in B's. A bound that is not a number becomes −∞."""
        if self._query is None:
            # Made on the first use: most pairs of large bodies are never near each other.
            self._query = PairQuery(self.part_a.shape, self.part_b.shape)
        distance, normal, bound = self._query.batch(self._placed(pose), self.part_b.placement)
        bound = np.where(np.isfinite(bound), bound, -np.inf)
        return Samples(distance, lifted(normal), bound)

    def plane(self, pose: RelativePose, normals: Array) -> Array:
        """Plane bounds (k,) of normals (k, 3) in B's frame at A's frames (k,) in B's."""
        a, b = self.part_a, self.part_b
        return plane_bound(
            a.shape, self._placed(pose), b.shape, b.placement, normals[:, : a.shape.dim]
        )

    def _placed(self, pose: RelativePose) -> Pose:
        """The frames (k,) of A's shape in B's body frame."""
        dim, placement = self.part_a.shape.dim, self.part_a.placement
        rotation = pose.rotation[:, :dim, :dim]
        position = pose.position[:, :dim] + rotation @ placement.position
        turned = rotation @ placement.rotation
        # A rotation of a quaternion is one unless it overflowed.
        finite = np.isfinite(position).all() and np.isfinite(turned).all()
        return (Pose.sound if finite else Pose)(position, turned)


def enclosing_ball(part: Part) -> Ball:
    """A ball about the middle of the part's extents along its own axes.

    The middle, not the shape's origin: a polytope may lie far from its origin, and all bounds on
    turning are proportional to the radius.
    """
    own = _own_ball(part.shape)
    return Ball(lifted(part.placement.apply(own.centre)), own.radius)


@lru_cache(maxsize=4096)
def _own_ball(shape: ConvexSet) -> Ball:
    """In the shape's own frame and dimension."""
    return Ball(*centred_ball(shape))
