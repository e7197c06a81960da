"""A primal-dual interior-point method with a filter line search, for small programmes solved often.

After A. Wächter and L. T. Biegler, Mathematical Programming 106 (2006), 10.1007/s10107-004-0559-y,
the method of IPOPT: its barrier, its inertia correction, its filter, its second-order corrections.
What differs is the linear algebra, which is nine tenths of IPOPT's time at these sizes; starts
from an answer, with slacks and multipliers near the central path; and what happens where no step
is acceptable: steps of least length towards the linearised rows until the filter takes the point,
in place of a programme of its own. Where those fail too, so does the method; IPOPT is then asked.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, replace

import numpy as np

from berthing.geometry.arrays import Array
from berthing.solve.barrier import PUSH, Bounds, longest
from berthing.solve.evaluation import Evaluation
from berthing.solve.filter import Filter, Merit
from berthing.solve.kkt_matrix import KktMatrix

SOLVED, STUCK, ITERATIONS, OUT_OF_TIME = "solved", "stuck", "iterations", "out of time"

FEWER, FASTER = 0.2, 1.5
"""The barrier falls to the lesser of FEWER μ and μ^FASTER (κ_μ and θ_μ)."""

CLOSE_ENOUGH = 10.0
"""A barrier problem is solved where its error is below this many μ (κ_ε)."""

KEEP = 0.99
"""A step uses up at most this share of a distance (τ_min)."""

LARGE = 100.0
"""Mean multiplier from which errors are measured relative to it (s_max)."""

DUAL_SHIFT = 1e-8
"""E of equalities: keeps the matrix quasi-definite; the right-hand side takes it out again."""

LEAST_SHIFT, MOST_SHIFT = 1e-6, 1e20
"""Between which δ stays. Planes that touch nothing are held by the regulariser alone: without a
least δ a step may fling them about, and on Scenario A one solve in three takes twice as long."""

GROW, SHRINK = 8.0, 1.0 / 3.0
"""Factors of δ where the inertia is wrong, and from step to step."""

TINY = 1e-20
"""Above zero, to divide by."""

NEAR_CENTRE = 1e10
"""z d is kept within μ over and μ times this (κ_Σ)."""

CORRECTIONS, GOOD_CORRECTION = 4, 0.99
"""Second-order corrections of a step; one that leaves more than this share is the last."""

SHORTEST = 1e-8
"""Steps shorter than this are not worth trying."""

USELESS = 1e3
"""Least-squares multipliers above this are dropped."""

RECOVERY_STEPS, RECOVERED = 30, 0.9
"""Steps towards the rows alone, and the share of infeasibility below which they may end."""


@dataclass(frozen=True)
class Settings:
    """How to solve.

    Attributes:
        barrier: μ to begin with.
        tolerance: of the scaled optimality conditions.
        push: how far slacks begin inside their bounds.
        seconds: wall time allowed.
    """

    barrier: float = 0.1
    tolerance: float = 1e-8
    iterations: int = 150
    push: float = PUSH
    seconds: float = 1e6


@dataclass(frozen=True)
class Point:
    """An iterate.

    Attributes:
        x: variables (n,). s: slacks (m,).
        y, z: multipliers of rows (m,) and of their bounds (k,).
        f, g: objective and rows (m,) at x.
    """

    x: Array
    s: Array
    y: Array
    z: Array
    f: float
    g: Array


@dataclass(frozen=True)
class Found:
    """Where a solve ended."""

    status: str
    point: Point
    iterations: int
    error: float


@dataclass(frozen=True)
class _Step:
    """Changes of x and s, and the multipliers themselves that go with them."""

    x: Array
    s: Array
    y: Array


class InteriorPoint:
    """One programme, to be solved as often as wanted."""

    def __init__(self, evaluation: Evaluation, lower: Array, upper: Array) -> None:
        self._evaluation = evaluation
        self._bounds = Bounds.of(lower, upper)
        self._matrix = KktMatrix(evaluation.hessian, evaluation.jacobian)

    def solve(
        self, x: Array, parameters: Array, settings: Settings, multipliers: Array | None = None
    ) -> Found:
        """Solve from x (n,), and from multipliers of the rows (m,) where there are any."""
        self._evaluation.at(parameters)
        run = _Run(self._evaluation, self._bounds, self._matrix, settings)
        with np.errstate(all="ignore"):
            # A step may leave where things are defined; the filter takes no such point.
            return run.run(x, multipliers)


class _Run:
    """One solve."""

    def __init__(
        self, evaluation: Evaluation, bounds: Bounds, matrix: KktMatrix, settings: Settings
    ) -> None:
        self.evaluation, self.settings = evaluation, settings
        self.bounds, self.matrix = bounds, matrix
        self.mu, self.shift = settings.barrier, LEAST_SHIFT
        self.corner = np.where(bounds.equal, DUAL_SHIFT, 1.0)
        self.gradient = np.zeros(matrix.variables)

    def run(self, x: Array, multipliers: Array | None) -> Found:
        began = time.monotonic()
        point = self._begin(x, multipliers)
        filter_ = Filter(self._merit(point).theta)
        for iteration in range(self.settings.iterations + 1):
            error = self._error(point, 0.0)
            if error <= self.settings.tolerance:
                return Found(SOLVED, point, iteration, error)
            if time.monotonic() - began > self.settings.seconds:
                return Found(OUT_OF_TIME, point, iteration, error)
            if self._lower_barrier(point):
                filter_.clear()
            moved = self._advance(point, filter_) or self._recover(point, filter_)
            if moved is None:
                return Found(STUCK, point, iteration, error)
            point = self._linearise(moved)
        return Found(ITERATIONS, point, self.settings.iterations, error)

    def _begin(self, x: Array, multipliers: Array | None) -> Point:
        f, g = self.evaluation.value(x)
        s = self.bounds.inside(g, self.settings.push)
        d = self.bounds.distance(s)
        if multipliers is None:
            z = np.ones(len(d))
            y = self._least_squares(x, z)
        else:
            z, y = np.maximum(self.bounds.multiplier(multipliers), self.mu / d), multipliers
        return self._linearise(Point(x, s, y, z, f, g))

    def _least_squares(self, x: Array, z: Array) -> Array:
        """Row multipliers for which the Lagrangian's gradient is least."""
        gradient, jacobian, hessian = self.evaluation.derivatives(x, np.zeros(self.matrix.rows))
        self.matrix.fill(0.0 * hessian, jacobian)
        equal = self.bounds.equal
        side = self.bounds.gather(self.bounds.sign * z)
        plain = np.where(equal, 0.0, -side)
        if not self.matrix.factorise(1.0, self.corner):
            return plain
        right = np.concatenate([-gradient, -plain])
        y = self.matrix.solve(right)[self.matrix.variables :]
        good = np.all(np.isfinite(y)) and _largest(y) <= USELESS
        return y if good else plain

    def _linearise(self, point: Point) -> Point:
        """Derivatives at ``point``; its multipliers are kept near the central path."""
        self.gradient, jacobian, hessian = self.evaluation.derivatives(point.x, point.y)
        self.matrix.fill(hessian, jacobian)
        centre = self.mu / self.bounds.distance(point.s)
        return replace(point, z=np.clip(point.z, centre / NEAR_CENTRE, centre * NEAR_CENTRE))

    def _error(self, point: Point, mu: float) -> float:
        """The largest error of the optimality conditions for the barrier ``mu``."""
        bounds, y, z = self.bounds, point.y, point.z
        total = float(np.sum(z))
        mean = (float(np.sum(np.abs(y))) + total) / max(len(y) + len(z), 1)
        dual = _largest(self.gradient + self.matrix.transposed_times(y))
        slack = _largest(np.where(bounds.equal, 0.0, y + bounds.gather(bounds.sign * z)))
        centre = _largest(bounds.distance(point.s) * z - mu)
        return max(
            max(dual, slack) * LARGE / max(LARGE, mean),
            _largest(point.g - point.s),
            centre * LARGE / max(LARGE, total / max(len(z), 1)),
        )

    def _lower_barrier(self, point: Point) -> bool:
        least, lowered = 0.1 * self.settings.tolerance, False
        while self.mu > least and self._error(point, self.mu) <= CLOSE_ENOUGH * self.mu:
            self.mu = max(least, min(FEWER * self.mu, self.mu**FASTER))
            lowered = True
        return lowered

    def _merit(self, point: Point) -> Merit:
        barrier = self.mu * float(np.sum(np.log(self.bounds.distance(point.s))))
        return Merit(float(np.sum(np.abs(point.g - point.s))), point.f - barrier)

    def _advance(self, point: Point, filter_: Filter) -> Point | None:
        """One step, as far as the filter takes it; None where it takes none."""
        bounds = self.bounds
        d = bounds.distance(point.s)
        pull = bounds.gather(bounds.sign * self.mu / d)
        weight = np.maximum(bounds.gather(point.z / d), TINY)
        if not self._factorise(np.where(bounds.equal, DUAL_SHIFT, 1.0 / weight)):
            return None
        step = self._newton(point, point.g - point.s, pull)
        moved = self._search(point, step, pull, filter_)
        if moved is None:
            return None
        dz = (self.mu - point.z * bounds.sign * step.s[bounds.row]) / d - point.z
        return replace(moved, z=point.z + longest(point.z, dz, self._keep) * dz)

    @property
    def _keep(self) -> float:
        return max(KEEP, 1.0 - self.mu)

    def _factorise(self, corner: Array) -> bool:
        """Factorise with the least shift, of those tried, that makes steps descend.

        The last one, somewhat less, is tried first: most steps then take one factorisation.
        """
        self.corner = corner
        shift = max(SHRINK * self.shift, LEAST_SHIFT)
        while not self.matrix.factorise(shift, corner):
            shift = max(GROW * shift, self.shift)
            if shift > MOST_SHIFT:
                return False
        self.shift = shift
        return True

    def _newton(self, point: Point, short: Array, pull: Array) -> _Step:
        """The step that makes up for rows that are off by ``short`` (m,)."""
        equal, n = self.bounds.equal, self.matrix.variables
        offset = np.where(equal, -DUAL_SHIFT * point.y, self.corner * pull)
        found = self.matrix.solve(np.concatenate([-self.gradient, offset - short]))
        y = found[n:]
        return _Step(found[:n], np.where(equal, 0.0, self.corner * (y + pull)), y)

    def _search(self, point: Point, step: _Step, pull: Array, filter_: Filter) -> Point | None:
        """The longest step that the filter takes; at full length it may be corrected."""
        here = self._merit(point)
        slope = float(self.gradient @ step.x - pull @ step.s)
        full = length = self._room(point, step)
        while length >= SHORTEST and np.isfinite(slope):
            trial = self._trial(point, step, length)
            there = self._merit(trial)
            if filter_.takes(here, there, length, slope):
                return trial
            if length == full and there.theta >= here.theta:
                short = length * (point.g - point.s)
                for _ in range(CORRECTIONS):
                    short = short + trial.g - trial.s
                    better = self._newton(point, short, pull)
                    room = self._room(point, better)
                    trial, before = self._trial(point, better, room), there
                    there = self._merit(trial)
                    if filter_.takes(here, there, length, slope):
                        return trial
                    if not there.theta <= GOOD_CORRECTION * before.theta:
                        break
                    short = room * short
            length *= 0.5
        return None

    def _room(self, point: Point, step: _Step) -> float:
        """The longest step that leaves slacks inside their bounds."""
        bounds = self.bounds
        return longest(bounds.distance(point.s), bounds.sign * step.s[bounds.row], self._keep)

    def _trial(self, point: Point, step: _Step, length: float) -> Point:
        x, s = point.x + length * step.x, point.s + length * step.s
        f, g = self.evaluation.value(x)
        return Point(x, s, point.y + length * (step.y - point.y), point.z, f, g)

    def _recover(self, point: Point, filter_: Filter) -> Point | None:
        """Steps of least length towards the rows, until the filter takes the point again."""
        first = self._merit(point)
        filter_.remember(first)
        now = point
        for _ in range(RECOVERY_STEPS):
            nearer = self._nearer(now)
            if nearer is None:
                return None
            now = nearer
            merit = self._merit(now)
            if merit.theta <= RECOVERED * first.theta and filter_.admits(merit):
                d = self.bounds.distance(now.s)
                z = self.mu / d
                return replace(now, z=z, y=self._least_squares(now.x, z))
        return None

    def _nearer(self, point: Point) -> Point | None:
        """One step that lessens the infeasibility by moving x and s as little as it takes."""
        bounds = self.bounds
        _, jacobian, hessian = self.evaluation.derivatives(point.x, np.zeros(self.matrix.rows))
        self.matrix.fill(0.0 * hessian, jacobian)
        d = bounds.distance(point.s)
        near = 1.0 / np.maximum(bounds.gather(1.0 / d**2), TINY)
        corner = np.where(bounds.equal, DUAL_SHIFT, near)
        if not self.matrix.factorise(1.0, corner):
            return None
        n = self.matrix.variables
        found = self.matrix.solve(np.concatenate([np.zeros(n), point.s - point.g]))
        step = _Step(found[:n], np.where(bounds.equal, 0.0, corner * found[n:]), point.y)
        here, length = self._merit(point).theta, self._room(point, step)
        while length >= 1e-6:
            trial = self._trial(point, step, length)
            if self._merit(trial).theta <= (1.0 - 1e-4 * length) * here:
                return trial
            length *= 0.5
        return None


def _largest(values: Array) -> float:
    return float(np.max(np.abs(values), initial=0.0))
