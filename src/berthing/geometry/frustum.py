"""The hull of two parallel discs about one axis, one of which may be a point: formulas of cones.

The first disc lies at −half_length along the axis, the second at +half_length.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm, SecondOrderBlock
from berthing.geometry.convex_set import norm, unit
from berthing.geometry.mesh import Mesh, circle, hull_mesh
from berthing.geometry.revolution import split


@dataclass(frozen=True)
class Frustum:
    """Radii of the two discs and half their distance, in metres; the second radius may be 0."""

    first: float
    second: float
    half_length: float
    axis: int

    @property
    def bounding_radius(self) -> float:
        return hypot(max(self.first, self.second), self.half_length)

    @property
    def taper(self) -> float:
        """Growth of the radius along the axis."""
        return (self.second - self.first) / (2.0 * self.half_length)

    @property
    def middle(self) -> float:
        """Radius at the origin, in metres."""
        return 0.5 * (self.first + self.second)

    def support(self, n: Array) -> tuple[Array, Array]:
        """The better of the two discs' support points; n (..., 3)."""
        # Chosen by unit vectors, for lengths of tiny ones underflow; of two equals either will do.
        along, across = split(unit(n), self.axis)
        upper = self.half_length * along + 0.5 * (self.second - self.first) * norm(across) > 0.0
        along, across = split(n, self.axis)
        radius = np.where(upper, self.second, self.first)
        end = np.where(upper, self.half_length, -self.half_length)
        point = radius[..., None] * unit(across)
        point[..., self.axis] = end
        return np.asarray(end * along + radius * norm(across)), point

    def level(self, x: Array) -> Array:
        """The largest signed distance from the planes of both ends and the mantle, in metres."""
        along, across = split(x, self.axis)
        ends = np.abs(along) - self.half_length
        mantle = (norm(across) - self.middle - self.taper * along) / hypot(1.0, self.taper)
        return np.maximum(ends, mantle)

    def conic_form(self) -> ConicForm:
        """Two linear rows for the ends, of which a tip needs but one, and a sloping block."""
        rows = np.eye(3)
        e = rows[self.axis]
        ends = np.stack([-e, e])[: 1 if self.second == 0.0 else 2]
        across = rows[[i for i in range(3) if i != self.axis]]
        mantle = SecondOrderBlock(self.middle, across, np.zeros(2), self.taper * e)
        return ConicForm(3, ends, np.full(len(ends), self.half_length), (mantle,))

    def mesh(self) -> Mesh:
        ends = []
        for radius, place in ((self.first, -self.half_length), (self.second, self.half_length)):
            rim = circle(radius) if radius > 0.0 else np.zeros((1, 2))
            ends.append(np.insert(rim, self.axis, place, axis=1))
        return hull_mesh(np.concatenate(ends))
