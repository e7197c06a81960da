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
from berthing.verify.equations import derivatives
from berthing.verify.lagrangian import (
    AT_NODE,
    Path,
    Pulls,
    path_value,
    positions_of,
    ranges_of,
    running_of,
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
    interval, and ``offset``; ``weight_s`` is of the integral over time, ``defect`` ẋ − f (nx,),
    ``gain`` ∂f/∂u (nx, nu), and ``pulls`` are as ``Pulls`` has them."""

    t: float
    weight_s: float
    x: Array
    u: Array
    defect: Array
    gain: Array
    pulls: tuple[Array, Array, Path]
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
    jumps: Sequence[Jump],
) -> list[Arc]:  # fmt: skip
    """One for every interval between nodes.

    A row at the time of a node, which begins a segment, belongs to the interval before it.
    """
    work = _Adjoint(phase, vehicle, nodes, trajectory)
    times = nodes.times_s
    near = AT_NODE * (times[-1] - times[0])
    least = MINOR * max((work.size_of(jump) for _, jump in jumps), default=0.0)
    inner: list[list[Jump]] = [[] for _ in times]
    for t, jump in jumps:
        i = int(np.searchsorted(times, t - near))
        if 0 < i < len(times):
            inner[i].append((t if work.size_of(jump) > least else float(times[i]), jump))
    edges = [
        [float(b), *sorted({t for t, _ in own if t < b - near}, reverse=True), float(a)]
        for a, b, own in zip(times[:-1], times[1:], inner[1:], strict=True)
    ]
    work.prepare([stretch for own in edges for stretch in pairwise(own)])
    return [work.arc(own, found, near) for own, found in zip(edges, inner[1:], strict=True)]


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


@dataclass(frozen=True)
class _Numbers:
    """What a stretch's stages are made of, one entry a stage each."""

    t: Array
    x: Array
    u: Array
    defect: Array
    linear: Array
    constant: Array
    gain: Array
    pulls: list[tuple[Array, Array, Path]]


class _Adjoint:
    """The adjoint equations of one vehicle along its trajectory: λ̇ = −Aᵀ λ − q."""

    def __init__(
        self, phase: Phase, vehicle: Vehicle, nodes: VehicleNodes, trajectory: VehicleTrajectory
    ) -> None:
        self.vehicle, self.trajectory = vehicle, trajectory
        self.pulls = Pulls.of(vehicle, nodes, trajectory)
        self.range, self.control_range = ranges_of(vehicle, nodes)
        self.columns = len(self.range)
        self.running = running_of(phase, vehicle)
        self.numbers: dict[tuple[float, float], _Numbers] = {}

    def size_of(self, jump: Array) -> float:
        """In units of the cost, each component by its range."""
        return float(np.max(np.abs(jump) * self.range))

    def prepare(self, stretches: Sequence[tuple[float, float]]) -> None:
        """Everything along the way at the stages of all stretches (high, low), at once."""
        high, low = np.array(stretches).reshape(-1, 2).T
        t = (high[:, None] - (high - low)[:, None] * _NODES).ravel()
        x, u = self.trajectory.state(t), self.trajectory.control(t)
        rates = derivatives(self.vehicle.model)
        defect = self.trajectory.state_rate(t) - rates(t, x, u)
        skip = positions_of(self.vehicle)
        linear = slopes(lambda at: rates(t, at, u), x, self.range, skip)
        gain = slopes(lambda at: rates(t, x, at), u, self.control_range)
        pulls = [self.pulls.at(float(at)) for at in t]
        constant = np.array([self._constant(*at) for at in zip(t, x, u, pulls, strict=True)])
        for i, stretch in enumerate(stretches):
            own = slice(i * STAGES, (i + 1) * STAGES)
            self.numbers[stretch] = _Numbers(
                t[own], x[own], u[own], defect[own], np.swapaxes(linear[own], 1, 2),
                constant[own], gain[own], pulls[own],
            )  # fmt: skip

    def arc(self, edges: Sequence[float], jumps: Sequence[Jump], near: float) -> Arc:
        """The interval with these edges, the latest first."""
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
        n, h, own = self.columns, high - low, self.numbers[high, low]
        matrix = np.eye(STAGES * n)
        right = np.zeros((STAGES * n, n + 1))
        for i in range(STAGES):
            mine = slice(i * n, (i + 1) * n)
            right[mine, :n] = np.eye(n)
            for j in range(STAGES):
                matrix[mine, j * n : (j + 1) * n] -= h * TABLEAU[i, j] * own.linear[j]
                right[mine, n] += h * TABLEAU[i, j] * own.constant[j]
        at: Array = np.asarray(np.linalg.solve(matrix, right), np.float64).reshape(STAGES, n, n + 1)
        total = np.eye(n, n + 1)
        for i in range(STAGES):
            total = total + h * WEIGHTS[i] * (own.linear[i] @ at[i])
            total[:, n] += h * WEIGHTS[i] * own.constant[i]
        stages = [
            Stage(
                float(own.t[i]), h * WEIGHTS[i], own.x[i], own.u[i], own.defect[i], own.gain[i],
                own.pulls[i], at[i, :, :n], at[i, :, n],
            )
            for i in range(STAGES)
        ]  # fmt: skip
        return total[:, :n], total[:, n], stages

    def _constant(self, t: float, x: Array, u: Array, pulls: tuple[Array, Array, Path]) -> Array:
        """q (nx,)."""
        constant, _, path = pulls
        running = self.running
        if running is not None:
            constant = constant + slope(lambda at: running(float(t), at, u), x, self.range)
        if path:
            constant = constant + slope(lambda at: path_value(path, float(t), at, u), x, self.range)
        return constant
