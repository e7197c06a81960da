"""Vehicles: dynamics and limits in native units."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.bicycle import bicycle
from berthing.scenario.build.ends import build_end
from berthing.scenario.build.names import check_exists, check_unique
from berthing.scenario.build.parts import build_body
from berthing.scenario.build.user_code import build_path_constraints, build_user_model
from berthing.scenario.free_flyer import free_flyer
from berthing.scenario.goal import End
from berthing.scenario.limits import Limits
from berthing.scenario.native_state import Model
from berthing.scenario.point_mass import PointMass
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.schema.fields import Block
from berthing.scenario.schema.user import UserModelBlock
from berthing.scenario.schema.vehicles import (
    BicycleBlock,
    FreeFlyerBlock,
    PointMassBlock,
    RigidBodyBlock,
    VehicleBlock,
    WrenchBlock,
)
from berthing.scenario.source import Absent, Path, Source
from berthing.scenario.vehicle import Vehicle
from berthing.scenario.wrench import Wrench


def build_vehicle(
    block: VehicleBlock, dim: int, before: End | None, source: Source, path: Path
) -> Vehicle:
    """A vehicle of the scenario's dimension.

    Args:
        before: its goal in the phase before, None where there is none: the start of a vehicle
            that is not given one.

    Raises:
        InputError: anything in it that cannot be.
    """
    body = build_body(block.parts or (), dim, source, (*path, "parts"))
    model = _MODELS[type(block.dynamics)](block.dynamics, dim, source, (*path, "dynamics"))
    if model.dim != dim:
        what = f"is {model.kind}, of {model.dim} dimensions in a scenario of {dim}"
        known = "point-mass, free-flyer or bicycle in the plane"
        raise source.error((*path, "dynamics", "model"), what, known)
    limits = _limits(block, model, source, (*path, "limits"))
    goal = build_end(block.goal, model, source, (*path, "goal"))
    if block.start is not None:
        before = build_end(block.start, model, source, (*path, "start"))
    if before is None:
        what = "is missing, and no phase before has a goal for this vehicle"
        raise source.error((*path, "start"), f"start {what}")
    constraints = build_path_constraints(block.path_constraints, source, path)
    with source.at(*path):
        return Vehicle(block.name, body, model, limits, before, goal, constraints)


def _rigid_body(block: RigidBodyBlock, dim: int, source: Source, path: Path) -> Model:
    check_unique([w.name for w in block.wrenches], source, (*path, "wrenches"))
    wrenches = tuple(
        _wrench(w, source, (*path, "wrenches", i)) for i, w in enumerate(block.wrenches)
    )
    if block.mass_kg is None:
        raise source.error((*path, Absent("mass_kg")), "is missing")
    if block.inertia_kg_m2 is None:
        raise source.error((*path, Absent("inertia_kg_m2")), "is missing")
    inertia = np.array(block.inertia_kg_m2)
    with source.at(*path):
        return RigidBody(
            block.mass_kg,
            np.diag(inertia) if inertia.ndim == 1 else inertia,
            np.array(block.first_moment_kg_m),
            wrenches,
        )


def _wrench(block: WrenchBlock, source: Source, path: Path) -> Wrench:
    with source.at(*path):
        return Wrench(
            block.name,
            np.array(block.point_m),
            np.array(block.times_s),
            np.array(block.force_n),
            np.array(block.torque_nm),
        )


_MODELS: dict[type[Block], Callable[[Any, int, Source, Path], Model]] = {
    RigidBodyBlock: _rigid_body,
    PointMassBlock: lambda block, dim, source, path: PointMass(block.mass_kg, dim),
    BicycleBlock: lambda block, dim, source, path: bicycle(block.wheelbase_m),
    FreeFlyerBlock: lambda block, dim, source, path: free_flyer(block.mass_kg, block.inertia_kg_m2),
    UserModelBlock: lambda block, dim, source, path: build_user_model(block, source, path),
}

# Key of the limits block, and the native columns that it bounds by their names' beginnings.
_SYMMETRIC = {
    "max_force_n": ("control", "f"),
    "max_torque_nm": ("control", "g"),
    "max_speed_m_s": ("state", "v"),
    "max_rate_rad_s": ("state", "w"),
}


def _limits(block: VehicleBlock, model: Model, source: Source, path: Path) -> Limits:
    names = {"state": model.state_names, "control": model.control_names}
    lower = {kind: np.full(len(columns), -np.inf) for kind, columns in names.items()}
    upper = {kind: np.full(len(columns), np.inf) for kind, columns in names.items()}
    for key, (kind, letter) in _SYMMETRIC.items():
        value = getattr(block.limits, key)
        if value is not None:
            columns = [i for i, name in enumerate(names[kind]) if name.startswith(letter)]
            if not columns:
                what = f"limits what {model.noun} does not have"
                raise source.error((*path, key), what, "no such limit")
            bound = _per_axis(value, len(columns), source, (*path, key))
            lower[kind][columns], upper[kind][columns] = -bound, bound
    box = block.limits.position_m
    for end, into, sign in (("lower", lower, -1.0), ("upper", upper, 1.0)):
        values = None if box is None else getattr(box, end)
        if values is not None:
            open_ended = [sign * np.inf if v is None else v for v in values]
            bound = _per_axis(open_ended, model.dim, source, (*path, "position_m", end))
            columns = _position_columns(model, source, (*path, "position_m"))
            into["state"][columns] = bound
    for kind in ("state", "control"):
        for name, (low, high) in getattr(block.limits, f"{kind}s").items():
            check_exists(name, names[kind], kind, source, (*path, f"{kind}s", name))
            i = names[kind].index(name)
            lower[kind][i] = -np.inf if low is None else low
            upper[kind][i] = np.inf if high is None else high
    with source.at(*path):
        return Limits(lower["control"], upper["control"], lower["state"], upper["state"])


def _position_columns(model: Model, source: Source, path: Path) -> list[int]:
    names = [f"{axis}_m" for axis in "xyz"[: model.dim]]
    if not set(names) <= set(model.state_names):
        raise source.error(path, "limits what is no state of this model", "states: by name")
    return [model.state_names.index(name) for name in names]


def _per_axis(value: float | Sequence[float], count: int, source: Source, path: Path) -> Array:
    values = np.atleast_1d(np.array(value, dtype=np.float64))
    if np.ndim(value) > 0 and len(values) != count:
        raise source.error(path, f"has {len(values)} entries", f"{count}, or one number")
    return np.broadcast_to(values, (count,))
