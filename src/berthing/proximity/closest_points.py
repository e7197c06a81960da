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
import numpy.typing as npt

from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.proximity.level_functions import LevelFunctions

Mask = npt.NDArray[np.bool_]

ITERATIONS = 100
"""Polytopes take 10 to 20, functions that bend sharply up to 60."""

TOLERANCE = 1e-11
"""Of the scaled residuals; what is not there after all iterations is used as it is, as a start."""

TO_BOUNDARY = 0.99
"""Share of the step to the boundary that is taken."""

CENTRING = 0.1
"""Share of the mean complementarity that the next iterate aims at."""

DECREASE = 0.01
"""Share of the decrease promised that a step must bring."""

HALVINGS = 30

DAMPING = 1e-2
"""Of the residual, added to the Hessian, which is singular along faces that slide past each other
and where a function of high degree is flat; it fades as the answer nears."""

CONVEX = 1e-9
"""The least that is added."""


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
    slack = -problem.functions(s)[0]
    point = problem.at(s, slack, 0.1 / slack)
    done = np.zeros(len(s), dtype=bool)
    for _ in range(ITERATIONS):
        done |= _largest(point.residual(mu)) < TOLERANCE
        if np.all(done):
            break
        point, stuck = problem.step(point, mu, done)
        # Rounding leaves nothing to gain: the next step would be the same.
        done |= stuck
    y = point.y
    return ClosestPoints(
        point.s[:, : a.dim], point.s[:, a.dim :], y[:, : a.count], y[:, a.count :],
        _largest(point.residual(mu)),
    )  # fmt: skip


@dataclass(frozen=True)
class _Point:
    """An iterate: points s, slacks and multipliers y above zero, and how far they are off.

    Attributes:
        dual: gradient of the Lagrangian (n, da + db).
        primal: f + slack (n, m).
        J: Jacobian of f (n, m, da + db).
    """

    s: Array
    slack: Array
    y: Array
    dual: Array
    primal: Array
    J: Array

    def residual(self, mu: Array) -> Array:
        """(n, da + db + 2 m)."""
        return np.concatenate([self.dual, self.primal, self.slack * self.y - mu], axis=1)


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

    def at(self, s: Array, slack: Array, y: Array) -> _Point:
        f, J = self.functions(s)
        delta = self.offset + _times(self.slope, s)
        pull = 2.0 / self.unit_m2 * _times(np.swapaxes(self.slope, 1, 2), delta)
        return _Point(s, slack, y, pull + _times(np.swapaxes(J, 1, 2), y), f + slack, J)

    def step(self, point: _Point, mu: Array, done: Mask) -> tuple[_Point, Mask]:
        """A damped Newton step on every problem that is not done, as long as it may be.

        And which of them found no step that gains.
        """
        mu = np.maximum(mu, CENTRING * np.mean(point.slack * point.y, axis=1, keepdims=True))
        ds, d_slack, dy = self._direction(point, mu)
        before = _length(point.residual(mu))
        alpha = np.minimum(_reach(point.slack, d_slack), _reach(point.y, dy))
        alpha[done] = 0.0
        for _ in range(HALVINGS):
            a = alpha[:, None]
            new = self.at(point.s + a * ds, point.slack + a * d_slack, point.y + a * dy)
            worse = (_length(new.residual(mu)) > (1.0 - DECREASE * alpha) * before) & ~done
            if not worse.any():
                break
            alpha = np.where(worse, 0.5 * alpha, alpha)
        return new, np.asarray(worse)

    def _direction(self, point: _Point, mu: Array) -> tuple[Array, Array, Array]:
        """Newton's step in s, slack and y."""
        slope_t, J_t = np.swapaxes(self.slope, 1, 2), np.swapaxes(point.J, 1, 2)
        slack, y = point.slack, point.y
        central = slack * y - mu
        H = 2.0 / self.unit_m2 * slope_t @ self.slope + self._curvature(point.s, y)
        H = H + J_t @ ((y / slack)[..., None] * point.J)
        damping = CONVEX + DAMPING * np.minimum(_largest(point.residual(mu)), 1.0)
        H = H + damping[:, None, None] * np.eye(H.shape[-1])
        right = -point.dual - _times(J_t, (y * point.primal - central) / slack)
        ds = np.asarray(np.linalg.solve(H, right[..., None])[..., 0], dtype=np.float64)
        d_slack = -point.primal - _times(point.J, ds)
        return ds, d_slack, -(central + y * d_slack) / slack

    def _curvature(self, s: Array, y: Array) -> Array:
        a, b = self.a, self.b
        W = np.zeros((len(s), a.dim + b.dim, a.dim + b.dim))
        W[:, : a.dim, : a.dim] = a.curvature(s[:, : a.dim], y[:, : a.count])
        W[:, a.dim :, a.dim :] = b.curvature(s[:, a.dim :], y[:, a.count :])
        return W


def _times(matrix: Array, vector: Array) -> Array:
    return np.asarray(np.einsum("nij,nj->ni", matrix, vector))


def _reach(value: Array, step: Array) -> Array:
    """The longest step (n,) up to 1 that keeps ``value`` (n, m) above zero."""
    falls = step < 0.0
    ratio = np.where(falls, -TO_BOUNDARY * value / np.where(falls, step, -1.0), 1.0)
    return np.asarray(np.minimum(1.0, np.min(ratio, axis=1)))


def _length(rows: Array) -> Array:
    return np.asarray(np.linalg.norm(rows, axis=1), dtype=np.float64)


def _largest(rows: Array) -> Array:
    return np.asarray(np.max(np.abs(rows), axis=1))
