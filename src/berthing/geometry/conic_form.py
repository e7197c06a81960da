"""A set written as linear rows and second-order cones, for optimisation."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array


@dataclass(frozen=True, eq=False)
class SecondOrderBlock:
    """{x : ‖A x + b‖ ≤ head}.

    Attributes:
        head: radius of the block, ≥ 0; in metres where A is unitless.
        A: (k, dim).
        b: (k,).
    """

    head: float
    A: Array
    b: Array


@dataclass(frozen=True, eq=False)
class ConicForm:
    """{x : linear_A x ≤ linear_b, and every block's ‖A x + b‖ ≤ head}, in the set's own frame.

    By conic duality (Boyd and Vandenberghe, *Convex Optimization*, section 5.9), for a set
    with an interior,

        h(n) = min  linear_b·λ + Σ_i (head_i ‖u_i‖ − b_i·u_i)
               with linear_Aᵀ λ + Σ_i A_iᵀ u_i = n,  λ ≥ 0,

    and any feasible (λ, u) gives an upper bound on the support value h(n).

    Attributes:
        dim: of x.
        linear_A: (m, dim); m may be 0.
        linear_b: (m,).
        blocks: second-order cones.
    """

    dim: int
    linear_A: Array
    linear_b: Array
    blocks: tuple[SecondOrderBlock, ...]

    def excess(self, x: Array) -> Array:
        """The worst row's left side less its right side (...) at x (..., dim); ≤ 0 inside."""
        x = np.asarray(x, dtype=np.float64)
        rows = [x @ self.linear_A.T - self.linear_b] if len(self.linear_b) else []
        for block in self.blocks:
            length = np.linalg.norm(x @ block.A.T + block.b, axis=-1)
            rows.append((length - block.head)[..., None])
        return np.asarray(np.max(np.concatenate(rows, axis=-1), axis=-1))


def blocks_only(dim: int, *blocks: SecondOrderBlock) -> ConicForm:
    """A conic form without linear rows."""
    return ConicForm(dim, np.zeros((0, dim)), np.zeros(0), blocks)


def centred_block(head: float, A: Array) -> SecondOrderBlock:
    """{x : ‖A x‖ ≤ head}."""
    return SecondOrderBlock(head, A, np.zeros(len(A)))
