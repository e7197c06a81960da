"""A scenario as it stands at a later time, on a clock that begins there."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array, as_array
from berthing.geometry.pose import Pose
from berthing.scenario.attitude import FixedAttitude
from berthing.scenario.goal import End
from berthing.scenario.horizon import Horizon
from berthing.scenario.margin import MarginPolicy
from berthing.scenario.motion import ConstantSpin, ConstantVelocity, Fixed
from berthing.scenario.phase import Phase
from berthing.scenario.point_mass import PointMass
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle

LEAST_HORIZON = 1e-3
"""Share of the longest duration left that a free horizon keeps as its shortest."""

LAWS: dict[type, Callable[[Any, Pose], Any]] = {
    Fixed: lambda law, pose: Fixed(pose),
    ConstantVelocity: lambda law, pose: replace(law, pose0=pose),
    ConstantSpin: lambda law, pose: replace(law, pose0=pose),
}
"""Laws that are the same from any time on, but for the pose that they begin with."""


def begun_at(
    scenario: Scenario,
    state: Mapping[str, Array] | Array,
    time_s: float,
    structures: Mapping[str, Pose],
) -> Scenario:
    """``scenario`` from ``time_s`` on: vehicles start in ``state``, structures where measured.

    Raises:
        InputError: several phases; unknown names; a state of the wrong size; a model, law or
            function that depends on the clock in a way that is not shifted.
    """
    if len(scenario.phases) != 1:
        raise InputError("phases", f"are {len(scenario.phases)}", "one")
    (phase,) = scenario.phases
    names = [structure.name for structure in scenario.structures]
    for name in structures:
        if name not in names:
            raise InputError("structures", f"has {name!r}", f"one of: {', '.join(names)}")
    states = state if isinstance(state, Mapping) else {phase.vehicles[0].name: state}
    for name in states:
        phase.vehicle(name)
    vehicles = tuple(_started(v, states.get(v.name), time_s) for v in phase.vehicles)
    if phase.cost.running and time_s > 0.0:
        raise InputError("cost", "has functions of the user's own", "none, once time has passed")
    later = replace(phase, vehicles=vehicles, horizon=_left(phase, time_s))
    return replace(
        scenario,
        phases=(later,),
        structures=tuple(_moved(s, structures.get(s.name), time_s) for s in scenario.structures),
        margins=_windows(scenario.margins, time_s),
    )


def _started(vehicle: Vehicle, state: Array | None, time_s: float) -> Vehicle:
    model, where = vehicle.model, f"state[{vehicle.name}]"
    if state is None:
        raise InputError(where, "is missing", "the native state of every vehicle")
    if not isinstance(model, RigidBody | PointMass):
        raise InputError(where, f"is of a {model.kind}", "a rigid body or a point mass")
    wrenches = isinstance(model, RigidBody) and model.wrenches
    if time_s > 0.0 and (wrenches or vehicle.path_constraints):
        raise InputError(vehicle.name, "has loads or constraints over time", "none of them")
    x = as_array(state, (len(model.state_names),), where)
    values = dict(zip(model.state_names, x, strict=True))

    def pick(names: tuple[str, ...]) -> Array:
        return np.array([values[name] for name in names if name in values])

    q = pick(("qw", "qx", "qy", "qz"))
    attitude = FixedAttitude(quaternion.normalise(q)) if len(q) else vehicle.start.attitude
    rate = pick(("wx_rad_s", "wy_rad_s", "wz_rad_s"))
    start = End(
        position_m=pick(("x_m", "y_m", "z_m")),
        attitude=attitude,
        velocity_m_s=pick(("vx_m_s", "vy_m_s", "vz_m_s")),
        rate_rad_s=rate if len(rate) else vehicle.start.rate_rad_s,
    )
    return replace(vehicle, start=start)


def _moved(structure: Structure, measured: Pose | None, time_s: float) -> Structure:
    if measured is None and time_s == 0.0:
        return structure
    law = LAWS.get(type(structure.motion))
    if law is None:
        raise InputError(
            structure.name, f"moves by a {structure.motion.kind} law",
            "one that is fixed, drifts or spins",
        )  # fmt: skip
    pose = measured if measured is not None else structure.motion.pose(np.array([time_s]))[0]
    return replace(structure, motion=law(structure.motion, pose))


def _left(phase: Phase, time_s: float) -> Horizon:
    longest = phase.horizon.max_s - time_s
    if not phase.horizon.is_free:
        return Horizon.fixed(longest)
    return Horizon(max(phase.horizon.min_s - time_s, LEAST_HORIZON * longest), longest)


def _windows(margins: MarginPolicy, time_s: float) -> MarginPolicy:
    kept = []
    for own in margins.overrides:
        if own.window_s is None:
            kept.append(own)
        elif own.window_s[1] > time_s:
            shifted = own.window_s[0] - time_s, own.window_s[1] - time_s
            kept.append(replace(own, window_s=shifted))
    return replace(margins, overrides=tuple(kept))
