"""The paper's eq. (prop2) and (prop3) as printed, but for the errata: λ f = 0 is kept.

λ ≥ 0, f ≤ 0 and λ f = 0 together satisfy no constraint qualification (MFCQ fails: at every feasible
point the gradients are positively dependent). It is here to be measured against.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from berthing.proximity.optimality import Complementarity, OptimalityFormulation, Side
from berthing.sym import Sym


class KktComplementarityFormulation(OptimalityFormulation):
    """``kkt-complementarity`` for one pair of sets."""

    def complementarity(self, side: Side, eps: Sym) -> Complementarity:
        zeros = np.zeros(side.functions.count)
        return Complementarity(
            ca.vertcat(side.multipliers * side.f, side.f),
            np.concatenate([zeros, np.full(len(zeros), -np.inf)]),
            np.concatenate([zeros, zeros]),
        )
