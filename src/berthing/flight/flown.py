"""A plan whose controls are piecewise, and whose states are what flies under them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from berthing.errors import InputError
from berthing.flight.holds import HOLDS, Hold, sample_times
from berthing.flight.step import Stepper
from berthing.flight.tracking import Reference, tracked, weights
from berthing.scenario.cost import Cost
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import PhaseTrajectory, Plan, Segment, VehicleNodes, VehicleTrajectory
from berthing.xp import NUMPY

MOST_SAMPLES = 15_000
"""Intervals of one phase: who checks the plan takes 20,000 segments, with those cut at kinks."""

GAUSS = 8
"""Points of the cost's quadrature on an interval."""


def with_controls(scenario: Scenario, plan: Plan, kind: str, every_s: float) -> Plan:
    """The plan as it flies with the controls ``kind``, sampled ``every_s`` apart.

    The commands follow the plan (``tracking``); states are those that result, cost is theirs, and
    at the nodes are what flies there. Costates stay those of the plan as optimised.

    Raises:
        InputError: an unknown kind, or a sample time that is too short or too long.
    """
    hold = HOLDS[kind]
    phases = tuple(
        PhaseTrajectory(
            own.phase,
            tuple(
                _flown(scenario.phase(own.phase).vehicle(v.vehicle), v, hold, every_s)
                for v in own.vehicles
            ),
        )
        for own in plan.phases
    )
    cost = sum(_cost(scenario.phase(own.phase), own) for own in phases)
    by_name = {(p.phase, v.vehicle): v for p in phases for v in p.vehicles}
    nodes = tuple(_at_nodes(n, by_name[n.phase, n.vehicle]) for n in plan.nodes)
    return replace(plan, phases=phases, nodes=nodes, cost=cost)


def _flown(
    vehicle: Vehicle, own: VehicleTrajectory, hold: Hold, every_s: float
) -> VehicleTrajectory:
    if (own.t1_s - own.t0_s) / every_s > MOST_SAMPLES:
        raise InputError("sample_time_s", f"is {every_s:g}", f"{MOST_SAMPLES} intervals at most")
    times, stepper = sample_times(own.t0_s, own.t1_s, every_s), Stepper(vehicle.model)
    states, commands = own.state(times), hold.commands(own, times)
    limits = vehicle.limits.control_lower, vehicle.limits.control_upper
    plan = Reference(times, states, commands, weights(vehicle.model, states[0]))
    segments = tracked(stepper, hold, plan, limits)
    return replace(own, segments=tuple(segments), control_interpolation=hold.interpolation)


def _at_nodes(nodes: VehicleNodes, own: VehicleTrajectory) -> VehicleNodes:
    """States and controls as flown; rows without a control stay without."""
    absent = np.isnan(nodes.controls).all(axis=1)
    controls = own.control(nodes.times_s)
    controls[absent] = np.nan
    return replace(nodes, states=own.state(nodes.times_s), controls=controls)


def _cost(phase: Phase, flown: PhaseTrajectory) -> float:
    """∫ (control_energy Σ‖u‖² + time + Σ h) dt, physical units."""
    cost, total = phase.cost, phase.cost.time * (flown.t1_s - flown.t0_s)
    for own in flown.vehicles:
        for segment in own.segments:
            total += _cost_of(cost, own.vehicle, segment)
    return total


def _cost_of(cost: Cost, vehicle: str, segment: Segment) -> float:
    s, w = np.polynomial.legendre.leggauss(GAUSS)
    half = 0.5 * (segment.t1_s - segment.t0_s)
    x, u = (np.polynomial.chebyshev.chebval(s, c).T for c in (segment.state, segment.control))
    power = cost.control_energy * np.sum(u**2, axis=1)
    t = 0.5 * (segment.t0_s + segment.t1_s) + half * s
    for running in cost.running:
        if running.vehicle == vehicle:
            nodes = zip(t.tolist(), x, u, strict=True)
            power = power + [running.function(a, b, c, NUMPY, 1)[0] for a, b, c in nodes]
    return float(half * (w @ power))
