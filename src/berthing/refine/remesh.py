"""Where the dynamics are not resolved, and the mesh that resolves them."""

from __future__ import annotations

import numpy as np

from berthing.scenario.phase import Phase
from berthing.trajectory import PhaseTrajectory
from berthing.transcription.mesh import Mesh
from berthing.verify.equations import derivative

PROBES = 5
"""Times in a segment, off the nodes, at which ẋ - f is looked at."""

SHARE = 0.1
"""Segments with at least this share of the worst residual are halved together."""


def split_unresolved(mesh: Mesh, phase: Phase, trajectory: PhaseTrajectory) -> Mesh:
    """Halve the segments whose interpolant misses its own equations of motion most."""
    residual = np.zeros(mesh.segments)
    for vehicle in phase.vehicles:
        rates = derivative(vehicle.model)
        own = trajectory.vehicle(vehicle.name)
        for k, segment in enumerate(own.segments):
            # Equal steps, which no collocation scheme's nodes are.
            t = np.linspace(segment.t0_s, segment.t1_s, PROBES + 2)[1:-1]
            x, slope, u = own.state(t), own.state_rate(t), own.control(t)
            scale = np.maximum(np.max(np.abs(own.state_rate(own.breaks_s)), axis=0), 1e-9)
            for ti, xi, di, ui in zip(t, x, slope, u, strict=True):
                gap = np.abs(di - rates(float(ti), xi, ui)) / scale
                residual[k] = max(residual[k], float(np.max(gap)) * (segment.t1_s - segment.t0_s))
    worst = float(residual.max())
    return mesh.split({k for k in range(mesh.segments) if residual[k] >= SHARE * worst})
