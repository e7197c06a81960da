"""SPICE SPK, type 13: Hermite interpolation through position and velocity."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from berthing.export import spice
from berthing.export.handover import Handover, Track
from berthing.export.notes import notes
from berthing.export.samples import sample
from berthing.geometry.arrays import Array

KM = 1e-3
# Two samples to an interval, so that no polynomial crosses a break of the plan.
DEGREE = 3


def write(handover: Handover, path: Path) -> None:
    """One segment for each vehicle and phase.

    Raises:
        InputError: a frame or centre that SPICE does not know, or no NAIF id.
    """
    toolkit = spice.toolkit()
    # Asked for first, so that what is wrong with meta: comes before any file.
    bodies = {name: spice.body_id(handover, name) for name in handover.vehicles}
    frame, centre = spice.frame_of(handover), spice.centre_id(handover)
    told = notes(handover, quaternion="", units="km and km/s, seconds of TDB past J2000")
    told += [f"NAIF id of {name}: {body}; centre {centre}." for name, body in bodies.items()]
    handle = toolkit.spkopn(str(path), "berthing", 0)
    with spice.closing(toolkit.spkcls, handle):
        spice.add_comments(handle, told)
        for track in handover.tracks:
            times, states = _states(track, spice.ephemeris_time(handover))
            toolkit.spkw13(
                handle, bodies[track.name], centre, frame, times[0], times[-1],
                spice.segment_name(track.name, track.phase.name), DEGREE, len(times), states,
                times,
            )  # fmt: skip


def _states(track: Track, start_tdb_s: float) -> tuple[Array, Array]:
    """Times (k,) past J2000 and states (k, 6).

    Today such times are doubles 1e-7 s apart. The plan is sampled at the very ones, so that the
    rounding does not become one of position.
    """
    times = start_tdb_s + track.samples.t_s
    s = sample(track.vehicle.model, track.trajectory, times - start_tdb_s)
    return times, np.ascontiguousarray(KM * np.hstack([s.position_m, s.velocity_m_s]))
