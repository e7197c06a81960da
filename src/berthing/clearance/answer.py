"""What a method of distance says of one pair of sets."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, replace

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet


@dataclass(frozen=True, eq=False)
class Answer:
    """In A's frame, metres.

    Attributes:
        distance: negative for sets that overlap.
        normal: unit (d,), from A to B.
        point_a, point_b: witnesses (d,).
        proven: the plane bound of the normal.
    """

    distance: float
    normal: Array
    point_a: Array
    point_b: Array
    proven: float


class PairMethod(ABC):
    """Distances of one pair of sets; poses are those of B in A's frame, as arrays.

    Attributes:
        a, b: sets of the same dimension d.
        size: the length that tolerances refer to, in metres.
    """

    def __init__(self, a: ConvexSet, b: ConvexSet) -> None:
        self.a, self.b, self.dim = a, b, a.dim
        # Two points have no size; any length serves as their scale.
        self.size = (a.bounding_radius + b.bounding_radius) or 1.0

    @abstractmethod
    def one(self, rotation: Array, position: Array) -> Answer:
        """At one pose: rotation (d, d), position (d,)."""

    @abstractmethod
    def many(self, rotation: Array, position: Array) -> tuple[Array, Array, Array]:
        """Distances (k,), normals (k, d) and bounds (k,) at k poses (k, d, d), (k, d)."""

    def proven(self, rotation: Array, position: Array, normal: Array) -> Array:
        """Plane bounds (...) in A's frame; a normal of length 0 proves nothing."""
        seen_by_b = (normal[..., None, :] @ rotation)[..., 0, :]
        extents = self.a.support(normal)[0] + self.b.support(-seen_by_b)[0]
        bound = np.sum(normal * position, axis=-1) - extents
        return np.asarray(np.where(normal.any(axis=-1), bound, -np.inf))


def padded(answer: Answer, pad_a: float, pad_b: float) -> Answer:
    """The answer for the sets with all points added that are within these distances of them.

    Along any unit normal the plane bound falls by both pads, so the largest does too, and the
    same normal attains it, whether the sets overlap or not.
    """
    if pad_a == pad_b == 0.0:
        return answer
    return replace(
        answer,
        distance=answer.distance - pad_a - pad_b,
        point_a=answer.point_a + pad_a * answer.normal,
        point_b=answer.point_b - pad_b * answer.normal,
        proven=answer.proven - pad_a - pad_b,
    )
