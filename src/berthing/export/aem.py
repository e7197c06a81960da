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
    lines = ccsds.header("CCSDS_AEM_VERS", handover, told)
    for track in handover.tracks:
        lines += ["", *_segment(handover, track)]
    ccsds.write_lines(path, lines)


def _segment(handover: Handover, track: Track) -> Iterator[str]:
    epoch, samples = ccsds.epoch_of(handover), track.samples
    yield from (
        "META_START",
        f"OBJECT_NAME = {handover.meta.object_name(track.name)}",
        f"OBJECT_ID = {handover.meta.object_id(track.name)}",
        f"CENTER_NAME = {ccsds.centre_of(handover)}",
        f"REF_FRAME_A = {ccsds.frame_of(handover)}",
        f"REF_FRAME_B = {BODY}",
        f"TIME_SYSTEM = {epoch.scale}",
        f"START_TIME = {epoch.iso(samples.t_us[0])}",
        f"STOP_TIME = {epoch.iso(samples.t_us[-1])}",
        "ATTITUDE_TYPE = QUATERNION/ANGVEL",
        f"ANGVEL_FRAME = {BODY}",
        "INTERPOLATION_METHOD = LAGRANGE",
        "INTERPOLATION_DEGREE = 3",
        "META_STOP",
        "",
        "DATA_START",
    )
    rows = np.hstack([scalar_last(samples.q_IB), np.rad2deg(samples.rate_rad_s)])
    for t_us, row in zip(samples.t_us, rows, strict=True):
        yield " ".join([epoch.iso(t_us), *(ccsds.number(v) for v in row)])
    yield "DATA_STOP"
