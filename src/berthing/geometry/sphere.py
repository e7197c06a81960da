"""A disc, a ball or a point about its own origin."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm, blocks_only, centred_block
from berthing.geometry.convex_set import DIMENSIONS, ConvexSet, finite, last_axis, norm, unit
from berthing.geometry.mesh import Mesh, circle, polygon_mesh, unit_sphere


@final
@dataclass(frozen=True, eq=False)
class Sphere(ConvexSet):
    """{x : |x| ≤ radius}.

    Attributes:
        radius: in metres; 0 is a point.
        dim: 2 for a disc, 3 for a ball.

    Raises:
        InputError: a negative or non-finite radius, or another dimension.
    """

    radius: float
    dim: int = 3

    def __post_init__(self) -> None:
        radius = finite(self.radius, "Sphere.radius")
        if radius < 0.0:
            raise InputError("Sphere.radius", f"is {radius:g}", "zero or more, in metres")
        if self.dim not in DIMENSIONS:
            raise InputError("Sphere.dim", f"is {self.dim!r}", "2 or 3")
        object.__setattr__(self, "radius", radius)

    @property
    def bounding_radius(self) -> float:
        return self.radius

    def support(self, n: Array) -> tuple[Array, Array]:
        n = last_axis(n, self.dim, "Sphere.support: n")
        return self.radius * norm(n), self.radius * unit(n)

    def level(self, x: Array) -> Array:
        return norm(last_axis(x, self.dim, "Sphere.level: x")) - self.radius

    def conic_form(self) -> ConicForm:
        return blocks_only(self.dim, centred_block(self.radius, np.eye(self.dim)))

    def mesh(self) -> Mesh:
        """Triangles; those of a point all lie at the origin."""
        if self.dim == 2:
            return polygon_mesh(circle(self.radius))
        surface = unit_sphere()
        return Mesh(self.radius * surface.vertices, surface.triangles)
