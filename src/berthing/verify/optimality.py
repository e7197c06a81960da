"""The lower Hamiltonian at the nodes, from the costates and the independent dynamics."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.phase import Phase
from berthing.trajectory import VehicleNodes
from berthing.verify.equations import derivative
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


def relative_drift(values: Array) -> float | None:
    """(max − min)/mean|H|; None where there is nothing to compare, 0 where H is zero throughout."""
    if len(values) < 2:
        return None
    scale = float(np.mean(np.abs(values)))
    return float(np.ptp(values)) / scale if scale > 0.0 else 0.0
