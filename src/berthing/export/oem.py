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
    lines = ccsds.header("CCSDS_OEM_VERS", handover, told)
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
        f"REF_FRAME = {ccsds.frame_of(handover)}",
        f"TIME_SYSTEM = {epoch.scale}",
        f"START_TIME = {epoch.iso(samples.t_us[0])}",
        f"STOP_TIME = {epoch.iso(samples.t_us[-1])}",
        # A cubic through position and velocity at two samples crosses no break of the plan.
        "INTERPOLATION = HERMITE",
        "INTERPOLATION_DEGREE = 3",
        "META_STOP",
    )
    rows = KM * np.hstack([samples.position_m, samples.velocity_m_s])
    for t_us, row in zip(samples.t_us, rows, strict=True):
        yield " ".join([epoch.iso(t_us), *(ccsds.number(v) for v in row)])
