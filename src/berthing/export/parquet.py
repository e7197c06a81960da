"""Apache Parquet: the columns of trajectory.csv, with the notes as the file's metadata."""

from __future__ import annotations

import json
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from berthing.export.extras import extra
from berthing.export.handover import Handover
from berthing.export.notes import notes
from berthing.export.table import columns, labels
from berthing.geometry.arrays import Array

QUATERNION_NOTE = "qw qx qy qz, scalar first: q_IB turns body axes to the frame's"
UNITS_NOTE = "in the names of the columns; rates, forces and torques of bodies in body axes"
CONTROLS_NOTE = "Their columns hold them at the sample times."


def write(handover: Handover, path: Path) -> None:
    """A row for each vehicle, phase and instant; null where a vehicle has no such column.

    Raises:
        InputError: pyarrow is not installed.
    """
    arrow = extra("pyarrow")
    table = {name: arrow.array(values) for name, values in labels(handover).items()}
    table |= {name: _nullable(arrow, values) for name, values in columns(handover).items()}
    whole = arrow.table(table).replace_schema_metadata(_metadata(handover))
    import_module("pyarrow.parquet").write_table(whole, str(path))


def _metadata(handover: Handover) -> dict[str, str]:
    epoch = handover.meta.epoch
    told = notes(handover, quaternion=QUATERNION_NOTE, units=UNITS_NOTE, controls=CONTROLS_NOTE)
    interpolation = {t.name: t.trajectory.control_interpolation for t in handover.tracks}
    return {
        "berthing": "\n".join(told),
        "berthing.epoch": "" if epoch is None else f"{epoch.iso()} {epoch.scale}",
        "berthing.frame": handover.meta.frame or "",
        "berthing.centre": handover.meta.centre or "",
        "berthing.quaternion": "q_IB, scalar first",
        "berthing.control_interpolation": json.dumps(interpolation),
    }


def _nullable(arrow: Any, values: Array) -> Any:
    return arrow.array(values, mask=np.isnan(values))
