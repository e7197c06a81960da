"""An ellipse or an ellipsoid about its own origin, along its own axes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm, blocks_only, centred_block
from berthing.geometry.convex_set import ConvexSet, last_axis, norm, positive_sizes, unit
from berthing.geometry.mesh import Mesh, circle, polygon_mesh, unit_sphere


@final
@dataclass(frozen=True, eq=False)
class Ellipsoid(ConvexSet):
    """{x : Σ (x_i / semi_axes_i)² ≤ 1}.

    Attributes:
        semi_axes: (2,) or (3,) in metres.

    Raises:
        InputError: not two or three positive finite sizes.
    """

    semi_axes: Array

    def __post_init__(self) -> None:
        sizes = positive_sizes(self.semi_axes, "Ellipsoid.semi_axes")
        object.__setattr__(self, "semi_axes", sizes)

    @property
    def dim(self) -> int:
        return len(self.semi_axes)

    @property
    def bounding_radius(self) -> float:
        return float(np.max(self.semi_axes))

    def support(self, n: Array) -> tuple[Array, Array]:
        """The image of the unit ball under D = diag(semi_axes): h(n) = |D n|, at D D n / |D n|."""
        stretched = last_axis(n, self.dim, "Ellipsoid.support: n") * self.semi_axes
        return norm(stretched), self.semi_axes * unit(stretched)

    def level(self, x: Array) -> Array:
        """√Σ (x_i / semi_axes_i)² − 1, without unit."""
        return norm(last_axis(x, self.dim, "Ellipsoid.level: x") / self.semi_axes) - 1.0

    def conic_form(self) -> ConicForm:
        return blocks_only(self.dim, centred_block(1.0, np.diag(1.0 / self.semi_axes)))

    def mesh(self) -> Mesh:
        if self.dim == 2:
            return polygon_mesh(circle(1.0) * self.semi_axes)
        surface = unit_sphere()
        return Mesh(surface.vertices * self.semi_axes, surface.triangles)
