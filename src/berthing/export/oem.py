"""CCSDS Orbit Ephemeris Message 2.0 (502.0-B-2), keyword-value notation."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from berthing.export import ccsds
from berthing.export.handover import Handover, Track
from berthing.export.notes import notes

KM = 1e-3


def write(handover: Handover, path: Path) -> None:
    """One segment for each vehicle and phase: position and velocity, in km and km/s.

    Raises:
        InputError: ``meta:`` lacks or mistakes what the message states.
    """
    told = notes(handover, quaternion="", units="km and km/s")
    ccsds.write_message(path, "CCSDS_OEM_VERS", handover, told, _segment)


def _segment(handover: Handover, track: Track) -> Iterator[str]:
    frames = [f"REF_FRAME = {ccsds.frame_of(handover)}"]
    # A cubic through position and velocity at two samples crosses no break of the plan.
    rest = ["INTERPOLATION = HERMITE", "INTERPOLATION_DEGREE = 3"]
    yield from ccsds.metadata(handover, track, frames, rest)
    samples = track.samples
    rows = KM * np.hstack([samples.position_m, samples.velocity_m_s])
    yield from ccsds.data(handover, track, rows)
