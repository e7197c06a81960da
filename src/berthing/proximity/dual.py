"""The dual of the least distance, in multipliers of both sets and no normal of its own.

For A = {x : A x ≤ a} and B = {x : B x ≤ b} the distance is the largest

    −bᵀμ − aᵀλ + n·(r_B − r_A)   with   n_A = Aᵀλ,   R_Bᵀ R_A n_A + Bᵀμ = 0,   ‖n_A‖ ≤ 1,  λ, μ ≥ 0,

n = R_A n_A being the normal (X. Zhang, A. Liniger and F. Borrelli, 10.1109/TCST.2019.2949540;
Boyd and Vandenberghe, *Convex Optimization*, section 8.2). Any feasible multipliers understate it.
Curved sets bring the multipliers u of their cones with them, aᵀλ becoming Σ head ‖u‖ − bᵀu.
Beside ``plane`` the normal is eliminated and every face has a multiplier.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import casadi as ca
import numpy as np
from scipy.optimize import nnls

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.capability import HasHalfspaces, HasVertices
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from berthing.proximity.formulation import PairFormulation, Rows, SymPose, Variables
from berthing.proximity.support_epigraph import (
    BlockEpigraph,
    known_conic_form,
    support_epigraph,
)
from berthing.sym import Sym

ACTIVE = 1e-9
"""A face holds a vertex within this share of the set's size; vertices come from the faces."""


@dataclass(frozen=True)
class DualSide:
    """One set's part of the rows.

    Attributes:
        normal: the vector m (d,) that the multipliers stand for.
        value: an upper bound on the support value h(m).
        expression, lower: further rows, each at least its bound.
    """

    normal: Sym
    value: Sym
    expression: Sym
    lower: Array


class Multipliers(Protocol):
    """Multipliers of one set."""

    @property
    def lower(self) -> Array:
        """Bounds (k,)."""
        ...

    def side(self, v: Sym) -> DualSide: ...

    def start(self, m: Array) -> Array:
        """Multipliers (n, k) of the vectors m (n, d)."""
        ...


@dataclass(frozen=True)
class FaceMultipliers:
    """One λ ≥ 0 a face of {x : A x ≤ b}."""

    A: Array
    b: Array
    vertices: Array

    @property
    def lower(self) -> Array:
        return np.zeros(len(self.b))

    def side(self, v: Sym) -> DualSide:
        normal = ca.mtimes(ca.DM(self.A.T), v)
        return DualSide(normal, ca.dot(ca.DM(self.b), v), ca.SX(0, 1), np.zeros(0))

    def start(self, m: Array) -> Array:
        return np.array([self._of(row) for row in m.reshape(-1, self.A.shape[1])])

    def _of(self, m: Array) -> Array:
        # By complementarity only the faces through the vertex farthest along m bear.
        vertex = self.vertices[int(np.argmax(self.vertices @ m))]
        room = self.b - self.A @ vertex
        bearing = np.flatnonzero(room <= ACTIVE * (1.0 + np.max(np.abs(self.b))))
        out = np.zeros(len(self.b))
        out[bearing], _ = nnls(self.A[bearing].T, m)
        return out


@dataclass(frozen=True)
class ConeMultipliers:
    """u and τ ≥ ‖u‖ of each second-order block, the blocks' tails stacking to a square matrix."""

    epigraph: BlockEpigraph

    @property
    def lower(self) -> Array:
        return np.full(len(self.epigraph.tail_inverse) + self.epigraph.size, -np.inf)

    def side(self, v: Sym) -> DualSide:
        d = len(self.epigraph.tail_inverse)
        normal = ca.mtimes(ca.DM(np.linalg.inv(self.epigraph.tail_inverse)), v[:d])
        rows = self.epigraph.rows(v[d:], normal)
        return DualSide(normal, rows.value, rows.expression, rows.lower)

    def start(self, m: Array) -> Array:
        m = m.reshape(-1, len(self.epigraph.tail_inverse))
        return np.concatenate([m @ self.epigraph.tail_inverse.T, self.epigraph.start(m)], axis=-1)


def multipliers(shape: ConvexSet) -> Multipliers:
    """Those of ``shape``; CapabilityError where the form cannot take it."""
    if isinstance(shape, HasHalfspaces) and isinstance(shape, HasVertices):
        A, b = shape.halfspaces()
        return FaceMultipliers(A, b, shape.vertices())
    form = known_conic_form(shape)
    if form is not None and _is_plain(form):
        epigraph = support_epigraph(shape)
        if isinstance(epigraph, BlockEpigraph):
            return ConeMultipliers(epigraph)
    raise CapabilityError(
        f"`dual` cannot take {type(shape).__name__}: it takes sets with faces (Box, Polytope) and "
        "sets of cones that fix their multipliers (Sphere, Ellipsoid, Cylinder); `plane` or `kkt` "
        "may take it"
    )


def _is_plain(form: ConicForm) -> bool:
    """Without helping variables, slopes or linear rows."""
    sloping = any(block.slope is not None for block in form.blocks)
    return not (form.lift or sloping or len(form.linear_b))


class DualFormulation(PairFormulation):
    """``dual`` for one pair of sets."""

    def __init__(self, a: ConvexSet, b: ConvexSet) -> None:
        self.dim = a.dim
        self.side_a, self.side_b = multipliers(a), multipliers(b)
        lower = np.concatenate([self.side_a.lower, self.side_b.lower])
        self.size_a = len(self.side_a.lower)
        names = (
            *(f"lambda_a{i}" for i in range(self.size_a)),
            *(f"lambda_b{i}" for i in range(len(self.side_b.lower))),
        )
        self.variables = Variables(names, lower, np.full(len(lower), np.inf))

    def rows(
        self, v: Sym, pose_a: SymPose, pose_b: SymPose, margin_m: Sym, length_m: float,
        eps: Sym = 0.0,
    ) -> Rows:  # fmt: skip
        (r_a, R_a), (r_b, R_b) = pose_a, pose_b
        a, b = self.side_a.side(v[: self.size_a]), self.side_b.side(v[self.size_a :])
        n_world = ca.mtimes(R_a, a.normal)
        gap = ca.dot(n_world, r_b - r_a) - a.value - b.value - margin_m
        meets = ca.mtimes(R_b.T, n_world) + b.normal
        expression = ca.vertcat(
            gap / length_m, 1 - ca.sumsqr(a.normal), meets, a.expression, b.expression
        )
        lower = np.concatenate([[0.0, 0.0], np.zeros(self.dim), a.lower, b.lower])
        upper = np.full(len(lower), np.inf)
        upper[2 : 2 + self.dim] = 0.0
        return Rows(expression, lower, upper, 0, ca.sumsqr(v))

    def start(self, pose_a: Pose, pose_b: Pose, normal: Array, eps: float = 0.0) -> Array:
        n_A, n_B = pose_a.unrotate(normal), pose_b.unrotate(normal)
        out = np.concatenate([self.side_a.start(n_A), self.side_b.start(-n_B)], axis=-1)
        return out.reshape(*normal.shape[:-1], len(self.variables))
