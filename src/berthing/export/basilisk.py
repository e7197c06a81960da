"""A table for Basilisk's ``waypointReference``, which reads eleven numbers of a line.

Those are time, attitude, rate and its derivative; position, velocity and controls follow in
columns that the module does not look at.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from berthing.errors import InputError
from berthing.export.handover import Handover, Track
from berthing.export.notes import notes
from berthing.trajectory_io.columns import POSITION, QUATERNION, RATE, VELOCITY

RATE_CHANGE = ("dwx_rad_s2", "dwy_rad_s2", "dwz_rad_s2")
# C++ refuses to read smaller numbers than about 2e-308; these are nothing.
SMALLEST = 1e-300
QUATERNION_NOTE = (
    "qw qx qy qz, scalar first: the Euler parameters of B relative to N, which are q_IB "
    "(attitudeType 1)"
)


def write(handover: Handover, path: Path) -> None:
    """Comment lines, the names of the columns, then a line for each instant.

    Phases follow each other; of an instant that two of them share, the later one's line is there.

    Raises:
        InputError: a model whose states are not the rates in body axes, so that their derivative,
            which Basilisk wants, is not known.
    """
    tracks = handover.tracks
    for track in tracks:
        if not np.all(np.isfinite(track.samples.rate_change_rad_s2)):
            what = f"the state of {track.name} has no body rates to differentiate"
            raise InputError("--to basilisk", what, "another format, such as stk-a")
    controls = tuple(dict.fromkeys(n for t in tracks for n in t.trajectory.control_names))
    names = ("t_s", *QUATERNION, *RATE, *RATE_CHANGE, *POSITION, *VELOCITY, *controls)
    told = notes(
        handover,
        quaternion=QUATERNION_NOTE,
        units="s, rad/s, rad/s^2, m, m/s, N, N m; rates in body axes",
        controls="They stand in the last columns, at the sample times.",
    )
    # The line that tells of the setting, the notes, and the names.
    count = len(told) + 2
    setting = f"Set headerLines = {count}, attitudeType = 1, useReferenceFrame = True."
    lines = [f"# {line}" for line in (setting, *told)]
    rows = {row[0]: row for track in tracks for row in _rows(track, controls)}
    lines += [",".join(names), *(",".join(map(repr, row)) for row in rows.values())]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def _rows(track: Track, controls: tuple[str, ...]) -> list[list[float]]:
    s = track.samples
    nothing = np.full(len(s.t_s), np.nan)
    own = np.stack([s.columns.get(name, nothing) for name in controls], axis=-1)
    table = np.hstack(
        [
            s.t_s[:, None], s.q_IB, s.rate_rad_s, s.rate_change_rad_s2, s.position_m,
            s.velocity_m_s, own,
        ]
    )  # fmt: skip
    table[np.abs(table) < SMALLEST] = 0.0
    return [[float(v) for v in row] for row in table]
