"""All that lies below a plane: a wall or a ground without end."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array, as_array
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.convex_set import DIMENSIONS, ConvexSet, finite, last_axis, norm
from berthing.geometry.mesh import Mesh, hull_mesh, polygon_mesh

# A direction off the normal by less than this many rad is the normal: rotations to a frame and
# back err by 1e-16. A wall of 1 km then errs by 1e-9 m.
PARALLEL_RAD = 1e-12
# Of the piece of the plane that is drawn: half its width, and its thickness, in metres.
DRAWN_HALF_WIDTH_M, DRAWN_DEPTH_M = 10.0, 0.5


@final
@dataclass(frozen=True, eq=False)
class HalfSpace(ConvexSet):
    """{x : normal·x ≤ offset}. Not bounded: most support values are +∞, as is its radius.

    Attributes:
        normal: outward (2,) or (3,); made unit, ``offset`` divided alike.
        offset: signed distance of the plane from the origin, along the normal, in metres.

    Raises:
        InputError: a normal of another length than two or three, or zero; a number that is not
            finite.
    """

    normal: Array
    offset: float

    def __post_init__(self) -> None:
        normal = as_array(self.normal, (None,), "HalfSpace.normal")
        if len(normal) not in DIMENSIONS:
            raise InputError("HalfSpace.normal", f"has {len(normal)} components", "2 or 3")
        length = float(norm(normal))
        if length == 0.0:
            raise InputError("HalfSpace.normal", "is zero", "an outward normal")
        unit_normal = normal / length
        unit_normal.setflags(write=False)
        object.__setattr__(self, "normal", unit_normal)
        object.__setattr__(self, "offset", finite(self.offset, "HalfSpace.offset") / length)

    @property
    def dim(self) -> int:
        return len(self.normal)

    @property
    def bounding_radius(self) -> float:
        return float("inf")

    def support(self, n: Array) -> tuple[Array, Array]:
        """offset·|n| along the normal, 0 for n = 0, else +∞; the point is the foot of the origin.

        Where the value is +∞ no member attains it, and the point is only some member.
        """
        n = last_axis(n, self.dim, "HalfSpace.support: n")
        along = n @ self.normal
        # Scaled first, for tiny n.
        scale = np.max(np.abs(n), axis=-1)
        scaled = np.divide(n, scale[..., None], out=np.zeros_like(n), where=scale[..., None] > 0.0)
        aside = scaled - (scaled @ self.normal)[..., None] * self.normal
        bounded = (norm(aside) <= PARALLEL_RAD) & (along >= 0.0)
        value = np.where(bounded, self.offset * along, np.inf)
        return value, np.broadcast_to(self.offset * self.normal, n.shape).copy()

    def level(self, x: Array) -> Array:
        return last_axis(x, self.dim, "HalfSpace.level: x") @ self.normal - self.offset

    def conic_form(self) -> ConicForm:
        return ConicForm(self.dim, *self.halfspaces(), ())

    def halfspaces(self) -> tuple[Array, Array]:
        return self.normal[None], np.array([self.offset])

    def mesh(self) -> Mesh:
        """A slab about the foot of the origin, its outer face on the plane."""
        across = np.linalg.svd(self.normal[None])[2][1:]
        corners = np.array([(s, t) for s in (-1.0, 1.0) for t in (-1.0, 1.0)])
        outer = self.offset * self.normal
        depth = DRAWN_DEPTH_M * self.normal
        if self.dim == 3:
            face = outer + DRAWN_HALF_WIDTH_M * corners @ across
            return hull_mesh(np.concatenate([face, face - depth]))
        reach = DRAWN_HALF_WIDTH_M * np.array([self.normal[1], -self.normal[0]])
        return polygon_mesh(
            np.stack([outer - reach, outer - reach - depth, outer + reach - depth, outer + reach])
        )
