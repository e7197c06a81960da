"""A rectangle or a rectangular box about its own origin."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import final

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm, blocks_only, centred_block
from berthing.geometry.convex_set import ConvexSet, last_axis, norm, positive_sizes
from berthing.geometry.mesh import Mesh, hull_mesh, polygon_mesh


@final
@dataclass(frozen=True, eq=False)
class Box(ConvexSet):
    """{x : |x_i| ≤ half_extents_i}.

    Attributes:
        half_extents: half of each size (2,) or (3,), in metres.

    Raises:
        InputError: not two or three positive finite sizes.
    """

    half_extents: Array

    def __post_init__(self) -> None:
        sizes = positive_sizes(self.half_extents, "Box.half_extents")
        object.__setattr__(self, "half_extents", sizes)

    @property
    def dim(self) -> int:
        return len(self.half_extents)

    @property
    def bounding_radius(self) -> float:
        return float(norm(self.half_extents))

    def support(self, n: Array) -> tuple[Array, Array]:
        n = last_axis(n, self.dim, "Box.support: n")
        return np.asarray(np.abs(n) @ self.half_extents), np.sign(n) * self.half_extents

    def level(self, x: Array) -> Array:
        x = last_axis(x, self.dim, "Box.level: x")
        return np.asarray(np.max(np.abs(x) - self.half_extents, axis=-1))

    def conic_form(self) -> ConicForm:
        """One block |x_i| ≤ a_i an axis: half the multipliers of two linear rows."""
        rows = np.eye(self.dim)
        return blocks_only(
            self.dim,
            *(centred_block(float(a), rows[i : i + 1]) for i, a in enumerate(self.half_extents)),
        )

    def vertices(self) -> Array:
        signs = np.array(list(product((-1.0, 1.0), repeat=self.dim)))
        return signs * self.half_extents

    def halfspaces(self) -> tuple[Array, Array]:
        rows = np.eye(self.dim)
        return np.concatenate([rows, -rows]), np.tile(self.half_extents, 2)

    def mesh(self) -> Mesh:
        if self.dim == 2:
            turn = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
            return polygon_mesh(turn * self.half_extents)
        return hull_mesh(self.vertices())
