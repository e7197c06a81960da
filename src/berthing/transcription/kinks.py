"""Breaks where the equations of motion are not smooth in time, which no polynomial follows."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from berthing.scenario.native_state import Model
from berthing.scenario.phase import Phase
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.user_model import UserModel
from berthing.transcription.mesh import Mesh
from berthing.transcription.scheme import ONE_SEGMENT

CROWDED = 0.35
"""Of a mean segment: breaks of the mesh nearer to a kink than this make room for it."""


def kink_fractions(phase: Phase, t0_s: float = 0.0) -> list[float]:
    """Fractions of the phase at which wrenches or the user's dynamics have kinks, rising.

    None where the duration is free: what fraction they will be at is not known.
    """
    if phase.horizon.is_free:
        return []
    times = {t for vehicle in phase.vehicles for t in _kinks_s(vehicle.model)}
    inside = ((t - t0_s) / phase.horizon.nominal_s for t in sorted(times))
    return [fraction for fraction in inside if 0.0 < fraction < 1.0]


def through(mesh: Mesh, fractions: Sequence[float]) -> Mesh:
    """``mesh``, of one degree, with breaks at ``fractions`` (rising, inside) among its own."""
    if not fractions or mesh.scheme in ONE_SEGMENT:
        return mesh
    room = CROWDED / mesh.segments
    own = [b for b in mesh.breaks[1:-1] if np.min(np.abs(np.array(fractions) - b)) > room]
    breaks = (0.0, *sorted({*own, *fractions}), 1.0)
    return Mesh(mesh.scheme, breaks, (mesh.degrees[0],) * (len(breaks) - 1))


def _kinks_s(model: Model) -> list[float]:
    if isinstance(model, UserModel):
        return list(model.kinks_s)
    wrenches = model.wrenches if isinstance(model, RigidBody) else ()
    return [float(t) for wrench in wrenches for t in wrench.times_s]
