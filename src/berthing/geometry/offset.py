"""A set and all within some distance of it: its Minkowski sum with a ball."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.capability import conic_form
from berthing.geometry.conic_algebra import padded
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.convex_set import ConvexSet, last_axis, norm, positive, unit
from berthing.geometry.mesh import Mesh, support_mesh
from berthing.geometry.nearest import distance_to


@final
@dataclass(frozen=True, eq=False)
class Offset(ConvexSet):
    """{x : |x − y| ≤ radius for some member y of ``base``}.

    The signed distance of another set from it is that from ``base`` less the radius, overlapping
    or not, along the same normal.

    Attributes:
        base: a bounded set.
        radius: in metres.

    Raises:
        InputError: a radius that is not positive and finite, or a base without bounds.
    """

    base: ConvexSet
    radius: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "radius", positive(self.radius, "Offset.radius"))
        if not np.isfinite(self.base.bounding_radius):
            kind = type(self.base).__name__
            raise InputError("Offset.base", f"is a {kind}, without bounds", "a bounded set")

    @property
    def dim(self) -> int:
        return self.base.dim

    @property
    def bounding_radius(self) -> float:
        return self.base.bounding_radius + self.radius

    def support(self, n: Array) -> tuple[Array, Array]:
        n = last_axis(n, self.dim, "Offset.support: n")
        value, point = self.base.support(n)
        return value + self.radius * norm(n), point + self.radius * unit(n)

    def level(self, x: Array) -> Array:
        """Distance from the base less the radius, in metres; −radius in the base.

        Raises:
            CapabilityError: a base with neither a conic form nor a smooth level function.
        """
        x = last_axis(x, self.dim, "Offset.level: x")
        distance = distance_to(self.base, x.reshape(-1, self.dim))
        return np.asarray(distance.reshape(x.shape[:-1]) - self.radius)

    def conic_form(self) -> ConicForm:
        """With the nearest member of the base among the helping variables.

        Raises:
            CapabilityError: a base without a conic form.
        """
        return padded(conic_form(self.base), self.radius)

    def mesh(self) -> Mesh:
        return support_mesh(self.support, self.dim)
