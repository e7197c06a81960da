"""Exact support functions as epigraphs: multipliers, rows and a value that bounds h(m) above.

For a conic set {x : L z ≤ l, ‖A_j z + b_j‖ ≤ head_j + slope_j·z}, z = (x, y), conic duality gives

    h(m) = min  Σ head_j τ_j - b_jᵀ μ_j + lᵀ λ
           with   Lᵀ λ + Σ (A_jᵀ μ_j - τ_j slope_j) = (m, 0),  ‖μ_j‖ ≤ τ_j,  λ ≥ 0,

so that any feasible multiplier gives an upper bound, and the plane bound can only understate the
clearance. Where the rows A_j stack to an invertible matrix and there are neither slopes nor linear
rows (boxes, balls, ellipsoids, cylinders, capsules, padded ones of these), μ follows from m and
only the τ_j remain. A polytope given by its vertices needs one variable: t ≥ mᵀ v for each vertex
v. All other conic sets take their multipliers as they are.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import casadi as ca
import numpy as np

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.capability import HasConicForm, HasVertices, conic_form, kinds_with
from berthing.geometry.conic_dual import support_multipliers
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
    """Columns of A^{-T}, A the stacked A_j, that meet x: μ = A^{-T} (m, 0)."""

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
            expression += _cone(tau[j], mu_j)
        column = ca.vertcat(*expression)
        count = column.numel()
        return EpigraphRows(value, column, np.zeros(count), np.full(count, np.inf))

    def start(self, m: Array) -> Array:
        mu = m @ self.tail_inverse.T
        return np.stack([np.linalg.norm(mu[..., part], axis=-1) for part in self._tails()], axis=-1)

    def _tails(self) -> list[slice]:
        return _tails(self.blocks)


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


@dataclass(frozen=True)
class ConicEpigraph:
    """Any conic form: λ, τ and μ, tied to m by equations."""

    form: ConicForm
    size_m: float
    """Of the set."""

    @property
    def size(self) -> int:
        form = self.form
        return len(form.linear_b) + sum(1 + len(block.b) for block in form.blocks)

    def rows(self, multipliers: Sym, m: Sym) -> EpigraphRows:
        form, count = self.form, len(self.form.linear_b)
        lam, tau = multipliers[:count], multipliers[count : count + len(form.blocks)]
        mu = multipliers[count + len(form.blocks) :]
        value = ca.dot(ca.DM(form.linear_b), lam)
        total = ca.mtimes(ca.DM(form.linear_A.T), lam)
        cones: list[Sym] = []
        for j, (block, part) in enumerate(zip(form.blocks, _tails(form.blocks), strict=True)):
            value = value + block.head * tau[j] - ca.dot(ca.DM(block.b), mu[part])
            total = total + ca.mtimes(ca.DM(block.A.T), mu[part])
            if block.slope is not None:
                total = total - tau[j] * ca.DM(block.slope)
            cones += _cone(tau[j], mu[part])
        tied = total - ca.vertcat(m, ca.DM.zeros(form.lift, 1))
        column = ca.vertcat(tied, lam, *cones)
        upper = np.full(column.numel(), np.inf)
        upper[: form.size] = 0.0
        return EpigraphRows(value, column, np.zeros(len(upper)), upper)

    def start(self, m: Array) -> Array:
        best = support_multipliers(self.form, self.size_m, m.reshape(-1, self.form.dim))
        flat = np.concatenate([best.lines, best.heads, *best.tails], axis=-1)
        return flat.reshape(*m.shape[:-1], self.size)


Epigraph = BlockEpigraph | VertexEpigraph | ConicEpigraph


@lru_cache(maxsize=4096)
def support_epigraph(shape: ConvexSet) -> Epigraph:
    """The smallest exact epigraph of the support function of ``shape``, worked out once a shape.

    Raises:
        CapabilityError: the shape has neither a conic form nor vertices.
    """
    form = known_conic_form(shape)
    inverse = None if form is None else _tail_inverse(form)
    if form is not None and inverse is not None:
        return BlockEpigraph(form.blocks, inverse)
    if isinstance(shape, HasVertices):
        return VertexEpigraph(shape.vertices())
    if form is not None:
        return ConicEpigraph(form, shape.bounding_radius)
    raise CapabilityError(
        f"no exact support epigraph for this {type(shape).__name__}; `plane` takes sets with a "
        f"conic form or vertices (loaded: {kinds_with(HasConicForm, HasVertices)}; of "
        "superellipsoids those with exponents that are powers of two); `kkt` and "
        "`kkt-complementarity` take sets of smooth inequalities"
    )


def known_conic_form(shape: ConvexSet) -> ConicForm | None:
    """The form, where there is one: of some kinds that depends on exponents, or on a base."""
    try:
        return conic_form(shape)
    except CapabilityError:
        return None


def _tail_inverse(form: ConicForm) -> Array | None:
    """For x of the inverse transpose of the stacked tails, where they determine the multipliers."""
    sloping = any(block.slope is not None for block in form.blocks)
    if len(form.linear_b) or sloping or not form.blocks:
        return None
    tail = np.vstack([block.A for block in form.blocks])
    if tail.shape[0] != tail.shape[1] or np.linalg.matrix_rank(tail) < len(tail):
        return None
    return np.asarray(np.linalg.inv(tail).T[:, : form.dim])


def _tails(blocks: tuple[SecondOrderBlock, ...]) -> list[slice]:
    """Where each block's part of the stacked μ is."""
    ends = np.cumsum([0, *(len(block.b) for block in blocks)])
    return [slice(int(i), int(j)) for i, j in pairwise(ends)]


def _cone(tau: Sym, mu: Sym) -> list[Sym]:
    """Rows that are not negative exactly where ‖μ‖ ≤ τ."""
    if mu.numel() == 1:
        return [tau - mu, tau + mu]
    return [tau**2 - ca.sumsqr(mu), tau]
