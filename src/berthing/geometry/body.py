"""A body: named convex parts, each placed in the body's frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.errors import InputError
from berthing.geometry.capability import HasVertices
from berthing.geometry.convex_set import ConvexSet, norm
from berthing.geometry.pose import Pose


@dataclass(frozen=True, eq=False)
class Part:
    """A convex set placed in the frame of its body.

    Attributes:
        name: unique within the body.
        shape: the set.
        placement: a single pose of the set's frame in the body's.

    Raises:
        InputError: dimensions that differ, or a batch of placements.
    """

    name: str
    shape: ConvexSet
    placement: Pose

    def __post_init__(self) -> None:
        if self.placement.batch_shape:
            raise InputError(f"part {self.name!r}", "has a batch of placements", "a single pose")
        if self.placement.dim != self.shape.dim:
            raise InputError(
                f"part {self.name!r}",
                f"places a set of {self.shape.dim} dimensions in {self.placement.dim}",
                "the same number of dimensions",
            )

    @property
    def bounding_radius(self) -> float:
        """At least sup |x| over the part about the body's reference point, in metres.

        Exact for a set with vertices and for one placed at the reference point.
        """
        if isinstance(self.shape, HasVertices):
            return float(np.max(norm(self.placement.apply(self.shape.vertices()))))
        return float(norm(self.placement.position)) + self.shape.bounding_radius


@dataclass(frozen=True, eq=False)
class Body:
    """A union of placed convex sets.

    Attributes:
        parts: at least one, all of the same dimension, names unique.

    Raises:
        InputError: no part, a name used twice, or dimensions that differ.
    """

    parts: tuple[Part, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "parts", tuple(self.parts))
        if not self.parts:
            raise InputError("body", "has no parts", "at least one")
        names = [p.name for p in self.parts]
        twice = sorted({n for n in names if names.count(n) > 1})
        if twice:
            raise InputError("body", f"uses the part name {twice[0]!r} twice", "unique names")
        dims = {p.shape.dim for p in self.parts}
        if len(dims) > 1:
            raise InputError("body", "mixes parts of two and three dimensions", "one or the other")

    @property
    def dim(self) -> int:
        """2 or 3."""
        return self.parts[0].shape.dim

    @property
    def bounding_radius(self) -> float:
        """At least sup |x| over the body about its reference point, in metres."""
        return max(p.bounding_radius for p in self.parts)

    def part(self, name: str) -> Part:
        """The part called ``name``; InputError with the options where there is none."""
        for part in self.parts:
            if part.name == name:
                return part
        options = ", ".join(p.name for p in self.parts)
        raise InputError("body", f"has no part {name!r}", f"one of: {options}")
