"""The lower Hamiltonian at the nodes, from the costates and the independent dynamics.

Along an extremal dH/dt = ∂H/∂t, and where a structure's motion brings a touch about, H before is
more than H after by ν ∂g/∂t. H less both stands still.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import Plan, VehicleNodes
from berthing.verify.equations import derivative
from berthing.verify.lagrangian import AT_NODE, Pulls, hamiltonian_of, path_value
from berthing.verify.separation_rows import drawn_m_s
from berthing.xp import NUMPY


def hamiltonian(phase: Phase, nodes: Sequence[VehicleNodes]) -> tuple[Array, Array]:
    """Times (k,) and H = L + Σ λ·f (k,), over all vehicles, where controls and costates exist.

    L = control_energy Σ‖u‖² + time + Σ h. Active separation rows and limits add nothing to H, for
    multiplier times constraint is zero.

    Args:
        nodes: those of the phase, one entry a vehicle, on one set of times.

    Returns:
        Empty arrays where vehicles have nodes at different times, or no costates.
    """
    if not nodes or any(not np.array_equal(n.times_s, nodes[0].times_s) for n in nodes):
        return np.empty(0), np.empty(0)
    total = np.full(len(nodes[0].times_s), phase.cost.time)
    for own in nodes:
        f = derivative(phase.vehicle(own.vehicle).model)
        rates = np.array(
            [
                f(float(t), x, u)
                for t, x, u in zip(own.times_s, own.states, own.controls, strict=True)
            ]
        )
        total = total + phase.cost.control_energy * np.sum(own.controls**2, axis=1)
        total = total + np.sum(own.costates * rates, axis=1)
    for running in phase.cost.running:
        own = next(n for n in nodes if n.vehicle == running.vehicle)
        columns = zip(own.times_s, own.states, own.controls, strict=True)
        total = total + [running.function(float(t), x, u, NUMPY, 1)[0] for t, x, u in columns]
    known = np.isfinite(total)
    return nodes[0].times_s[known], total[known]


def drift_of(scenario: Scenario, plan: Plan, phase: Phase) -> tuple[Array, Array, float | None]:
    """What ``balance`` gives, and its relative drift.

    A free horizon makes H vanish throughout: its drift is relative to the mean cost a second where
    that is more.
    """
    times, values = balance(scenario, plan, phase)
    if not len(times) or not phase.horizon.is_free:
        return times, values, relative_drift(values)
    # Nodes of a file may all be at one time.
    span = max(float(times[-1] - times[0]), np.finfo(np.float64).tiny)
    return times, values, relative_drift(values, abs(plan.cost) / span)


MOST_NODES = 5000
"""Of one vehicle: H alone is told where a file has more, ten times what the finest meshes have."""

TIME_STEP = 1e-7
"""Of the phase, in central differences of H by time: less than from a Gauss point to a node."""


def balance(scenario: Scenario, plan: Plan, phase: Phase) -> tuple[Array, Array]:
    """Times (k,) and H(t) − ∫ ∂H/∂t dt (k,), the jumps of touches with moving structures included.

    Empty where ``hamiltonian`` is.
    """
    own = [n for n in plan.nodes if n.phase == phase.name]
    times, values = hamiltonian(phase, own)
    if not len(times):
        return times, values
    near = AT_NODE * (own[0].times_s[-1] - own[0].times_s[0])
    for nodes in own:
        vehicle = phase.vehicle(nodes.vehicle)
        if time_enters(phase, vehicle) and len(nodes.times_s) <= MOST_NODES:
            gained = np.concatenate([[0.0], np.cumsum(_gains(plan, phase, vehicle, nodes))])
            values = values - np.interp(times, nodes.times_s, gained)
    for row, speed in zip(plan.separations, drawn_m_s(scenario, plan), strict=True):
        if row.phase == phase.name:
            values = values + row.multiplier * speed * (times >= row.time_s - near)
    return times, values


def time_enters(phase: Phase, vehicle: Vehicle) -> bool:
    """Whether H of a vehicle may depend on time: wrenches, functions of the user's own."""
    model = vehicle.model
    plain = model.kind in ("rigid-body", "point-mass") and not getattr(model, "wrenches", ())
    own_cost = any(cost.vehicle == vehicle.name for cost in phase.cost.running)
    return not plain or own_cost or bool(vehicle.path_constraints)


def _gains(plan: Plan, phase: Phase, vehicle: Vehicle, nodes: VehicleNodes) -> list[float]:
    """∫ ∂H/∂t dt of one vehicle over each interval between nodes, costates linear within."""
    trajectory = next(p for p in plan.phases if p.phase == phase.name).vehicle(vehicle.name)
    value, pulls = (
        hamiltonian_of(phase, vehicle, derivative(vehicle.model)),
        Pulls.of(vehicle, nodes, trajectory),
    )
    points, weights = np.polynomial.legendre.leggauss(3)
    step = TIME_STEP * (nodes.times_s[-1] - nodes.times_s[0])
    out = []
    for i, (a, b) in enumerate(pairwise(nodes.times_s)):
        share = 0.5 * (points + 1.0)
        t = a + (b - a) * share
        costates = np.outer(1.0 - share, nodes.costates[i]) + np.outer(share, nodes.costates[i + 1])
        total = 0.0
        columns = zip(t, trajectory.state(t), trajectory.control(t), costates, weights, strict=True)
        for at, x, u, costate, weight in columns:
            path = pulls.at(float(at))[2]
            later, sooner = (
                value(float(now), x, u, costate) + path_value(path, float(now), x, u)
                for now in (at + step, at - step)
            )
            total += 0.5 * (b - a) * weight * (later - sooner) / (2.0 * step)
        out.append(float(total))
    return out


def relative_drift(values: Array, least_scale: float = 0.0) -> float | None:
    """(max − min)/mean|H|; None where there is nothing to compare, 0 where H is zero throughout.

    ``least_scale`` stands in for a mean below it.
    """
    if len(values) < 2:
        return None
    scale = max(float(np.mean(np.abs(values))), least_scale)
    return float(np.ptp(values)) / scale if scale > 0.0 else 0.0
