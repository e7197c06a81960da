"""Residuals of one vehicle, in the cost's unit, from its nodes and the arcs between them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import SeparationCostate, VehicleNodes, VehicleTrajectory
from berthing.verify.adjoint import Arc, arcs, jumps_of, misses
from berthing.verify.equations import derivatives
from berthing.verify.lagrangian import (
    Path,
    Pulls,
    path_value,
    ranges_of,
    running_of,
    slope,
    slopes,
)
from berthing.verify.transversality import transversality
from berthing.xp import NUMPY

AT_LIMIT = 1e-6
"""Of the range between the limits: a control this near to one is at it."""


@dataclass(frozen=True)
class _Instant:
    """A state with control and multipliers, and what time it stands for.

    Attributes:
        fixed: (nu,) slope in the control of what does not take the costate.
        gain: ∂f/∂u (nx, nu).
    """

    weight_s: float
    t: float
    x: Array
    u: Array
    pull_x: Array
    pull_u: Array
    path: Path
    fixed: Array
    gain: Array


@dataclass(frozen=True)
class VehicleWay:
    """One vehicle's nodes with all that its residuals are made of.

    Attributes:
        at_nodes: those that have a control, with their numbers; between: stages of the arcs.
        known: whether the multipliers of the control's limits are.
    """

    vehicle: Vehicle
    nodes: VehicleNodes
    arcs: Sequence[Arc]
    at_nodes: Sequence[tuple[int, _Instant]]
    between: Sequence[_Instant]
    known: bool
    x_range: Array
    u_range: Array

    @staticmethod
    def of(
        phase: Phase, nodes: VehicleNodes, trajectory: VehicleTrajectory,
        rows: Sequence[SeparationCostate],
    ) -> VehicleWay:  # fmt: skip
        vehicle = phase.vehicle(nodes.vehicle)
        found = arcs(phase, vehicle, nodes, trajectory, jumps_of(rows, vehicle.name))
        pulls = Pulls.of(vehicle, nodes, trajectory)
        x_range, u_range = ranges_of(vehicle, nodes)
        make = _Instants(phase, vehicle, pulls.known, u_range)
        times = nodes.times_s
        middles = np.concatenate([times[:1], 0.5 * (times[1:] + times[:-1]), times[-1:]])
        known = np.flatnonzero(np.all(np.isfinite(nodes.controls), axis=1))
        t, x, u = times[known], nodes.states[known], nodes.controls[known]
        rates = derivatives(vehicle.model)
        gains = slopes(lambda at: rates(t, x, at), u, u_range)
        at_nodes = [
            make(
                float(middles[i + 1] - middles[i]), float(times[i]), nodes.states[i],
                nodes.controls[i], pulls.at_node(int(i)), gain,
            )
            for i, gain in zip(known, gains, strict=True)
        ]  # fmt: skip
        stages = [s for arc in found for s in arc.stages]
        between = [make(s.weight_s, s.t, s.x, s.u, s.pulls, s.gain) for s in stages]
        pairs = [(int(i), at) for i, at in zip(known, at_nodes, strict=True)]
        return VehicleWay(vehicle, nodes, found, pairs, between, pulls.known, x_range, u_range)

    def residuals(self, scenario: Scenario) -> tuple[float, ...]:
        """Stationarity, adjoint, transversality, complementarity, dual and primal, in cost."""
        costates = self.nodes.costates
        inner = [
            s.costate(end)
            for arc, end in zip(self.arcs, costates[1:], strict=True)
            for s in arc.stages
        ]
        stationarity = max(
            self._stationarity((at, costates[i]) for i, at in self.at_nodes),
            self._stationarity(zip(self.between, inner, strict=True)),
        )
        ends = transversality(scenario, self.vehicle, self.nodes, self.x_range)
        slack, wrong = self._limits(at for _, at in self.at_nodes)
        return stationarity, self.adjoint, ends, slack, wrong, self._primal(inner)

    @property
    def adjoint(self) -> float:
        """What the costates miss their equations by, in cost."""
        return float(np.sum(np.abs(misses(self.nodes, self.arcs)) * self.x_range))

    def _stationarity(self, instants: Iterable[tuple[_Instant, Array]]) -> float:
        total = 0.0
        for at, costate in instants:
            found = at.fixed + costate @ at.gain
            if not self.known:
                found = self._inward(at.u, found)
            total += at.weight_s * float(np.sum(np.abs(found) * self.u_range))
        return total

    def _inward(self, u: Array, found: Array) -> Array:
        """The slope without what presses against a limit."""
        limits = self.vehicle.limits
        near = AT_LIMIT * self.u_range
        at_lower, at_upper = u <= limits.control_lower + near, u >= limits.control_upper - near
        return np.where((at_lower & (found > 0.0)) | (at_upper & (found < 0.0)), 0.0, found)

    def _limits(self, instants: Iterable[_Instant]) -> tuple[float, float]:
        """∫ |μ g| of limits and path constraints, and ∫ of multipliers of the wrong sign."""
        limits, slack, wrong = self.vehicle.limits, 0.0, 0.0
        for at in instants:
            for mu, value, lower, upper, scale in (
                (at.pull_x, at.x, limits.state_lower, limits.state_upper, self.x_range),
                (at.pull_u, at.u, limits.control_lower, limits.control_upper, self.u_range),
            ):
                gap = np.where(mu > 0.0, upper - value, value - lower)
                absent = ~np.isfinite(gap)
                slack += at.weight_s * float(np.sum(np.abs(mu) * np.where(absent, 0.0, abs(gap))))
                wrong += at.weight_s * float(np.sum(np.abs(mu) * scale * absent))
            for own, mu in at.path:
                g = np.asarray(own.function(at.t, at.x, at.u, NUMPY))
                slack += at.weight_s * float(np.sum(np.maximum(mu, 0.0) * np.abs(g)))
                wrong += at.weight_s * float(np.sum(np.maximum(-mu, 0.0))) * own.scale
        return slack, wrong

    def _primal(self, costates: Sequence[Array]) -> float:
        stages = [s for arc in self.arcs for s in arc.stages]
        return sum(
            s.weight_s * float(np.sum(np.abs(costate * s.defect)))
            for s, costate in zip(stages, costates, strict=True)
        )


@dataclass(frozen=True)
class _Instants:
    """Makes instants of one vehicle, with what takes the equations of motion."""

    phase: Phase
    vehicle: Vehicle
    known: bool
    u_range: Array

    def __call__(
        self, weight_s: float, t: float, x: Array, u: Array, pulls: tuple[Array, Array, Path],
        gain: Array,
    ) -> _Instant:  # fmt: skip
        pull_x, pull_u, path = pulls
        running = running_of(self.phase, self.vehicle)
        fixed = 2.0 * self.phase.cost.control_energy * u + (pull_u if self.known else 0.0)
        if running is not None:
            fixed = fixed + slope(lambda at: running(t, x, at), u, self.u_range)
        if path:
            fixed = fixed + slope(lambda at: path_value(path, t, x, at), u, self.u_range)
        return _Instant(weight_s, t, x, u, pull_x, pull_u, path, fixed, gain)
