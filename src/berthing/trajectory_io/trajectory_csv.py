"""trajectory.csv: uniform samples of every vehicle, for whoever wants no polynomials."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.scenario.scenario import Scenario
from berthing.trajectory import PhaseTrajectory
from berthing.trajectory_io.columns import HEADER, native_columns, trajectory_columns
from berthing.trajectory_io.tables import read_table, rows_of, write_table

MIN_SAMPLES = 1001
# A table of more is nothing that was planned.
MOST_VEHICLES = 1000


@dataclass(frozen=True)
class TrajectoryTable:
    """What the file says.

    Attributes:
        vehicles: for each vehicle its columns (k,) by name, ``t_s`` among them, in the order of
            the file; NaN where a cell is empty.
    """

    vehicles: Mapping[str, Mapping[str, Array]]


def write_trajectory(
    path: Path,
    scenario: Scenario,
    phases: Sequence[PhaseTrajectory],
    samples: int = MIN_SAMPLES,
) -> None:
    """Write ``samples`` uniform samples of each vehicle in each phase.

    The header is ``HEADER`` and then the native columns that differ. Cells of what a vehicle
    lacks are empty.
    """
    header = (*HEADER, *native_columns(scenario))
    rows: list[list[str]] = []
    for phase, trajectory in zip(scenario.phases, phases, strict=True):
        for own in trajectory.vehicles:
            t = np.linspace(own.t0_s, own.t1_s, samples)
            columns = trajectory_columns(phase.vehicle(own.vehicle).model, own, t)
            rows += rows_of(header, {"vehicle": own.vehicle}, {"t_s": t, **columns})
    write_table(path, header, rows)


def read_trajectory(path: Path) -> TrajectoryTable:
    """Read it back.

    Raises:
        InputError: missing or malformed, another header, a cell that is not a finite number.
    """
    table = read_table(path)
    if table.header[: len(HEADER)] != HEADER:
        raise InputError(table.where, "has another header", ",".join(HEADER))
    groups = table.rows_by("vehicle")
    if len(groups) > MOST_VEHICLES:
        raise InputError(table.where, f"has {len(groups)} vehicles", f"at most {MOST_VEHICLES}")
    numeric = [name for name in table.header if name != "vehicle"]
    return TrajectoryTable(
        {
            vehicle: {name: table.numbers(name, rows) for name in numeric}
            for (vehicle,), rows in groups.items()
        }
    )
