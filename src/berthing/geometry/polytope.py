"""A bounded polygon or polyhedron."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

import numpy as np

from berthing.geometry.arrays import Array, as_array
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.convex_set import ConvexSet, last_axis, norm
from berthing.geometry.hulls import enclosed, extreme_points, facets
from berthing.geometry.mesh import Mesh, hull_mesh, polygon_mesh


@final
@dataclass(frozen=True, eq=False, init=False)
class Polytope(ConvexSet):
    """{x : A x ≤ b}, which is also the hull of ``corners``.

    Both descriptions are kept, each without redundant members; the one that was given is exact
    and the other follows to rounding.

    Attributes:
        A: outward unit rows (m, dim), dim 2 or 3.
        b: (m,) in metres.
        corners: extreme points (k, dim) in metres.
    """

    A: Array
    b: Array
    corners: Array

    def __init__(self, A: Array, b: Array) -> None:
        """From half-spaces A x ≤ b, rows of any length but zero, redundant ones allowed.

        Raises:
            InputError: shapes that do not fit, NaN, or an empty, flat or unbounded set.
        """
        A = as_array(A, (None, None), "Polytope.A")
        b = as_array(b, (len(A),), "Polytope.b")
        self._fill(*enclosed(A, b, "Polytope"))

    @staticmethod
    def from_halfspaces(A: Array, b: Array) -> Polytope:
        """The same as the constructor."""
        return Polytope(A, b)

    @staticmethod
    def from_vertices(vertices: Array) -> Polytope:
        """The hull of points (n, dim) in metres; those inside it are dropped.

        Raises:
            InputError: wrong shape, NaN, too few points, or points in one plane.
        """
        where = "Polytope.vertices"
        corners = extreme_points(as_array(vertices, (None, None), where), where)
        shape: Polytope = object.__new__(Polytope)
        shape._fill(*facets(corners, where), corners)
        return shape

    def _fill(self, A: Array, b: Array, corners: Array) -> None:
        for name, value in (("A", A), ("b", b), ("corners", corners)):
            value = np.ascontiguousarray(value)
            value.setflags(write=False)
            object.__setattr__(self, name, value)

    @property
    def dim(self) -> int:
        return int(self.A.shape[1])

    @property
    def bounding_radius(self) -> float:
        return float(np.max(norm(self.corners)))

    def support(self, n: Array) -> tuple[Array, Array]:
        n = last_axis(n, self.dim, "Polytope.support: n")
        products = n @ self.corners.T
        best = np.argmax(products, axis=-1)
        value = np.take_along_axis(products, best[..., None], axis=-1)[..., 0]
        return value, self.corners[best]

    def level(self, x: Array) -> Array:
        x = last_axis(x, self.dim, "Polytope.level: x")
        return np.asarray(np.max(x @ self.A.T - self.b, axis=-1))

    def conic_form(self) -> ConicForm:
        return ConicForm(self.dim, self.A, self.b, ())

    def vertices(self) -> Array:
        return self.corners

    def halfspaces(self) -> tuple[Array, Array]:
        return self.A, self.b

    def mesh(self) -> Mesh:
        if self.dim == 3:
            return hull_mesh(self.corners)
        spokes = self.corners - self.corners.mean(axis=0)
        return polygon_mesh(self.corners[np.argsort(np.arctan2(spokes[:, 1], spokes[:, 0]))])
