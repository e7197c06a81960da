"""A line segment thickened by a ball: a cylinder with round ends."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm, SecondOrderBlock
from berthing.geometry.convex_set import DIMENSIONS, ConvexSet, last_axis, norm, positive, unit
from berthing.geometry.mesh import Mesh, support_mesh
from berthing.geometry.revolution import Axis, axis_index


@final
@dataclass(frozen=True, eq=False)
class Capsule(ConvexSet):
    """{x : |x − t e| ≤ radius for some |t| ≤ half_length}, e the axis.

    Attributes:
        radius: in metres.
        half_length: of the straight part, caps excluded, in metres.
        axis: ``x``, ``y`` or ``z``; one of the first two in the plane.
        dim: 2 or 3.

    Raises:
        InputError: a size that is not positive and finite, another axis or dimension.
    """

    radius: float
    half_length: float
    axis: Axis = "x"
    dim: int = 3

    def __post_init__(self) -> None:
        if self.dim not in DIMENSIONS:
            raise InputError("Capsule.dim", f"is {self.dim!r}", "2 or 3")
        axis_index(self.axis, self.dim, "Capsule.axis")
        object.__setattr__(self, "radius", positive(self.radius, "Capsule.radius"))
        object.__setattr__(self, "half_length", positive(self.half_length, "Capsule.half_length"))

    @property
    def bounding_radius(self) -> float:
        return self.radius + self.half_length

    @property
    def direction(self) -> Array:
        """Unit vector (dim,) of the axis."""
        return np.asarray(np.eye(self.dim)[axis_index(self.axis, self.dim, "Capsule.axis")])

    def support(self, n: Array) -> tuple[Array, Array]:
        n = last_axis(n, self.dim, "Capsule.support: n")
        along = n @ self.direction
        point = self.radius * unit(n)
        point += (self.half_length * np.sign(along))[..., None] * self.direction
        return self.half_length * np.abs(along) + self.radius * norm(n), point

    def level(self, x: Array) -> Array:
        x = last_axis(x, self.dim, "Capsule.level: x")
        nearest = np.clip(x @ self.direction, -self.half_length, self.half_length)
        return norm(x - nearest[..., None] * self.direction) - self.radius

    def conic_form(self) -> ConicForm:
        """With the place t on the segment as helping variable."""
        away = np.column_stack([np.eye(self.dim), -self.direction])
        place = np.append(np.zeros(self.dim), 1.0)[None]
        blocks = (
            SecondOrderBlock(self.radius, away, np.zeros(self.dim)),
            SecondOrderBlock(self.half_length, place, np.zeros(1)),
        )
        return ConicForm(self.dim, np.zeros((0, self.dim + 1)), np.zeros(0), blocks, lift=1)

    def mesh(self) -> Mesh:
        return support_mesh(self.support, self.dim)
