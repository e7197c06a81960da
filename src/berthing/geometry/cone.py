"""A circular cone along one of its own axes, its origin half way up."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.convex_set import ConvexSet, last_axis, positive
from berthing.geometry.frustum import Frustum
from berthing.geometry.mesh import Mesh
from berthing.geometry.revolution import Axis, axis_index


@final
@dataclass(frozen=True, eq=False)
class Cone(ConvexSet):
    """The hull of a disc at −half_length along the axis and a tip at +half_length.

    Attributes:
        radius: of the disc, in metres.
        half_length: half the height, in metres.
        axis: ``x``, ``y`` or ``z``.

    Raises:
        InputError: a size that is not positive and finite, or another axis.
    """

    radius: float
    half_length: float
    axis: Axis = "x"

    def __post_init__(self) -> None:
        axis_index(self.axis, 3, "Cone.axis")
        object.__setattr__(self, "radius", positive(self.radius, "Cone.radius"))
        object.__setattr__(self, "half_length", positive(self.half_length, "Cone.half_length"))

    @property
    def dim(self) -> int:
        return 3

    @property
    def frustum(self) -> Frustum:
        """The same set in the terms of truncated cones."""
        return Frustum(self.radius, 0.0, self.half_length, axis_index(self.axis, 3, "Cone.axis"))

    @property
    def bounding_radius(self) -> float:
        return self.frustum.bounding_radius

    def support(self, n: Array) -> tuple[Array, Array]:
        return self.frustum.support(last_axis(n, 3, "Cone.support: n"))

    def level(self, x: Array) -> Array:
        return self.frustum.level(last_axis(x, 3, "Cone.level: x"))

    def conic_form(self) -> ConicForm:
        return self.frustum.conic_form()

    def mesh(self) -> Mesh:
        return self.frustum.mesh()
