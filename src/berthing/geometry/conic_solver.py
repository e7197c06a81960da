"""Linear objectives over conic forms, many at a time: small problems, solved to 1e-11.

A primal-dual interior-point method with Nesterov and Todd's scaling and Mehrotra's corrector
(Vandenberghe, *The CVXOPT linear and quadratic cone program solvers*, 2010, section 5). Problems
have three to ten variables and a few cones, so that NumPy does a batch of them at once; a general
solver would take one at a time, and none is among the package's dependencies.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.conic_standard import Standard
from berthing.geometry.second_order_cone import (
    Scaling,
    inverse_step,
    product,
    quotient,
    root_determinant,
    tail_length,
)

# Of the gap and all residuals, with lengths in terms of the problem's own.
TOLERANCE = 1e-13
# Once below this, an iteration that gains nothing is the last: rounding allows no more.
ENOUGH = 1e-10
# A dozen are usual. What has not converged by then is as good as it gets.
MAX_ITERATIONS = 40
# Of the way to the cone's boundary.
STEP_FRACTION = 0.99


@dataclass(frozen=True, eq=False)
class Optimum:
    """Solutions of a batch of k problems.

    Attributes:
        point: (k, size) in metres; members, to rounding.
        dual: (k,): no member has a lower objective than this, in metres.
        line_dual, cone_dual: multipliers of the half-lines (k, m) and of the cones (k, cones, p).
    """

    point: Array
    dual: Array
    line_dual: Array
    cone_dual: Array


def minimise(problem: Standard, objective: Array) -> Optimum:
    """min objective·z over the set, for objectives (k, size) of length about 1.

    The set must be bounded and have an interior, or the answer is worthless.
    """
    state = _start(problem, objective)
    best = state
    at = np.arange(len(objective))
    worst = np.full(len(objective), np.inf)
    for _ in range(MAX_ITERATIONS):
        residuals = _residuals(state)
        better = residuals.worst < worst[at]
        best = _put(best, at[better], _take(state, better))
        worst[at[better]] = residuals.worst[better]
        stalled = ~better & (worst[at] <= ENOUGH)
        # What rounding has turned into NaN leaves too.
        going = (residuals.worst > TOLERANCE) & ~stalled & _interior(state)
        if not going.any():
            break
        at = at[going]
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            state = _stepped(_take(state, going), _take(residuals, going))
    return _optimum(best)


@dataclass(frozen=True, eq=False)
class _State:
    """A batch: the problem, its objective, z, slacks and multipliers of lines and cones."""

    problem: Standard
    c: Array
    z: Array
    line_s: Array
    cone_s: Array
    line_y: Array
    cone_y: Array


@dataclass(frozen=True, eq=False)
class _Residuals:
    gap: Array
    dual: Array
    line: Array
    cone: Array
    worst: Array


def _start(problem: Standard, c: Array) -> _State:
    """Least-squares points, moved into the cones."""
    k = len(c)
    cone_G = np.broadcast_to(problem.cone_G, (k, *problem.cone_G.shape[-3:]))
    cone_h = np.broadcast_to(problem.cone_h, (k, *problem.cone_h.shape[-2:]))
    problem = replace(problem, cone_G=cone_G, cone_h=cone_h)
    G = problem.line_G
    normal = G.T @ G + np.einsum("kbpi,kbpj->kij", cone_G, cone_G)
    right = G.T @ problem.line_h + np.einsum("kbpi,kbp->ki", cone_G, cone_h)
    z = np.linalg.solve(normal, right[..., None])[..., 0]
    y = np.linalg.solve(normal, -c[..., None])[..., 0]
    line_s, cone_s = problem.line_h - z @ G.T, cone_h - np.einsum("kbpi,ki->kbp", cone_G, z)
    line_y, cone_y = y @ G.T, np.einsum("kbpi,ki->kbp", cone_G, y)
    for line, cone in ((line_s, cone_s), (line_y, cone_y)):
        outside = np.concatenate([-line, tail_length(cone) - cone[..., 0]], axis=-1).max(axis=-1)
        shift = np.where(outside < 0.0, 0.0, 1.0 + outside)
        line += shift[:, None]
        cone[..., 0] += shift[:, None]
    return _State(problem, c, z, line_s, cone_s, line_y, cone_y)


def _residuals(v: _State) -> _Residuals:
    p = v.problem
    gap = np.sum(v.line_s * v.line_y, axis=-1) + np.sum(v.cone_s * v.cone_y, axis=(-1, -2))
    dual = v.c + v.line_y @ p.line_G + np.einsum("kbpi,kbp->ki", p.cone_G, v.cone_y)
    line = v.z @ p.line_G.T + v.line_s - p.line_h
    cone = np.einsum("kbpi,ki->kbp", p.cone_G, v.z) + v.cone_s - p.cone_h
    size = np.maximum(1.0, np.max(np.abs(v.z), axis=-1))
    primal = np.concatenate([line, cone.reshape(len(cone), -1)], axis=-1)
    worst = np.maximum(gap, np.max(np.abs(dual), axis=-1))
    worst = np.maximum(worst, np.max(np.abs(primal), axis=-1, initial=0.0)) / size
    return _Residuals(gap, dual, line, cone, worst)


def _interior(v: _State) -> Any:
    """Whether a batch member can go on: inside all cones, by more than nothing."""
    lines = np.min(np.concatenate([v.line_s, v.line_y], axis=-1), axis=-1, initial=np.inf)
    cones = np.concatenate([root_determinant(v.cone_s), root_determinant(v.cone_y)], axis=-1)
    return (lines > 0.0) & (np.min(cones, axis=-1, initial=np.inf) > 0.0)


def _stepped(v: _State, at: _Residuals) -> _State:
    """One step: towards the optimum first, to see how much to centre, then both at once."""
    newton = _Newton(v)
    ahead = newton.solve(at, 1.0, -(newton.line**2), -product(newton.cone, newton.cone))
    length = np.minimum(1.0, 1.0 / np.maximum(ahead.inverse, 1.0))
    centring = (1.0 - length) ** 3
    target = centring * at.gap / v.problem.degree
    line = -(newton.line**2) - ahead.line_s * ahead.line_y + target[:, None]
    cone = -product(newton.cone, newton.cone) - product(ahead.cone_s, ahead.cone_y)
    cone[..., 0] += target[:, None]
    step = newton.solve(at, 1.0 - centring, line, cone)
    return newton.moved(step, np.minimum(1.0, STEP_FRACTION / np.maximum(step.inverse, 1e-30)))


@dataclass(frozen=True, eq=False)
class _Step:
    """A direction; slacks and multipliers in scaled terms; 1 over the length that it may have."""

    z: Array
    line_s: Array
    cone_s: Array
    line_y: Array
    cone_y: Array
    inverse: Array


class _Newton:
    """The linearised optimality conditions at one state, factored once.

    With W from the slacks s and multipliers y, λ = W y = W⁻¹ s: the step solves Gᵀ dy = −r_dual,
    G dz + ds = −r_primal and λ ∘ (W dy + W⁻¹ ds) = b. QR of W⁻¹ G keeps the accuracy that its
    normal equations would lose.
    """

    def __init__(self, v: _State) -> None:
        self.v = v
        self.weight = np.sqrt(v.line_s / v.line_y)
        self.scaling = Scaling.of(v.cone_s, v.cone_y)
        self.line = np.sqrt(v.line_s * v.line_y)
        self.cone = self.scaling.apply(v.cone_y)
        k, cones, p = v.cone_s.shape
        size = v.z.shape[-1]
        lines = v.problem.line_G / self.weight[..., None]
        rows = self.scaling.unapply_columns(v.problem.cone_G).reshape(k, cones * p, size)
        self.G = np.concatenate([lines, rows], axis=1)
        self.Q, self.R = np.linalg.qr(self.G)

    def solve(self, at: _Residuals, share: Array | float, line: Array, cone: Array) -> _Step:
        """The step that removes ``share`` (k,) of the residuals and has λ ∘ (…) = line, cone."""
        k, m = self.line.shape
        share = np.broadcast_to(share, (k,))[:, None]
        line, cone = line / self.line, quotient(self.cone, cone)
        u_line = -share * at.line / self.weight - line
        u_cone = -share[..., None] * self.scaling.unapply(at.cone) - cone
        u = np.concatenate([u_line, u_cone.reshape(k, -1)], axis=-1)
        right = np.linalg.solve(np.swapaxes(self.R, -1, -2), -share[..., None] * at.dual[..., None])
        right += np.einsum("kri,kr->ki", self.Q, u)[..., None]
        dz = np.linalg.solve(self.R, right)[..., 0]
        y = np.einsum("kri,ki->kr", self.G, dz) - u
        line_y, cone_y = y[:, :m], y[:, m:].reshape(cone.shape)
        line_s, cone_s = line - line_y, cone - cone_y
        lines = [-line_y / self.line, -line_s / self.line]
        cones = [inverse_step(self.cone, cone_y), inverse_step(self.cone, cone_s)]
        inverse = np.max(np.concatenate([*lines, *cones], axis=-1), axis=-1)
        return _Step(dz, line_s, cone_s, line_y, cone_y, inverse)

    def moved(self, step: _Step, length: Array) -> _State:
        v, t, t_cone = self.v, length[:, None], length[:, None, None]
        return replace(
            v,
            z=v.z + t * step.z,
            line_s=v.line_s + t * step.line_s * self.weight,
            line_y=v.line_y + t * step.line_y / self.weight,
            cone_s=v.cone_s + t_cone * self.scaling.apply(step.cone_s),
            cone_y=v.cone_y + t_cone * self.scaling.unapply(step.cone_y),
        )


def _optimum(v: _State) -> Optimum:
    """The duals made feasible, and what they prove.

    For y in K, c·z ≥ −h·y + (c + Gᵀy)·z for every member z, and z is no longer than ``reach``.
    """
    p = v.problem
    line_y, cone_y = np.maximum(v.line_y, 0.0), v.cone_y.copy()
    cone_y[..., 0] = np.maximum(cone_y[..., 0], tail_length(cone_y))
    left = v.c + line_y @ p.line_G + np.einsum("kbpi,kbp->ki", p.cone_G, cone_y)
    dual = -line_y @ p.line_h - np.sum(cone_y * p.cone_h, axis=(-1, -2))
    dual -= np.linalg.norm(left, axis=-1) * p.reach
    return Optimum(v.z * p.unit, dual * p.unit, line_y, cone_y)


def _take(batch: Any, index: Any) -> Any:
    """The chosen members of a batch."""
    chosen = {
        name: value[index]
        for name, value in vars(batch).items()
        if isinstance(value, np.ndarray) and name != "line_G" and name != "line_h"
    }
    if isinstance(batch, _State):
        chosen["problem"] = replace(
            batch.problem,
            cone_G=batch.problem.cone_G[index],
            cone_h=batch.problem.cone_h[index],
        )
    return replace(batch, **chosen)


def _put(batch: _State, index: Any, members: _State) -> _State:
    """The batch with some members replaced."""
    fields = ("z", "line_s", "cone_s", "line_y", "cone_y")
    for name in fields:
        getattr(batch, name)[index] = getattr(members, name)
    return batch
