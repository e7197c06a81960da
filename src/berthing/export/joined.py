"""One vehicle over all phases, for formats that know one series of instants only."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from berthing.errors import InputError
from berthing.export.handover import Track
from berthing.export.samples import continuous
from berthing.geometry.arrays import Array


def joined(tracks: Sequence[Track]) -> tuple[Array, Array, Array, Array]:
    """Times (k,), positions and velocities (k, 3) and quaternions (k, 4) of one vehicle.

    Of an instant that two phases share, the later one's values are there.

    Raises:
        InputError: the vehicle is away for a while, and so has no one motion.
    """
    for before, after in pairwise(tracks):
        if before.trajectory.t1_s != after.trajectory.t0_s:
            what = f"{after.name} is not there between {before.phase.name} and {after.phase.name}"
            raise InputError("plan", what, "a vehicle of consecutive phases")
    t = np.concatenate([track.samples.t_s for track in tracks])
    kept = np.append(t[1:] != t[:-1], True)
    columns = [
        np.concatenate([getattr(track.samples, name) for track in tracks])[kept]
        for name in ("position_m", "velocity_m_s", "q_IB")
    ]
    return t[kept], columns[0], columns[1], continuous(columns[2])
