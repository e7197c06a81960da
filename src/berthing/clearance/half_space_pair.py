"""Distances of a set from a half-space: in closed form, for there is but one normal."""

from __future__ import annotations

import numpy as np

from berthing.clearance.answer import Answer, PairMethod
from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.half_space import HalfSpace


class HalfSpacePair(PairMethod):
    """One of the two is a half-space, with the outward normal m.

    The other set's support point along −m is its nearest, or its deepest.

    Raises:
        CapabilityError: both are half-spaces.
    """

    def __init__(self, a: ConvexSet, b: ConvexSet) -> None:
        super().__init__(a, b)
        if isinstance(a, HalfSpace) and isinstance(b, HalfSpace):
            raise CapabilityError("two half-spaces have no distance: they meet, or never will")

    def one(self, rotation: Array, position: Array) -> Answer:
        distance, normal, _ = self.many(rotation[None], position[None])
        n, gap = normal[0], float(distance[0])
        if isinstance(self.a, HalfSpace):
            point_b = rotation @ self.b.support(-(n @ rotation))[1] + position
            return Answer(gap, n, point_b - gap * n, point_b, gap)
        point_a = self.a.support(n)[1]
        return Answer(gap, n, point_a, point_a + gap * n, gap)

    def many(self, rotation: Array, position: Array) -> tuple[Array, Array, Array]:
        if isinstance(self.a, HalfSpace):
            normal = np.broadcast_to(self.a.normal, position.shape).copy()
        elif isinstance(self.b, HalfSpace):
            normal = -(rotation @ self.b.normal)
        else:
            raise CapabilityError("neither of the sets is a half-space")
        proven = self.proven(rotation, position, normal)
        return proven, normal, proven.copy()
