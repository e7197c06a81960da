"""Starts and goals."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.attitude import Attitude, AxisAttitude, FixedAttitude, FreeAttitude
from berthing.scenario.build.names import check_exists
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
    turns = model.turns
    if not turns:
        _refuse_turning(block, model, source, path)
    if block.angle_rad is not None and (model.dim == 3 or block.attitude is not None):
        what = "is a turn in the plane" if model.dim == 3 else "stands beside an attitude"
        raise source.error((*path, "angle_rad"), what, "attitude, or none")
    if len(block.position_m) != model.dim:
        what = f"has {len(block.position_m)} components in a scenario of {model.dim} dimensions"
        raise source.error((*path, "position_m"), what)
    for name in block.states:
        check_exists(name, model.state_names, "state", source, (*path, "states", name))
    with source.at(*path, "attitude"):
        attitude = _attitude(block) if turns else FreeAttitude()
    with source.at(*path):
        return End(
            np.array(block.position_m),
            block.position_tolerance_m,
            attitude,
            _rate(block.velocity_m_s, model.dim, model),
            _rate(block.rate_rad_s, 3, model) if turns else None,
            block.frame,
            block.states,
        )


def _refuse_turning(block: EndBlock, model: Model, source: Source, path: Path) -> None:
    asked = f"is asked of {model.noun}"
    if block.attitude not in (None, "free", list(IDENTITY)):
        raise source.error((*path, "attitude"), asked, "none, or free")
    if block.angle_rad not in (None, 0.0):
        raise source.error((*path, "angle_rad"), asked, "none")
    if isinstance(block.rate_rad_s, list) and any(block.rate_rad_s):
        raise source.error((*path, "rate_rad_s"), asked, "none, or free")


def _rate(value: list[float] | str | None, length: int, model: Model) -> Array | None:
    """At rest unless told otherwise; free where that cannot be asked."""
    if isinstance(value, str) or (value is None and not model.tells_rates):
        return None
    return np.zeros(length) if value is None else np.array(value)


def _attitude(block: EndBlock) -> Attitude:
    if block.angle_rad is not None:
        half = 0.5 * block.angle_rad
        q = np.array([np.cos(half), 0.0, 0.0, np.sin(half)])
        return FixedAttitude(q, block.attitude_tolerance_rad)
    return _ATTITUDES[type(block.attitude)](block)


def _axis(block: EndBlock) -> Attitude:
    axes: Any = block.attitude
    return AxisAttitude(np.array(axes.body_axis), np.array(axes.points_along), axes.tolerance_rad)


_ATTITUDES: dict[type, Callable[[EndBlock], Attitude]] = {
    type(None): lambda b: FixedAttitude(np.array(IDENTITY), b.attitude_tolerance_rad),
    list: lambda b: FixedAttitude(np.array(b.attitude), b.attitude_tolerance_rad),
    str: lambda b: FreeAttitude(),
    AxisBlock: _axis,
}
