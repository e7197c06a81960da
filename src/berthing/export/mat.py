"""MATLAB 5 file: samples and polynomials of every vehicle in one structure, ``plan``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from scipy.io import savemat

from berthing.export.handover import Handover, Track
from berthing.export.notes import notes

QUATERNION_NOTE = "q_IB, rows of w x y z: scalar first, turns body axes to the frame's"
UNITS_NOTE = "SI, in the names; rates in body axes"
CONTROLS_NOTE = "control has them at the sample times, segments their polynomials."
HOW_TO_READ = (
    "On [t0_s, t1_s] a component is sum_k c(k+1, component) T_k(s), T_k the Chebyshev polynomials "
    "and s = (2 t - t0_s - t1_s)/(t1_s - t0_s)."
)


def write(handover: Handover, path: Path) -> None:
    """``plan.vehicles(i)`` has one vehicle in one phase, ``.segments(j)`` its polynomials."""
    epoch = handover.meta.epoch
    told = notes(handover, quaternion=QUATERNION_NOTE, units=UNITS_NOTE, controls=CONTROLS_NOTE)
    plan = {
        "notes": "\n".join([*told, f"Segments: {HOW_TO_READ}"]),
        "scenario": handover.scenario.name,
        "outcome": handover.outcome,
        "epoch": "" if epoch is None else epoch.iso(),
        "time_system": "" if epoch is None else epoch.scale,
        "frame": handover.meta.frame or "",
        "centre": handover.meta.centre or "",
        "vehicles": _structures([_vehicle(track) for track in handover.tracks]),
    }
    # Names of fields are up to 63 letters long in every MATLAB of this century.
    savemat(path, {"plan": plan}, appendmat=False, long_field_names=True, do_compression=True)


def _vehicle(track: Track) -> dict[str, Any]:
    s, own = track.samples, track.trajectory
    return {
        "name": track.name,
        "phase": track.phase.name,
        "model": own.model,
        "t_s": s.t_s[:, None],
        "position_m": s.position_m,
        "velocity_m_s": s.velocity_m_s,
        "q_IB": s.q_IB,
        "rate_rad_s": s.rate_rad_s,
        "control": own.control(s.t_s),
        "control_interpolation": own.control_interpolation,
        "state_names": np.array(own.state_names, dtype=object),
        "control_names": np.array(own.control_names, dtype=object),
        "segments": _structures(
            [
                {"t0_s": g.t0_s, "t1_s": g.t1_s, "state": g.state, "control": g.control}
                for g in own.segments
            ]
        ),
    }


def _structures(rows: list[dict[str, Any]]) -> Any:
    """A structure array: one field for each key, one element for each row."""
    array = np.empty(len(rows), dtype=[(key, object) for key in rows[0]])
    for i, row in enumerate(rows):
        array[i] = tuple(row.values())
    return array
