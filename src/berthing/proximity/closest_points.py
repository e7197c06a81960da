"""Closest points of two placed sets with their multipliers, for many pairs of poses at once.

A primal-dual interior-point method (Boyd and Vandenberghe, *Convex Optimization*, section 11.7)
on the paper's eq. (dist-opt), min ‖w_I - p_I‖² with f_A(w) ≤ 0, f_B(p) ≤ 0, one problem a pair of
poses and all of them in step. It stops on the central path where asked, λ_i (-f_i) = μ_i, which is
also where the Fischer-Burmeister rows with ε = 2 μ_i vanish. Where closest points are not unique
the path leads to the middle of them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.proximity.level_functions import LevelFunctions

ITERATIONS = 80
"""Polytopes take 8 to 15, functions of degree eight up to 40."""

TOLERANCE = 1e-11
"""Of the scaled residuals; what is not there after all iterations is used as it is, as a start."""

TO_BOUNDARY = 0.99
"""Share of the step to the boundary that is taken."""

CENTRING = 0.2
"""Share of the mean complementarity that the next iterate aims at."""

CONVEX = 1e-9
"""Added to the Hessian, which is singular along faces that slide past each other."""


@dataclass(frozen=True)
class ClosestPoints:
    """Answers for n pairs of poses, in the units of the level functions.

    Attributes:
        s_a, s_b: (n, d), or (n, 0) for a point.
        multipliers_a, multipliers_b: of ‖w_I - p_I‖² / unit_m2 (n, m).
        residual: (n,) largest of the scaled optimality conditions.
    """

    s_a: Array
    s_b: Array
    multipliers_a: Array
    multipliers_b: Array
    residual: Array


def difference(
    a: LevelFunctions, pose_a: Pose, b: LevelFunctions, pose_b: Pose
) -> tuple[Array, Array]:
    """w_I - p_I = offset (n, d) + slope (n, d, da + db) · (s_a, s_b)."""
    offset = pose_a.apply(a.centre_m) - pose_b.apply(b.centre_m)
    n, d = offset.shape
    rotations = (np.broadcast_to(p.rotation, (n, d, d)) for p in (pose_a, pose_b))
    R_a, R_b = rotations
    slope = np.concatenate(
        [a.radius_m * R_a[..., : a.dim], -b.radius_m * R_b[..., : b.dim]], axis=-1
    )
    return offset, slope


def closest_points(
    a: LevelFunctions, b: LevelFunctions, offset: Array, slope: Array, unit_m2: float, mu: Array
) -> ClosestPoints:
    """Points that minimise ‖offset + slope s‖² / unit_m2 less a logarithmic barrier.

    Args:
        offset, slope: as ``difference`` gives them, for sets apart or not.
        mu: what λ_i (-f_i) is to be (m_a + m_b,), above zero.
    """
    problem = _Problem(a, b, offset, slope, unit_m2)
    s = np.zeros(slope.shape[:1] + slope.shape[2:])
    if not s.size:
        return ClosestPoints(s, s, s, s, np.zeros(len(s)))
    f, _ = problem.functions(s)
    slack = np.maximum(-f, 0.1)
    y = np.full_like(slack, 0.1)
    for _ in range(ITERATIONS):
        step = problem.step(s, slack, y, mu)
        if np.all(step.residual < TOLERANCE):
            break
        s = s + step.primal[:, None] * step.s
        slack = slack + step.primal[:, None] * step.slack
        y = y + step.dual[:, None] * step.y
    return ClosestPoints(
        s[:, : a.dim], s[:, a.dim :], y[:, : a.count], y[:, a.count :], step.residual
    )


@dataclass(frozen=True)
class _Step:
    s: Array
    slack: Array
    y: Array
    primal: Array
    dual: Array
    residual: Array


@dataclass(frozen=True)
class _Problem:
    a: LevelFunctions
    b: LevelFunctions
    offset: Array
    slope: Array
    unit_m2: float

    def functions(self, s: Array) -> tuple[Array, Array]:
        """f (n, m) and Jacobian (n, m, d) of both sets together."""
        a, b = self.a, self.b
        f_a, J_a = a.values(s[:, : a.dim])
        f_b, J_b = b.values(s[:, a.dim :])
        J = np.zeros((len(s), a.count + b.count, a.dim + b.dim))
        J[:, : a.count, : a.dim], J[:, a.count :, a.dim :] = J_a, J_b
        return np.concatenate([f_a, f_b], axis=1), J

    def step(self, s: Array, slack: Array, y: Array, mu: Array) -> _Step:
        f, J = self.functions(s)
        delta = self.offset + np.einsum("nij,nj->ni", self.slope, s)
        slope_t = np.swapaxes(self.slope, 1, 2)
        J_t = np.swapaxes(J, 1, 2)
        dual = 2.0 / self.unit_m2 * _times(slope_t, delta) + _times(J_t, y)
        primal = f + slack
        residual = np.max(
            np.abs(np.concatenate([dual, primal, slack * y - mu], axis=1)), axis=1, initial=0.0
        )
        aim = CENTRING * np.mean(slack * y, axis=1, keepdims=True)
        complement = slack * y - np.maximum(mu, aim)
        H = 2.0 / self.unit_m2 * slope_t @ self.slope + self._curvature(s, y)
        H = H + J_t @ ((y / slack)[..., None] * J)
        H = H + CONVEX * np.eye(H.shape[-1])
        right = -dual - _times(J_t, (y * primal - complement) / slack)
        ds = np.asarray(np.linalg.solve(H, right[..., None])[..., 0], dtype=np.float64)
        d_slack = -primal - _times(J, ds)
        dy = -(complement + y * d_slack) / slack
        return _Step(ds, d_slack, dy, _reach(slack, d_slack), _reach(y, dy), residual)

    def _curvature(self, s: Array, y: Array) -> Array:
        a, b = self.a, self.b
        W = np.zeros((len(s), a.dim + b.dim, a.dim + b.dim))
        W[:, : a.dim, : a.dim] = a.curvature(s[:, : a.dim], y[:, : a.count])
        W[:, a.dim :, a.dim :] = b.curvature(s[:, a.dim :], y[:, a.count :])
        return W


def _times(matrix: Array, vector: Array) -> Array:
    return np.asarray(np.einsum("nij,nj->ni", matrix, vector))


def _reach(value: Array, step: Array) -> Array:
    """The longest step (n,) up to 1 that keeps ``value`` above zero."""
    ratio = np.where(step < 0.0, -TO_BOUNDARY * value / np.where(step < 0.0, step, -1.0), 1.0)
    return np.asarray(np.minimum(1.0, np.min(ratio, axis=1, initial=1.0)))
