"""A set written as linear rows and second-order cones, for optimisation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array


@dataclass(frozen=True, eq=False)
class SecondOrderBlock:
    """{z : ‖A z + b‖ ≤ head + slope·z}.

    Attributes:
        head: in metres where A is unitless; ≥ 0 unless the block slopes.
        A: (k, size).
        b: (k,).
        slope: (size,), or None for zero: the block is then as wide everywhere.
    """

    head: float
    A: Array
    b: Array
    slope: Array | None = None


@dataclass(frozen=True, eq=False)
class ConicForm:
    """{x : for some y, linear_A z ≤ linear_b and ‖A z + b‖ ≤ head + slope·z in every block}.

    Here z = (x, y), x (dim,) is in the set's own frame, and y (lift,) are helping variables,
    which most sets do without: a sum of sets has a form only with them. By conic duality (Boyd
    and Vandenberghe, *Convex Optimization*, section 5.9), for a set with an interior,

        h(n) = min  linear_b·λ + Σ_i (head_i τ_i − b_i·u_i)
               with linear_Aᵀ λ + Σ_i (A_iᵀ u_i − τ_i slope_i) = (n, 0),  λ ≥ 0,  ‖u_i‖ ≤ τ_i,

    and any feasible (λ, u, τ) gives an upper bound on the support value h(n).

    Attributes:
        dim: of x.
        linear_A: (m, dim + lift); m may be 0.
        linear_b: (m,).
        blocks: second-order cones.
        lift: number of helping variables; each is a length no longer than the set's bounding
            radius.
    """

    dim: int
    linear_A: Array
    linear_b: Array
    blocks: tuple[SecondOrderBlock, ...]
    lift: int = 0

    @property
    def size(self) -> int:
        """Of z."""
        return self.dim + self.lift

    def excess(self, x: Array) -> Array:
        """The worst row's left side less its right side (...) at x (..., dim); ≤ 0 inside.

        Raises:
            CapabilityError: a form with helping variables.
        """
        if self.lift:
            raise CapabilityError("a conic form with helping variables has no excess")
        x = np.asarray(x, dtype=np.float64)
        rows = [x @ self.linear_A.T - self.linear_b] if len(self.linear_b) else []
        for block in self.blocks:
            length = np.linalg.norm(x @ block.A.T + block.b, axis=-1)
            room = block.head if block.slope is None else block.head + x @ block.slope
            rows.append(np.asarray(length - room)[..., None])
        return np.asarray(np.max(np.concatenate(rows, axis=-1), axis=-1))


def blocks_only(dim: int, *blocks: SecondOrderBlock) -> ConicForm:
    """A conic form without linear rows."""
    return ConicForm(dim, np.zeros((0, dim)), np.zeros(0), blocks)


def centred_block(head: float, A: Array) -> SecondOrderBlock:
    """{x : ‖A x‖ ≤ head}."""
    return SecondOrderBlock(head, A, np.zeros(len(A)))
