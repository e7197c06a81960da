"""Reading and writing the data files of a plan folder."""

from berthing.trajectory_io.columns import HEADER, trajectory_columns
from berthing.trajectory_io.interpolant_json import Interpolant, read_interpolant, write_interpolant
from berthing.trajectory_io.nodes_csv import read_nodes, write_nodes
from berthing.trajectory_io.strict_json import read_object, read_versioned
from berthing.trajectory_io.trajectory_csv import (
    MIN_SAMPLES,
    TrajectoryTable,
    read_trajectory,
    write_trajectory,
)

__all__ = [
    "HEADER",
    "MIN_SAMPLES",
    "Interpolant",
    "TrajectoryTable",
    "read_interpolant",
    "read_nodes",
    "read_object",
    "read_trajectory",
    "read_versioned",
    "trajectory_columns",
    "write_interpolant",
    "write_nodes",
    "write_trajectory",
]
