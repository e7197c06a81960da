"""Residuals of one vehicle, in the cost's unit, from its nodes and the arcs between them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.path_constraint import PathConstraint
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import SeparationCostate, VehicleNodes, VehicleTrajectory
from berthing.verify.adjoint import Arc, arcs, jumps_of, misses
from berthing.verify.equations import derivative
from berthing.verify.lagrangian import (
    Lagrangian,
    Pulls,
    hamiltonian_of,
    path_value,
    ranges,
    slope,
)
from berthing.verify.transversality import transversality
from berthing.xp import NUMPY

AT_LIMIT = 1e-6
"""Of the range between the limits: a control this near to one is at it."""

Path = Sequence[tuple[PathConstraint, Array]]


@dataclass(frozen=True)
class _Instant:
    """A state with control, costate and multipliers, and what time it stands for."""

    weight_s: float
    t: float
    x: Array
    u: Array
    costate: Array
    pull_x: Array
    pull_u: Array
    path: Path


@dataclass(frozen=True)
class VehicleWay:
    """One vehicle's nodes with all that its residuals are made of."""

    vehicle: Vehicle
    nodes: VehicleNodes
    value: Lagrangian
    arcs: Sequence[Arc]
    pulls: Pulls
    x_range: Array
    u_range: Array

    @staticmethod
    def of(
        phase: Phase, nodes: VehicleNodes, trajectory: VehicleTrajectory,
        rows: Sequence[SeparationCostate],
    ) -> VehicleWay:  # fmt: skip
        vehicle = phase.vehicle(nodes.vehicle)
        model, rates = vehicle.model, derivative(vehicle.model)
        return VehicleWay(
            vehicle, nodes, hamiltonian_of(phase, vehicle, rates),
            arcs(phase, vehicle, nodes, trajectory, jumps_of(rows, vehicle.name), rates),
            Pulls.of(vehicle, nodes, trajectory),
            ranges(model.state_names, np.ptp(nodes.states, axis=0)),
            ranges(model.control_names, np.nanmax(np.abs(nodes.controls), axis=0)),
        )  # fmt: skip

    def residuals(self, scenario: Scenario) -> tuple[float, ...]:
        """Stationarity, adjoint, transversality, complementarity, dual and primal, in cost."""
        at_nodes, between = self._at_nodes(), self._between()
        stationarity = max(self._stationarity(at_nodes), self._stationarity(between))
        adjoint = float(np.sum(np.abs(misses(self.nodes, self.arcs)) * self.x_range))
        ends = transversality(scenario, self.vehicle, self.nodes, self.x_range)
        slack, wrong = self._limits(at_nodes)
        return stationarity, adjoint, ends, slack, wrong, self._primal()

    def _at_nodes(self) -> list[_Instant]:
        own, times = self.nodes, self.nodes.times_s
        known = np.flatnonzero(np.all(np.isfinite(own.controls), axis=1))
        middles = np.concatenate([times[:1], 0.5 * (times[1:] + times[:-1]), times[-1:]])
        return [
            _Instant(
                float(middles[i + 1] - middles[i]), float(times[i]), own.states[i],
                own.controls[i], own.costates[i], *self.pulls.at_node(int(i)),
            )
            for i in known
        ]  # fmt: skip

    def _between(self) -> list[_Instant]:
        ends = zip(self.arcs, self.nodes.costates[1:], strict=True)
        return [
            _Instant(s.weight_s, s.t, s.x, s.u, s.costate(end), *self.pulls.at(s.t))
            for arc, end in ends
            for s in arc.stages
        ]

    def _stationarity(self, instants: Iterable[_Instant]) -> float:
        return sum(
            at.weight_s * float(np.sum(np.abs(self._control_slope(at)) * self.u_range))
            for at in instants
        )

    def _control_slope(self, at: _Instant) -> Array:
        def lagrangian(u: Array) -> float:
            return self.value(at.t, at.x, u, at.costate) + path_value(at.path, at.t, at.x, u)

        found = slope(lagrangian, at.u, self.u_range)
        if self.pulls.known:
            return found + at.pull_u
        return self._inward(at.u, found)

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

    def _primal(self) -> float:
        return sum(
            s.weight_s * float(np.sum(np.abs(s.costate(end) * s.defect)))
            for arc, end in zip(self.arcs, self.nodes.costates[1:], strict=True)
            for s in arc.stages
        )
