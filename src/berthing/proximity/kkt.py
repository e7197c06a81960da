"""The paper's form with its degeneracy taken out: closest points and multipliers as variables.

A set of one smooth function needs no complementarity: d_safe > 0 keeps w_I - p_I from zero,
stationarity then keeps λ from zero, and so f = 0 is exact (λ f = 0 would make every feasible point
degenerate). A set of several keeps it, as the Fischer-Burmeister row

    λ_i - f_i - √(λ_i² + f_i² + ε) = 0,   which says λ_i (-f_i) = ε/2, λ_i > 0, f_i < 0,

with ε driven towards zero from solve to solve (Fischer, 10.1080/02331939208843795; Kanzow,
10.1137/S1052623493262445). The points then overstate the squared distance by no more than
unit_m2 · m · ε/2 over m inequalities: with ε = 1e-8 by some 1e-6 m² for bodies of some metres; the
certificate has the last word.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from berthing.geometry.convex_set import ConvexSet
from berthing.proximity.level_functions import LevelFunctions
from berthing.proximity.optimality import EXACT_MU, Complementarity, OptimalityFormulation, Side
from berthing.sym import Sym

SCHEDULE = (1e-4, 1e-6, 1e-8)
"""Of ε."""


class KktFormulation(OptimalityFormulation):
    """``kkt`` for one pair of sets."""

    def __init__(self, a: ConvexSet, b: ConvexSet) -> None:
        super().__init__(a, b)
        several = max(self.functions_a.count, self.functions_b.count) > 1
        self.homotopy = SCHEDULE if several else ()

    def complementarity(self, side: Side, eps: Sym) -> Complementarity:
        f, lam = side.f, side.multipliers
        count = side.functions.count
        exact = f if count <= 1 else lam - f - ca.sqrt(lam**2 + f**2 + eps)
        return Complementarity(exact, np.zeros(count), np.zeros(count))

    def centring(self, side: LevelFunctions, eps: float) -> float:
        return EXACT_MU if side.count <= 1 else max(0.5 * eps, EXACT_MU)
