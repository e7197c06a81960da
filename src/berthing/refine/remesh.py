"""Where dynamics and path constraints are not resolved, and the mesh that resolves them."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.phase import Phase
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import PhaseTrajectory, VehicleTrajectory
from berthing.transcription.mesh import Mesh
from berthing.verify.equations import derivatives
from berthing.xp import NUMPY

PROBES = 5
"""Times in a segment, off the nodes, at which ẋ - f is looked at."""

PATH_PROBES = 16
"""Likewise of path constraints, whose excess may be brief."""

SHARE = 0.1
"""Segments with at least this share of the worst residual are halved together."""


def split_unresolved(mesh: Mesh, phase: Phase, trajectory: PhaseTrajectory) -> Mesh:
    """Halve the segments whose interpolant misses its own equations of motion most.

    And those in which a path constraint that holds at the nodes fails between them.
    """
    missed = residuals(phase, trajectory)
    coarse = set(np.flatnonzero(missed >= SHARE * np.max(missed)).tolist())
    beyond = {k for v in phase.vehicles for k in _beyond(v, trajectory.vehicle(v.name))}
    # Where a constraint is all that is wrong, the dynamics need no finer mesh.
    return mesh.split(beyond or coarse)


def graded(mesh: Mesh, phase: Phase, trajectory: PhaseTrajectory, segments: int) -> Mesh:
    """``mesh`` cut, where the interpolant misses its equations most, into so many segments."""
    missed = residuals(phase, trajectory)
    while mesh.segments < segments:
        worst = int(np.argmax(missed))
        half = missed[worst] * 0.5 ** (mesh.degrees[worst] + 1)
        mesh = mesh.split({worst})
        missed = np.concatenate([missed[:worst], [half, half], missed[worst + 1 :]])
    return mesh


def residuals(phase: Phase, trajectory: PhaseTrajectory) -> Array:
    """(segments,) the largest miss of the equations of motion in each, times its length."""
    # Equal steps, which no collocation scheme's nodes are.
    steps = np.linspace(-1.0, 1.0, PROBES + 2)[1:-1]
    missed = np.zeros(len(trajectory.vehicles[0].segments))
    for vehicle in phase.vehicles:
        own = trajectory.vehicle(vehicle.name)
        t = np.concatenate([0.5 * (s.t0_s + s.t1_s + (s.t1_s - s.t0_s) * steps)
                            for s in own.segments])  # fmt: skip
        rates = derivatives(vehicle.model)(t, own.state(t), own.control(t))
        scale = np.maximum(np.max(np.abs(own.state_rate(own.breaks_s)), axis=0), 1e-9)
        gap = np.max(np.abs(own.state_rate(t) - rates) / scale, axis=1)
        each = np.max(gap.reshape(-1, PROBES), axis=1) * np.diff(own.breaks_s)
        missed = np.maximum(missed, each)
    return missed


def _beyond(vehicle: Vehicle, own: VehicleTrajectory) -> set[int]:
    """Segments in which a path constraint exceeds its tolerance at a probe."""
    found = set()
    for k, segment in enumerate(own.segments):
        t = np.linspace(segment.t0_s, segment.t1_s, PATH_PROBES + 2)[1:-1]
        x, u = own.state(t), own.control(t)
        for constraint in vehicle.path_constraints:
            g = [
                constraint.function(float(ti), xi, ui, NUMPY)
                for ti, xi, ui in zip(t, x, u, strict=True)
            ]
            if np.max(g) > constraint.tolerance:
                found.add(k)
    return found
