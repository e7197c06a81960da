"""All samples as columns, for formats that are tables."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from berthing.export.handover import Handover
from berthing.geometry.arrays import Array
from berthing.trajectory_io import HEADER
from berthing.trajectory_io.columns import native_columns

LABELS = ("phase", "vehicle")


def labels(handover: Handover) -> dict[str, list[str]]:
    """Phase and vehicle of every row."""
    rows = [(t.phase.name, t.name) for t in handover.tracks for _ in t.samples.t_s]
    return {name: [row[i] for row in rows] for i, name in enumerate(LABELS)}


def columns(handover: Handover) -> Mapping[str, Array]:
    """The numeric columns of trajectory.csv over all rows, NaN where a vehicle has none."""
    names = [*(n for n in HEADER if n != "vehicle"), *native_columns(handover.scenario)]
    return {
        name: np.concatenate(
            [
                {"t_s": t.samples.t_s, **t.samples.columns}.get(
                    name, np.full(len(t.samples.t_s), np.nan)
                )
                for t in handover.tracks
            ]
        )
        for name in names
    }
