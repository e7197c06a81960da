"""Exact support functions as epigraphs: multipliers, rows and a value that bounds h(m) above.

For a conic set {x : L x ≤ l, ‖A_j x + b_j‖ ≤ head_j}, conic duality gives

    h(m) = min  Σ head_j τ_j - b_jᵀ μ_j + lᵀ λ   with   Lᵀ λ + Σ A_jᵀ μ_j = m,  ‖μ_j‖ ≤ τ_j, λ ≥ 0,

so that any feasible multiplier gives an upper bound, and the plane bound can only understate the
clearance. Where the rows A_j stack to an invertible matrix and there are no linear rows (boxes,
balls, ellipsoids, cylinders), μ follows from m and only the τ_j remain. A polytope given by its
vertices needs one variable: t ≥ mᵀ v for each vertex v.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import casadi as ca
import numpy as np

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.capability import HasConicForm, HasVertices
from berthing.geometry.conic_form import ConicForm, SecondOrderBlock
from berthing.geometry.convex_set import ConvexSet
from berthing.sym import Sym


@dataclass(frozen=True)
class EpigraphRows:
    """Rows ``expression`` in [lower, upper] and the bound ``value`` ≥ h(m)."""

    value: Sym
    expression: Sym
    lower: Array
    upper: Array


@dataclass(frozen=True)
class BlockEpigraph:
    """Second-order blocks whose tails determine μ: one τ a block."""

    blocks: tuple[SecondOrderBlock, ...]
    tail_inverse: Array
    """A^{-T} of the stacked A_j: μ = A^{-T} m."""

    @property
    def size(self) -> int:
        return len(self.blocks)

    def rows(self, tau: Sym, m: Sym) -> EpigraphRows:
        mu = ca.mtimes(ca.DM(self.tail_inverse), m)
        value: Sym = 0
        expression: list[Sym] = []
        for j, (block, part) in enumerate(zip(self.blocks, self._tails(), strict=True)):
            mu_j = mu[part]
            value = value + block.head * tau[j] - ca.dot(ca.DM(block.b), mu_j)
            if len(block.b) == 1:
                expression += [tau[j] - mu_j, tau[j] + mu_j]
            else:
                expression += [tau[j] ** 2 - ca.sumsqr(mu_j), tau[j]]
        column = ca.vertcat(*expression)
        count = column.numel()
        return EpigraphRows(value, column, np.zeros(count), np.full(count, np.inf))

    def start(self, m: Array) -> Array:
        mu = m @ self.tail_inverse.T
        return np.stack([np.linalg.norm(mu[..., part], axis=-1) for part in self._tails()], axis=-1)

    def _tails(self) -> list[slice]:
        ends = np.cumsum([0, *(len(block.b) for block in self.blocks)])
        return [slice(int(i), int(j)) for i, j in pairwise(ends)]


@dataclass(frozen=True)
class VertexEpigraph:
    """One t above mᵀ v for every vertex v (k, d)."""

    vertices: Array
    size: int = 1

    def rows(self, t: Sym, m: Sym) -> EpigraphRows:
        column = t[0] - ca.mtimes(ca.DM(self.vertices), m)
        count = len(self.vertices)
        return EpigraphRows(t[0], column, np.zeros(count), np.full(count, np.inf))

    def start(self, m: Array) -> Array:
        return np.asarray(np.max(m @ self.vertices.T, axis=-1, keepdims=True))


Epigraph = BlockEpigraph | VertexEpigraph


def support_epigraph(shape: ConvexSet) -> Epigraph:
    """The smallest exact epigraph of the support function of ``shape``.

    Raises:
        CapabilityError: the shape has neither a conic form with determined tails nor vertices.
    """
    if isinstance(shape, HasConicForm):
        tail = _square_tail(shape.conic_form())
        if tail is not None:
            return BlockEpigraph(shape.conic_form().blocks, np.asarray(np.linalg.inv(tail).T))
    if isinstance(shape, HasVertices):
        return VertexEpigraph(shape.vertices())
    raise CapabilityError(
        f"no exact support epigraph for {type(shape).__name__}; `plane` takes sets whose conic "
        "form is made of second-order blocks with an invertible tail (Box, Sphere, Ellipsoid, "
        "Cylinder) and sets with vertices (Polytope)"
    )


def _square_tail(form: ConicForm) -> Array | None:
    if len(form.linear_b) or not form.blocks:
        return None
    tail = np.vstack([block.A for block in form.blocks])
    square = tail.shape[0] == tail.shape[1] and np.linalg.matrix_rank(tail) == len(tail)
    return tail if square else None
