"""Placements."""

from __future__ import annotations

import numpy as np

from berthing.geometry.pose import Pose
from berthing.scenario.attitude import unit
from berthing.scenario.schema.shapes import Placed
from berthing.scenario.source import Path, Source


def build_pose(block: Placed, dim: int, source: Source, path: Path) -> Pose:
    """The pose that a block gives, the identity where it is silent.

    Raises:
        InputError: a position or turn of another dimension, or a quaternion that is not unit.
    """
    position = np.zeros(dim) if block.position_m is None else np.array(block.position_m)
    if len(position) != dim:
        what = f"has {len(position)} components in a scenario of {dim} dimensions"
        raise source.error((*path, "position_m"), what)
    if dim == 2:
        if block.attitude is not None:
            raise source.error((*path, "attitude"), "is a turn in space", "angle_rad, in the plane")
        return Pose.planar(position, block.angle_rad or 0.0)
    if block.angle_rad is not None:
        raise source.error((*path, "angle_rad"), "is a turn in the plane", "attitude, in space")
    if block.attitude is None:
        return Pose(position, np.eye(3))
    with source.at(*path):
        return Pose.from_quaternion(position, unit(np.array(block.attitude), 4, "attitude"))
