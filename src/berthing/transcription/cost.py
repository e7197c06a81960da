"""The cost of numbers on a mesh, by the scheme's own quadrature."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from berthing.geometry.arrays import Array
from berthing.transcription.defects import quadrature
from berthing.transcription.layout import PhaseLayout
from berthing.transcription.nodes import collocated
from berthing.xp import NUMPY


def phase_cost(
    layout: PhaseLayout,
    duration_s: float,
    states: Mapping[str, Array],
    controls: Mapping[str, Array],
) -> float:
    """∫ (control_energy Σ‖u‖² + time + Σ h) dt in physical units.

    Args:
        states: (nx, points) by vehicle. controls: (nu, controls) by vehicle.
    """
    weights, cost = quadrature(layout), layout.phase.cost
    power = cost.control_energy * sum(np.sum(u**2, axis=0) for u in controls.values())
    points, fractions = collocated(layout)
    times = layout.t0_s + duration_s * np.array(fractions)
    for running in cost.running:
        nodes = zip(
            times, states[running.vehicle][:, points].T, controls[running.vehicle].T, strict=True
        )
        power = power + [running.function(float(t), x, u, NUMPY, 1)[0] for t, x, u in nodes]
    return duration_s * (float(weights @ power) + cost.time)
