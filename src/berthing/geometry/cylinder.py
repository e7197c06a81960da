"""A circular cylinder about its own origin, along one of its own axes."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot
from typing import final

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm, blocks_only, centred_block
from berthing.geometry.convex_set import ConvexSet, last_axis, norm, positive, unit
from berthing.geometry.mesh import Mesh, circle, hull_mesh
from berthing.geometry.revolution import AXES, Axis, axis_index, split


@final
@dataclass(frozen=True, eq=False)
class Cylinder(ConvexSet):
    """{x : |x·e| ≤ half_length, |x − (x·e) e| ≤ radius}, e the axis.

    Attributes:
        radius, half_length: in metres.
        axis: ``x`` (as in the paper), ``y`` or ``z``.

    Raises:
        InputError: a size that is not positive and finite, or another axis.
    """

    radius: float
    half_length: float
    axis: Axis = "x"

    def __post_init__(self) -> None:
        radius = positive(self.radius, "Cylinder.radius")
        half_length = positive(self.half_length, "Cylinder.half_length")
        axis_index(self.axis, 3, "Cylinder.axis")
        object.__setattr__(self, "radius", radius)
        object.__setattr__(self, "half_length", half_length)

    @property
    def dim(self) -> int:
        return 3

    @property
    def bounding_radius(self) -> float:
        return hypot(self.radius, self.half_length)

    @property
    def axis_index(self) -> int:
        """0, 1 or 2."""
        return AXES.index(self.axis)

    def support(self, n: Array) -> tuple[Array, Array]:
        n = last_axis(n, 3, "Cylinder.support: n")
        along, across = split(n, self.axis_index)
        value = self.half_length * np.abs(along) + self.radius * norm(across)
        point = self.radius * unit(across)
        point[..., self.axis_index] = self.half_length * np.sign(along)
        return value, point

    def level(self, x: Array) -> Array:
        along, across = split(last_axis(x, 3, "Cylinder.level: x"), self.axis_index)
        return np.maximum(np.abs(along) - self.half_length, norm(across) - self.radius)

    def conic_form(self) -> ConicForm:
        rows = np.eye(3)
        others = [i for i in range(3) if i != self.axis_index]
        return blocks_only(
            3,
            centred_block(self.half_length, rows[[self.axis_index]]),
            centred_block(self.radius, rows[others]),
        )

    def mesh(self) -> Mesh:
        rim = circle(self.radius)
        ends = [np.insert(rim, self.axis_index, s * self.half_length, axis=1) for s in (-1, 1)]
        return hull_mesh(np.concatenate(ends))
