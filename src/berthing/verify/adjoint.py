"""Costates carried back along a trajectory by the adjoint equations, jumps at rows included.

λ̇ = −∂H/∂x is linear in λ where x(t) and u(t) are given, so that between two nodes the costate at
the begin is a matrix times the one at the end, and an offset.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.phase import Phase
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import SeparationCostate, VehicleNodes, VehicleTrajectory
from berthing.verify.equations import Derivative
from berthing.verify.lagrangian import (
    AT_NODE,
    Pulls,
    hamiltonian_of,
    path_value,
    ranges,
    slope,
    slopes,
)

STAGES = 2
"""Gauss points to a stretch: the order is four."""

_POINTS, _WEIGHTS = np.polynomial.legendre.leggauss(STAGES)
_NODES, WEIGHTS = 0.5 * (_POINTS + 1.0), 0.5 * _WEIGHTS
_POWERS = np.arange(STAGES)
TABLEAU = (_NODES[:, None] ** (_POWERS + 1) / (_POWERS + 1)) @ np.linalg.inv(
    _NODES[:, None] ** _POWERS
)
"""Of Gauss' collocation at these."""

MINOR = 1e-4
"""Of the largest jump: ones below are taken at the node that ends their interval, so that the many
rows that hardly pull do not cut it up."""

Jump = tuple[float, Array]
"""When, and what the costate before has more than the one after (nx,)."""


@dataclass(frozen=True)
class Stage:
    """A Gauss point between two nodes: its costate is ``back`` times that at the end of the
    interval, and ``offset``; ``weight_s`` is of the integral over time, ``defect`` ẋ − f (nx,)."""

    t: float
    weight_s: float
    x: Array
    u: Array
    defect: Array
    back: Array
    offset: Array

    def costate(self, end: Array) -> Array:
        """Where the interval ends with the costate ``end``."""
        return np.asarray(self.back @ end + self.offset)


@dataclass(frozen=True)
class Arc:
    """The interval between two nodes: costates (nx,) at its begin from those at its end."""

    back: Array
    offset: Array
    stages: tuple[Stage, ...]

    def begin(self, end: Array) -> Array:
        """The costate at the begin."""
        return np.asarray(self.back @ end + self.offset)


def jumps_of(rows: Sequence[SeparationCostate], vehicle: str) -> list[Jump]:
    """What separation rows do to one vehicle's costates."""
    return [(row.time_s, row.jumps[vehicle]) for row in rows if vehicle in row.jumps]


def arcs(
    phase: Phase, vehicle: Vehicle, nodes: VehicleNodes, trajectory: VehicleTrajectory,
    jumps: Sequence[Jump], rates: Derivative,
) -> list[Arc]:  # fmt: skip
    """One for every interval between nodes; ``rates`` are the vehicle's equations of motion.

    A row at the time of a node, which begins a segment, belongs to the interval before it.
    """
    work = _Adjoint(phase, vehicle, nodes, trajectory, rates)
    times = nodes.times_s
    near = AT_NODE * (times[-1] - times[0])
    least = MINOR * max((work.size_of(jump) for _, jump in jumps), default=0.0)
    inner: list[list[Jump]] = [[] for _ in times]
    for t, jump in jumps:
        i = int(np.searchsorted(times, t - near))
        if 0 < i < len(times):
            inner[i].append((t if work.size_of(jump) > least else float(times[i]), jump))
    return [
        work.arc(float(a), float(b), own, near)
        for a, b, own in zip(times[:-1], times[1:], inner[1:], strict=True)
    ]


def misses(nodes: VehicleNodes, found: Sequence[Arc]) -> Array:
    """What costates at nodes have more than the adjoint equations make of the next (k − 1, nx)."""
    ends = zip(found, nodes.costates[:-1], nodes.costates[1:], strict=True)
    return np.array([before - arc.begin(after) for arc, before, after in ends])


def carried_back(nodes: VehicleNodes, found: Sequence[Arc]) -> VehicleNodes:
    """The nodes with the costates that follow from the last."""
    costates = [nodes.costates[-1]]
    for arc in reversed(found):
        costates.append(arc.begin(costates[-1]))
    return replace(nodes, costates=np.array(costates[::-1]))


