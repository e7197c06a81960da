"""The separating-plane form, exact, in the normal and the multipliers of two support functions.

With n from A to B, ‖n‖ ≤ 1, the clearance is at least n·(r_B - r_A) - h_A(n) - h_B(-n), and the
best n attains it when the sets are apart. Any feasible point proves the margin, so a solver that
stops early can only understate. The normal is a variable in B's frame: for a structure that is the
frame in which its own support function does not move.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from berthing.proximity.formulation import PairFormulation, Rows, SymPose, Variables, unbounded
from berthing.proximity.support_epigraph import support_epigraph
from berthing.sym import Sym


class PlaneFormulation(PairFormulation):
    """``plane`` for one pair of sets."""

    def __init__(self, a: ConvexSet, b: ConvexSet) -> None:
        self.a, self.b = a, b
        self.epigraph_a, self.epigraph_b = support_epigraph(a), support_epigraph(b)
        axes = "xyz"[: a.dim]
        names = (
            *(f"n_{axis}" for axis in axes),
            *(f"tau_a{i}" for i in range(self.epigraph_a.size)),
            *(f"tau_b{i}" for i in range(self.epigraph_b.size)),
        )
        self.variables: Variables = unbounded(names)

    def rows(
        self, v: Sym, pose_a: SymPose, pose_b: SymPose, margin_m: Sym, length_m: float,
        eps: Sym = 0.0,
    ) -> Rows:  # fmt: skip
        d, size_a = self.a.dim, self.epigraph_a.size
        (r_a, R_a), (r_b, R_b) = pose_a, pose_b
        n_B, tau_a, tau_b = v[:d], v[d : d + size_a], v[d + size_a :]
        n_world = ca.mtimes(R_b, n_B)
        side_a = self.epigraph_a.rows(tau_a, ca.mtimes(R_a.T, n_world))
        side_b = self.epigraph_b.rows(tau_b, -n_B)
        gap = ca.dot(n_world, r_b - r_a) - side_a.value - side_b.value - margin_m
        expression = ca.vertcat(
            gap / length_m, 1 - ca.sumsqr(n_B), side_a.expression, side_b.expression
        )
        lower = np.concatenate([[0.0, 0.0], side_a.lower, side_b.lower])
        upper = np.concatenate([[np.inf, np.inf], side_a.upper, side_b.upper])
        return Rows(expression, lower, upper, 0, ca.sumsqr(tau_a) + ca.sumsqr(tau_b))

    @property
    def sweep_size(self) -> int:
        """A's multipliers at the second pose; B's, in its own frame, are those of the block."""
        return self.epigraph_a.size

    def sweep_rows(
        self, v: Sym, tau: Sym, pose_a: SymPose, pose_b: SymPose, margin_m: Sym, length_m: float
    ) -> Rows:
        """The block's plane, fixed in B's frame, parts the sets at another pose too."""
        d, size_a = self.a.dim, self.epigraph_a.size
        (r_a, R_a), (r_b, R_b) = pose_a, pose_b
        n_B, tau_b = v[:d], v[d + size_a :]
        n_world = ca.mtimes(R_b, n_B)
        side_a = self.epigraph_a.rows(tau, ca.mtimes(R_a.T, n_world))
        side_b = self.epigraph_b.rows(tau_b, -n_B)
        gap = ca.dot(n_world, r_b - r_a) - side_a.value - side_b.value - margin_m
        return Rows(
            ca.vertcat(gap / length_m, side_a.expression),
            np.concatenate([[0.0], side_a.lower]),
            np.concatenate([[np.inf], side_a.upper]),
            0,
            ca.sumsqr(tau),
        )

    def sweep_start(self, v: Array, pose_a: Pose, pose_b: Pose) -> Array:
        n_A = pose_a.unrotate(pose_b.rotate(v[: self.a.dim]))
        return self.epigraph_a.start(n_A)

    def start(self, pose_a: Pose, pose_b: Pose, normal: Array, eps: float = 0.0) -> Array:
        n_A, n_B = pose_a.unrotate(normal), pose_b.unrotate(normal)
        return np.concatenate([n_B, self.epigraph_a.start(n_A), self.epigraph_b.start(-n_B)], -1)
