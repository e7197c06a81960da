"""A circular cone cut off below its tip, along one of its own axes, its origin half way up."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.convex_set import ConvexSet, last_axis, positive
from berthing.geometry.frustum import Frustum
from berthing.geometry.mesh import Mesh
from berthing.geometry.revolution import Axis, axis_index

SIZES = ("base_radius", "top_radius", "half_length")


@final
@dataclass(frozen=True, eq=False)
class TruncatedCone(ConvexSet):
    """The hull of a disc at −half_length along the axis and another at +half_length.

    Attributes:
        base_radius, top_radius: of the discs, in metres; either may be the larger.
        half_length: half their distance, in metres.
        axis: ``x``, ``y`` or ``z``.

    Raises:
        InputError: a size that is not positive and finite, or another axis.
    """

    base_radius: float
    top_radius: float
    half_length: float
    axis: Axis = "x"

    def __post_init__(self) -> None:
        axis_index(self.axis, 3, "TruncatedCone.axis")
        for name in SIZES:
            size = positive(getattr(self, name), f"TruncatedCone.{name}")
            object.__setattr__(self, name, size)

    @property
    def dim(self) -> int:
        return 3

    @property
    def frustum(self) -> Frustum:
        """The same set in the terms that cones share."""
        axis = axis_index(self.axis, 3, "TruncatedCone.axis")
        return Frustum(self.base_radius, self.top_radius, self.half_length, axis)

    @property
    def bounding_radius(self) -> float:
        return self.frustum.bounding_radius

    def support(self, n: Array) -> tuple[Array, Array]:
        return self.frustum.support(last_axis(n, 3, "TruncatedCone.support: n"))

    def level(self, x: Array) -> Array:
        return self.frustum.level(last_axis(x, 3, "TruncatedCone.level: x"))

    def conic_form(self) -> ConicForm:
        return self.frustum.conic_form()

    def mesh(self) -> Mesh:
        return self.frustum.mesh()
