"""How fast a mesh can show a body turn.

Between two nodes a body that turns by much more than half a radian is not resolved: equations that
hold at the nodes say little of what happens between them. Where torque costs next to nothing the
solver finds such answers, for an unresolved spin gives thrust for nothing. They are several times
too cheap, and each finer mesh makes another answer of them. So where one comes up, the rates are
limited to what the mesh resolves, the more loosely the finer it is.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle
from berthing.transcription.lagrange import interpolation_matrix
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion

RESOLVED_RAD = 0.5
"""From node to node. Answers of the shipped cases turn by at most 0.3."""

ROOM = 1.5
"""Times the rates that the scenario itself asks for are always allowed."""

RATES = frozenset({"wx_rad_s", "wy_rad_s", "wz_rad_s"})
"""Names of the states that are rates of turning."""

BETWEEN = np.linspace(-1.0, 1.0, 9)
"""Local coordinates at which rates are looked at."""


def too_fast(phase: Phase, mesh: Mesh, motions: Iterable[Motion]) -> bool:
    """Whether a vehicle turns faster than the mesh resolves, on one of ``motions``."""
    return any(
        _fastest(vehicle, mesh, motion) * motion.duration_s > RESOLVED_RAD * mesh.control_count
        for motion in motions
        for vehicle in phase.vehicles
        if _columns(vehicle)
    )


def resolved(scenario: Scenario, phase: Phase, mesh: Mesh) -> Phase:
    """``phase`` with its vehicles' rates limited to what ``mesh`` resolves, or to what ends and
    structures ask for where that is more."""
    t0, t1 = 0.0, phase.horizon.max_s
    spins = [structure.motion.speed_bound(t0, t1)[1] for structure in scenario.structures]
    spin = max(spins, default=0.0)
    own = RESOLVED_RAD * mesh.control_count / phase.horizon.min_s
    vehicles = []
    for vehicle in phase.vehicles:
        ends = [e.rate_rad_s for e in (vehicle.start, vehicle.goal) if e.rate_rad_s is not None]
        asked = spin + max((float(np.linalg.norm(rate)) for rate in ends), default=0.0)
        vehicles.append(_limited(vehicle, max(own, ROOM * asked)))
    return replace(phase, vehicles=tuple(vehicles))


def _limited(vehicle: Vehicle, rate_rad_s: float) -> Vehicle:
    lower, upper = vehicle.limits.state_lower.copy(), vehicle.limits.state_upper.copy()
    columns = _columns(vehicle)
    lower[columns] = np.maximum(lower[columns], -rate_rad_s)
    upper[columns] = np.minimum(upper[columns], rate_rad_s)
    return replace(vehicle, limits=replace(vehicle.limits, state_lower=lower, state_upper=upper))


def _columns(vehicle: Vehicle) -> list[int]:
    return [i for i, name in enumerate(vehicle.model.state_names) if name in RATES]


def _fastest(vehicle: Vehicle, mesh: Mesh, motion: Motion) -> float:
    """The largest rate (rad/s) at the nodes and between them."""
    rates, fastest = motion.states[vehicle.name][_columns(vehicle)], 0.0
    for k in range(mesh.segments):
        nodes, offset = mesh.node_set(k), mesh.point_offset(k)
        values = rates[:, offset : offset + len(nodes.points)]
        between = values @ interpolation_matrix(nodes.points, BETWEEN).T
        fastest = max(fastest, float(np.max(np.abs(values))), float(np.max(np.abs(between))))
    return fastest
