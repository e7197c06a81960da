"""STK ephemeris (.e): position and velocity of one vehicle."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from berthing.export import stk
from berthing.export.handover import Handover
from berthing.export.joined import joined
from berthing.export.notes import notes

SYSTEM = "stk_system"


def write(handover: Handover, path: Path) -> None:
    """One table over all phases, in metres.

    Raises:
        InputError: a frame or centre that STK has not, and no ``stk_system``.
    """
    t, position, velocity, _ = joined(handover.tracks)
    head = [
        # Two samples to an interval, so that no polynomial crosses a break of the plan.
        "InterpolationMethod Hermite",
        "InterpolationSamplesM1 1",
        *stk.reference(handover, "CoordinateSystem", SYSTEM),
        "DistanceUnit Meters",
    ]
    told = notes(handover, quaternion="", units="m and m/s")
    rows = np.hstack([position, velocity])
    stk.write_table(path, handover, told, "Ephemeris", head, "EphemerisTimePosVel", t, rows)
