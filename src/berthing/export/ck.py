"""SPICE CK, type 5: Hermite interpolation through quaternions and their rates.

A CK counts the ticks of a spacecraft's clock. The plan has none, so a clock comes with it: a text
kernel beside the CK in which a tick is a microsecond from t = 0, and which names the frame.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from berthing.errors import InputError
from berthing.export import spice
from berthing.export.handover import Handover, Track
from berthing.export.meta import LARGEST_NAIF_ID
from berthing.export.notes import notes
from berthing.export.order import spice as spice_quaternion
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array

# Packets of quaternion and derivative; two to an interval (NAIF, ck.req).
SUBTYPE, DEGREE = 0, 3
TICK_S = 1e-6
# NAIF's custom: instruments of the spacecraft −n are −1000 n and below.
FRAMES_PER_BODY = 1000
QUATERNION_NOTE = (
    "scalar first, of the C-matrix v_B = C v_I: the conjugate of the quaternion that turns body "
    "axes to the frame's"
)


def write(handover: Handover, path: Path) -> None:
    """One segment for each vehicle and phase; and ``path`` with .tf added, clock and frame.

    Raises:
        InputError: a frame that SPICE does not know, no NAIF id, or one out of range.
    """
    toolkit = spice.toolkit()
    bodies = {name: _spacecraft_id(handover, name) for name in handover.vehicles}
    frame = spice.frame_of(handover)
    told = notes(handover, quaternion=QUATERNION_NOTE, units="rad/s, clock ticks of 1e-6 s")
    handle = toolkit.ckopn(str(path), "berthing", 0)
    with spice.closing(toolkit.ckcls, handle):
        text = _clock_and_frames(handover, bodies, told)
        spice.add_comments(handle, [*told, f"Load {path.name}.tf too; it reads:", *text])
        for track in handover.tracks:
            packets, ticks = _packets(track), track.samples.t_us.astype(np.float64)
            toolkit.ckw05(
                handle, SUBTYPE, DEGREE, ticks[0], ticks[-1],
                FRAMES_PER_BODY * bodies[track.name], frame, True,
                spice.segment_name(track.name, track.phase.name), ticks, packets, TICK_S, 1,
                [ticks[0]],
            )  # fmt: skip
    lines = ["KPL/FK", "", *told, "", *text]
    path.with_name(f"{path.name}.tf").write_text("\n".join(lines) + "\n", encoding="ascii")


def _spacecraft_id(handover: Handover, vehicle: str) -> int:
    """A NAIF id from which ids of a clock and of a frame follow."""
    own = spice.body_id(handover, vehicle)
    if not -LARGEST_NAIF_ID // FRAMES_PER_BODY < own < 0:
        where = f"{handover.meta.where}.naif_ids.{vehicle}"
        raise InputError(where, f"is {own}, which is no spacecraft's", "-2147483 to -1")
    return own


def _packets(track: Track) -> Array:
    """SPICE's quaternion and its derivative (k, 8), from q̇ = ½ q ⊗ (0, ω_B)."""
    q, rate = track.samples.q_IB, track.samples.rate_rad_s
    pure = np.concatenate([np.zeros((len(rate), 1)), rate], axis=1)
    change = 0.5 * quaternion.multiply(q, pure)
    return np.ascontiguousarray(np.hstack([spice_quaternion(q), spice_quaternion(change)]))


def _clock_and_frames(handover: Handover, bodies: dict[str, int], told: list[str]) -> list[str]:
    lines = ["\\begindata", ""]
    for name, body in bodies.items():
        lines += [*_clock(-body, spice.ephemeris_time(handover)), "", *_frame(name, body), ""]
    return [*lines, "\\begintext"]


def _clock(number: int, start_tdb_s: float) -> list[str]:
    """Type 1 (NAIF, sclk.req): seconds and microseconds since t = 0, parallel to TDB."""
    return [
        "SCLK_KERNEL_ID += ( @2000-01-01/12:00 )",
        f"SCLK_DATA_TYPE_{number} = ( 1 )",
        f"SCLK01_TIME_SYSTEM_{number} = ( 1 )",
        f"SCLK01_N_FIELDS_{number} = ( 2 )",
        f"SCLK01_MODULI_{number} = ( 1000000000 1000000 )",
        f"SCLK01_OFFSETS_{number} = ( 0 0 )",
        f"SCLK01_OUTPUT_DELIM_{number} = ( 1 )",
        f"SCLK_PARTITION_START_{number} = ( 0.0 )",
        f"SCLK_PARTITION_END_{number} = ( 1.0E15 )",
        f"SCLK01_COEFFICIENTS_{number} = ( 0.0 {start_tdb_s!r} 1.0 )",
    ]


def _frame(name: str, body: int) -> list[str]:
    frame_id = FRAMES_PER_BODY * body
    label = f"BERTHING_{name.upper().replace('-', '_')}"[:32]
    return [
        f"FRAME_{label} = {frame_id}",
        f"FRAME_{frame_id}_NAME = '{label}'",
        f"FRAME_{frame_id}_CLASS = 3",
        f"FRAME_{frame_id}_CLASS_ID = {frame_id}",
        f"FRAME_{frame_id}_CENTER = {body}",
        f"CK_{frame_id}_SCLK = {body}",
        f"CK_{frame_id}_SPK = {body}",
    ]
