"""Structures and their motions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.build.parts import build_body
from berthing.scenario.build.poses import build_pose
from berthing.scenario.build.shapes import rows_of
from berthing.scenario.motion import ConstantSpin, ConstantVelocity, Fixed, Motion
from berthing.scenario.schema.fields import Block
from berthing.scenario.schema.structures import (
    ConstantVelocityMotion,
    FixedMotion,
    SpinMotion,
    StructureBlock,
    TabulatedMotion,
)
from berthing.scenario.source import Path, Source
from berthing.scenario.structure import Structure
from berthing.scenario.tabulated import Tabulated


def build_structure(block: StructureBlock, dim: int, source: Source, path: Path) -> Structure:
    """A structure of the scenario's dimension.

    Raises:
        InputError: anything in it that cannot be.
    """
    if isinstance(block.motion, TabulatedMotion):
        for key in ("position_m", "attitude", "angle_rad"):
            if getattr(block, key) is not None:
                raise source.error((*path, key), "stands beside a table of poses", "none")
    body = build_body(block.parts or (), dim, source, (*path, "parts"))
    pose = build_pose(block, dim, source, path)
    with source.at(*path, "motion"):
        motion = _MOTIONS[type(block.motion)](block.motion, pose)
    return Structure(block.name, body, motion)


def _spin(block: SpinMotion, pose: Pose) -> Motion:
    velocity = np.zeros(pose.dim) if block.velocity_m_s is None else np.array(block.velocity_m_s)
    return ConstantSpin(pose, np.array(block.axis), block.rate_rad_s, velocity)


def _tabulated(block: TabulatedMotion, pose: Pose) -> Motion:
    positions = rows_of(block.positions_m, pose.dim, "positions_m")
    return Tabulated(np.array(block.times_s), positions, _attitudes(block, len(block.times_s)))


def _attitudes(block: TabulatedMotion, count: int) -> Array:
    if block.attitudes is not None:
        return np.array(block.attitudes)
    angles = np.zeros(count) if block.angles_rad is None else np.array(block.angles_rad)
    return quaternion.from_axis_angle(np.array([0.0, 0.0, 1.0]), angles)


_MOTIONS: dict[type[Block], Callable[[Any, Pose], Motion]] = {
    FixedMotion: lambda block, pose: Fixed(pose),
    ConstantVelocityMotion: lambda b, pose: ConstantVelocity(pose, np.array(b.velocity_m_s)),
    SpinMotion: _spin,
    TabulatedMotion: _tabulated,
}