class _Adjoint:
    """The adjoint equations of one vehicle along its trajectory: λ̇ = −Aᵀ λ − q."""

    def __init__(
        self, phase: Phase, vehicle: Vehicle, nodes: VehicleNodes, trajectory: VehicleTrajectory,
        rates: Derivative,
    ) -> None:  # fmt: skip
        self.trajectory = trajectory
        self.rates = rates
        self.pulls = Pulls.of(vehicle, nodes, trajectory)
        self.range = ranges(vehicle.model.state_names, np.ptp(nodes.states, axis=0))
        self.columns = len(self.range)
        own_cost = any(cost.vehicle == vehicle.name for cost in phase.cost.running)
        self.cost = hamiltonian_of(phase, vehicle, rates) if own_cost else None

    def size_of(self, jump: Array) -> float:
        """In units of the cost, each component by its range."""
        return float(np.max(np.abs(jump) * self.range))

    def arc(self, begin: float, end: float, jumps: Sequence[Jump], near: float) -> Arc:
        """The interval from ``begin`` to ``end``."""
        later = sorted({t for t, _ in jumps if t < end - near}, reverse=True)
        edges = [end, *later, begin]
        back, offset = np.eye(self.columns), np.zeros(self.columns)
        stages: list[Stage] = []
        for high, low in pairwise(edges):
            offset = offset + sum(
                (jump for t, jump in jumps if abs(t - high) <= near), np.zeros(self.columns)
            )
            step, shift, inner = self._stretch(high, low)
            stages += [
                replace(s, back=s.back @ back, offset=s.back @ offset + s.offset) for s in inner
            ]
            back, offset = step @ back, step @ offset + shift
        return Arc(back, offset, tuple(stages))

    def _stretch(self, high: float, low: float) -> tuple[Array, Array, list[Stage]]:
        """Without jumps: matrix and offset from ``high`` back to ``low``, and its stages."""
        n, h = self.columns, high - low
        t = high - h * _NODES
        x, u, rate = (
            of(t)
            for of in (self.trajectory.state, self.trajectory.control, self.trajectory.state_rate)
        )
        linear, constant = zip(*(self._terms(*at) for at in zip(t, x, u, strict=True)), strict=True)
        matrix = np.eye(STAGES * n)
        right = np.zeros((STAGES * n, n + 1))
        for i in range(STAGES):
            mine = slice(i * n, (i + 1) * n)
            right[mine, :n] = np.eye(n)
            for j in range(STAGES):
                matrix[mine, j * n : (j + 1) * n] -= h * TABLEAU[i, j] * linear[j]
                right[mine, n] += h * TABLEAU[i, j] * constant[j]
        at: Array = np.asarray(np.linalg.solve(matrix, right), np.float64).reshape(STAGES, n, n + 1)
        total = np.eye(n, n + 1)
        for weight, own, extra, here in zip(WEIGHTS, linear, constant, at, strict=True):
            total = total + h * weight * (own @ here)
            total[:, n] += h * weight * extra
        stages = [
            Stage(
                float(t[i]),
                h * WEIGHTS[i],
                x[i],
                u[i],
                rate[i] - self.rates(float(t[i]), x[i], u[i]),
                at[i, :, :n],
                at[i, :, n],
            )
            for i in range(STAGES)
        ]
        return total[:, :n], total[:, n], stages

    def _terms(self, t: float, x: Array, u: Array) -> tuple[Array, Array]:
        """Aᵀ (nx, nx) and q (nx,)."""
        jacobian = slopes(lambda at: self.rates(float(t), at, u), x, self.range)
        constant = np.zeros(self.columns)
        if self.cost is not None:
            cost, none = self.cost, np.zeros(self.columns)
            constant += slope(lambda at: cost(float(t), at, u, none), x, self.range)
        if self.pulls.any:
            state, _, path = self.pulls.at(float(t))
            constant += state
            if path:
                constant += slope(lambda at: path_value(path, float(t), at, u), x, self.range)
        return jacobian.T, constant
