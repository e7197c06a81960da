"""The baseline of sequential planners: the signed distance with its normal and points held.

At a pose where the least translation that makes the sets touch (or part) is along n, between the
points a of A and b of B, the signed distance is n·(r_B + R_B b − r_A − R_A a). Holding n, a and b
gives a function of the poses with its value and slope there (J. Schulman et al., Motion planning
with sequential convex optimization and convex collision checking, 10.1177/0278364914528132). It
may overstate the distance anywhere else, so that steps are kept short; what it ends with is
checked like anything else. Overlap is paid for by a slack, for first steps may have no way out.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from berthing.proximity.formulation import PairFormulation, Rows, SymPose, Variables
from berthing.sym import Sym

SLACK = "slack"


class LinearisedFormulation(PairFormulation):
    """``signed-distance-sequential`` for one pair of sets.

    Its normal and points are variables by name only: whoever solves holds them where ``start``
    puts them. The slack, in the unit of the separation row, is the regulariser.
    """

    def __init__(self, a: ConvexSet, b: ConvexSet) -> None:
        self.a, self.b = a, b
        axes = "xyz"[: a.dim]
        names = (*(f"{what}_{axis}" for what in ("n", "a", "b") for axis in axes), SLACK)
        lower = np.full(len(names), -np.inf)
        lower[-1] = 0.0
        self.variables = Variables(names, lower, np.full(len(names), np.inf))

    @property
    def held(self) -> int:
        """How many of the variables are to be held: all but the slack, which comes last."""
        return 3 * self.a.dim

    def rows(
        self, v: Sym, pose_a: SymPose, pose_b: SymPose, margin_m: Sym, length_m: float,
        eps: Sym = 0.0,
    ) -> Rows:  # fmt: skip
        d = self.a.dim
        (r_a, R_a), (r_b, R_b) = pose_a, pose_b
        n_world, a, b = v[:d], v[d : 2 * d], v[2 * d : 3 * d]
        apart = r_b + ca.mtimes(R_b, b) - r_a - ca.mtimes(R_a, a)
        gap = (ca.dot(n_world, apart) - margin_m) / length_m
        return Rows(gap + v[3 * d], np.zeros(1), np.full(1, np.inf), 0, v[3 * d])

    def start(self, pose_a: Pose, pose_b: Pose, normal: Array, eps: float = 0.0) -> Array:
        # Of the points that are farthest along an exact normal, one is a closest point; any of
        # them gives the same value.
        _, a = self.a.support(pose_a.unrotate(normal))
        _, b = self.b.support(-pose_b.unrotate(normal))
        return np.concatenate([normal, a, b, np.zeros((*normal.shape[:-1], 1))], axis=-1)
