"""STK attitude (.a): the quaternion of one vehicle."""

from __future__ import annotations

from pathlib import Path

from berthing.export import stk
from berthing.export.handover import Handover
from berthing.export.joined import joined
from berthing.export.notes import notes
from berthing.export.order import SCALAR_LAST, scalar_last

AXES = "stk_axes"


def write(handover: Handover, path: Path) -> None:
    """One table over all phases, scalar last.

    Raises:
        InputError: a frame or centre that STK has not, and no ``stk_axes``.
    """
    t, _, _, q = joined(handover.tracks)
    head = [
        "BlockingFactor 20",
        "InterpolationOrder 1",
        *stk.reference(handover, "CoordinateAxes", AXES),
    ]
    told = notes(handover, quaternion=SCALAR_LAST, units="s")
    rows = scalar_last(q)
    stk.write_table(path, handover, told, "Attitude", head, "AttitudeTimeQuaternions", t, rows)
