"""CCSDS Attitude Ephemeris Message 2.0 (504.0-B-2), keyword-value notation."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from berthing.export import ccsds
from berthing.export.handover import Handover, Track
from berthing.export.notes import notes
from berthing.export.order import SCALAR_LAST, scalar_last

BODY = "SC_BODY_1"


def write(handover: Handover, path: Path) -> None:
    """One segment for each vehicle and phase: quaternion, scalar last, and rates in deg/s.

    Raises:
        InputError: ``meta:`` lacks or mistakes what the message states.
    """
    quaternion = f"Q1 Q2 Q3 QC, {SCALAR_LAST}; REF_FRAME_A is the plan's, REF_FRAME_B the body's"
    told = notes(handover, quaternion=quaternion, units="deg/s, in body axes")
    ccsds.write_message(path, "CCSDS_AEM_VERS", handover, told, _segment)


def _segment(handover: Handover, track: Track) -> Iterator[str]:
    frames = [f"REF_FRAME_A = {ccsds.frame_of(handover)}", f"REF_FRAME_B = {BODY}"]
    rest = [
        "ATTITUDE_TYPE = QUATERNION/ANGVEL",
        f"ANGVEL_FRAME = {BODY}",
        "INTERPOLATION_METHOD = LAGRANGE",
        "INTERPOLATION_DEGREE = 3",
    ]
    yield from ccsds.metadata(handover, track, frames, rest)
    samples = track.samples
    rows = np.hstack([scalar_last(samples.q_IB), np.rad2deg(samples.rate_rad_s)])
    yield from ("", "DATA_START")
    yield from ccsds.data(handover, track, rows)
    yield "DATA_STOP"
