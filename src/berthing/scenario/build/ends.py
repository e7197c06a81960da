"""Starts and goals."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.attitude import Attitude, AxisAttitude, FixedAttitude, FreeAttitude
from berthing.scenario.goal import End
from berthing.scenario.native_state import Model
from berthing.scenario.schema.vehicles import AxisBlock, EndBlock
from berthing.scenario.source import Path, Source

IDENTITY = (1.0, 0.0, 0.0, 0.0)


def build_end(block: EndBlock, model: Model, source: Source, path: Path) -> End:
    """A start or goal for a vehicle of this model.

    A model without attitude gets a free one and a free rate: there is nothing to ask of it.

    Raises:
        InputError: components of another dimension, a quaternion that is not unit, or an
            attitude or rate asked of a model that has none.
    """
    turns = "qw" in model.state_names
    if not turns:
        _refuse_turning(block, source, path)
    if len(block.position_m) != model.dim:
        what = f"has {len(block.position_m)} components in a scenario of {model.dim} dimensions"
        raise source.error((*path, "position_m"), what)
    with source.at(*path, "attitude"):
        attitude = _ATTITUDES[type(block.attitude)](block) if turns else FreeAttitude()
    with source.at(*path):
        return End(
            np.array(block.position_m),
            block.position_tolerance_m,
            attitude,
            _at_rest_unless(block.velocity_m_s, model.dim),
            _at_rest_unless(block.rate_rad_s, 3) if turns else None,
            block.frame,
        )


def _refuse_turning(block: EndBlock, source: Source, path: Path) -> None:
    if block.attitude not in (None, "free", list(IDENTITY)):
        raise source.error((*path, "attitude"), "is asked of a point mass", "none, or free")
    if isinstance(block.rate_rad_s, list) and any(block.rate_rad_s):
        raise source.error((*path, "rate_rad_s"), "is asked of a point mass", "none, or free")


def _at_rest_unless(value: list[float] | str | None, length: int) -> Array | None:
    if isinstance(value, str):
        return None
    return np.zeros(length) if value is None else np.array(value)


def _axis(block: EndBlock) -> Attitude:
    axes: Any = block.attitude
    return AxisAttitude(np.array(axes.body_axis), np.array(axes.points_along), axes.tolerance_rad)


_ATTITUDES: dict[type, Callable[[EndBlock], Attitude]] = {
    type(None): lambda b: FixedAttitude(np.array(IDENTITY), b.attitude_tolerance_rad),
    list: lambda b: FixedAttitude(np.array(b.attitude), b.attitude_tolerance_rad),
    str: lambda b: FreeAttitude(),
    AxisBlock: _axis,
}
