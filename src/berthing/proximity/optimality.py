"""What the two forms of the paper's Propositions 2 and 3 have in common.

The closest points w of A and p of B are variables, each in its set's own frame and unit, and so
are multipliers λ and μ, one an inequality. With s_A, s_B for the points in their units and

    L = ‖w_I - p_I‖² / unit_m2 + λᵀ f_A(s_A) + μᵀ f_B(s_B),

the points are closest if and only if each set's own stationarity holds, ∂L/∂s_A = 0 **and**
∂L/∂s_B = 0 (the paper adds the two into one equation, which is not sufficient, and leaves out the
frames), together with f ≤ 0, λ, μ ≥ 0 and complementarity, which the forms write each in its way.
For a point (Proposition 2) its own variables and rows fall away.

Without λ, μ ≥ 0 the farthest points would do as well. The distance row is meaningless before the
others hold: points that are not closest overstate the distance.
"""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from itertools import pairwise

import casadi as ca
import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from berthing.proximity.closest_points import closest_points, difference
from berthing.proximity.formulation import PairFormulation, Rows, SymPose, Variables
from berthing.proximity.level_functions import LevelFunctions, level_functions
from berthing.sym import Sym

TOUCH = 0.02
"""Sets that overlap are started as if moved apart to this fraction of their sizes: at distance
zero every multiplier is zero and the rows say nothing of the way out."""

SHORTEST = 1e-3
"""Fraction of the length unit; distance rows are divided by the margin, but by no less."""

EXACT_MU = 1e-12
"""Complementarity λ (-f) left at the start where it is to be zero."""


@dataclass(frozen=True)
class Side:
    """One set's variables and rows at one instant."""

    functions: LevelFunctions
    f: Sym
    stationarity: Sym
    multipliers: Sym


@dataclass(frozen=True)
class Complementarity:
    """Rows of one form: lower ≤ expression ≤ upper."""

    expression: Sym
    lower: Array
    upper: Array


class OptimalityFormulation(PairFormulation):
    """Closest points as variables; what is left open is how complementarity is written."""

    def __init__(self, a: ConvexSet, b: ConvexSet) -> None:
        self.a, self.b = a, b
        self.functions_a, self.functions_b = level_functions(a), level_functions(b)
        self.unit_m2 = float((self.functions_a.radius_m + self.functions_b.radius_m) ** 2)
        names: list[str] = []
        lower: list[float] = []
        for letter, side in (("w", self.functions_a), ("p", self.functions_b)):
            names += [f"{letter}_{axis}" for axis in "xyz"[: side.dim]]
            lower += [-np.inf] * side.dim
        for letter, side in (("lambda", self.functions_a), ("mu", self.functions_b)):
            names += [f"{letter}_{i}" for i in range(side.count)]
            lower += [0.0] * side.count
        self.variables = Variables(tuple(names), np.array(lower), np.full(len(names), np.inf))

    @abstractmethod
    def complementarity(self, side: Side, eps: Sym) -> Complementarity:
        """f ≤ 0 and λᵀ f = 0 of one set."""

    def centring(self, side: LevelFunctions, eps: float) -> float:
        """λ_i (-f_i) at the start."""
        return EXACT_MU

    def rows(
        self, v: Sym, pose_a: SymPose, pose_b: SymPose, margin_m: Sym, length_m: float,
        eps: Sym = 0.0,
    ) -> Rows:  # fmt: skip
        s_a, s_b, lam, mu = self._split(v)
        (r_a, R_a), (r_b, R_b) = pose_a, pose_b
        w = r_a + ca.mtimes(R_a, _point(self.functions_a, s_a))
        p = r_b + ca.mtimes(R_b, _point(self.functions_b, s_b))
        delta = w - p
        side_a = self._side(self.functions_a, s_a, lam, ca.mtimes(R_a.T, delta))
        side_b = self._side(self.functions_b, s_b, mu, -ca.mtimes(R_b.T, delta))
        floor = SHORTEST * length_m
        square = (ca.sumsqr(delta) - margin_m**2) / (2 * length_m * ca.fmax(margin_m, floor))
        written = [self.complementarity(side, eps) for side in (side_a, side_b)]
        others = ca.vertcat(
            side_a.stationarity, side_b.stationarity, *(c.expression for c in written)
        )
        zeros = np.zeros(side_a.functions.dim + side_b.functions.dim)
        lower = np.concatenate([[0.0], zeros, *(c.lower for c in written)])
        upper = np.concatenate([[np.inf], zeros, *(c.upper for c in written)])
        expression = ca.vertcat(square, others)
        return Rows(
            ca.if_else(margin_m > 0, expression, self._idle(v, lower, upper)), lower, upper, 0,
            ca.sumsqr(s_a) + ca.sumsqr(s_b),
        )  # fmt: skip

    def start(self, pose_a: Pose, pose_b: Pose, normal: Array, eps: float = 0.0) -> Array:
        a, b = self.functions_a, self.functions_b
        offset, slope = difference(a, pose_a, b, pose_b)
        extent = self.a.support(pose_a.unrotate(normal))[0]
        extent = extent + self.b.support(pose_b.unrotate(-normal))[0]
        gap = np.sum(normal * (pose_b.position - pose_a.position), axis=-1) - extent
        apart = np.maximum(TOUCH * np.sqrt(self.unit_m2) - gap, 0.0)
        # A half-space has no extent off its own normal; nothing is known of the gap then.
        apart = np.where((gap > 0.0) | ~np.isfinite(gap), 0.0, apart)
        mu = np.concatenate([np.full(side.count, self.centring(side, eps)) for side in (a, b)])
        found = closest_points(a, b, offset - apart[:, None] * normal, slope, self.unit_m2, mu)
        return np.concatenate(
            [found.s_a, found.s_b, found.multipliers_a, found.multipliers_b], axis=-1
        )

    def _split(self, v: Sym) -> tuple[Sym, Sym, Sym, Sym]:
        a, b = self.functions_a, self.functions_b
        ends = np.cumsum([0, a.dim, b.dim, a.count, b.count]).tolist()
        s_a, s_b, lam, mu = (v[i:j] for i, j in pairwise(ends))
        return s_a, s_b, lam, mu

    def _side(self, side: LevelFunctions, s: Sym, multipliers: Sym, delta_own: Sym) -> Side:
        if not side.count:
            return Side(side, ca.SX(0, 1), ca.SX(0, 1), multipliers)
        f, jacobian = side.at(s)
        pull = 2 * side.radius_m / self.unit_m2 * delta_own
        return Side(side, f, pull + ca.mtimes(jacobian.T, multipliers), multipliers)

    def _idle(self, v: Sym, lower: Array, upper: Array) -> Sym:
        """Rows of a pair that may touch: fixed variables; what is no equality holds of itself.

        Left alone, the rows of sets that touch or overlap would have no solution, or no slope.
        There are as many equalities as variables.
        """
        fixed = iter(range(len(self.variables)))
        at = np.isfinite(self.variables.lower).astype(np.float64)
        rows = []
        for low, high in zip(lower, upper, strict=True):
            i = next(fixed) if low == high else None
            held = -1.0 if np.isfinite(high) else 1.0
            rows.append(held if i is None else v[i] - at[i])
        return ca.vertcat(*rows)


def _point(side: LevelFunctions, s: Sym) -> Sym:
    """Own frame, metres."""
    centre = ca.DM(side.centre_m)
    return centre + side.radius_m * s if side.count else centre
