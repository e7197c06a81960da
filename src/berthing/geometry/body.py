"""A body: named convex parts, each placed in the body's frame."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from berthing.errors import InputError
from berthing.geometry.capability import HasVertices
from berthing.geometry.convex_set import ConvexSet, norm
from berthing.geometry.pose import Pose
from berthing.geometry.shape_model import EXACT, ShapeModel


@dataclass(frozen=True, eq=False)
class Part:
    """A convex set placed in the frame of its body.

    Attributes:
        name: unique within the body.
        shape: the set, as plans are checked against.
        placement: a single pose of the set's frame in the body's.
        model: what stands for the set while a motion is planned.

    Raises:
        InputError: dimensions that differ, or a batch of placements.
    """

    name: str
    shape: ConvexSet
    placement: Pose
    model: ShapeModel = EXACT

    def __post_init__(self) -> None:
        if self.placement.batch_shape:
            raise InputError(f"part {self.name!r}", "has a batch of placements", "a single pose")
        if self.placement.dim != self.shape.dim:
            raise InputError(
                f"part {self.name!r}",
                f"places a set of {self.shape.dim} dimensions in {self.placement.dim}",
                "the same number of dimensions",
            )

    @cached_property
    def planning_shape(self) -> ConvexSet:
        """The set's model, or the set itself where it is to be exact or is smooth as it is.

        Raises:
            InputError: no such model of such a set, or one of which nothing is left.
        """
        return self.model.of(self.shape)

    @property
    def planned_smaller(self) -> bool:
        """Whether the model lies inside the set: plans with it need not keep the set clear."""
        return self.model.side == "inner" and self.planning_shape is not self.shape

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
