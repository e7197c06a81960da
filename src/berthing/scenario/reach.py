"""Goals that no control within the limits can reach, whatever stands in the way.

Every bound here is a proof. In translation, for an acceleration of norm at most A during T,
Δr − ½(v₀ + v₁)T = ∫(T/2 − s) a(s) ds, whose norm is at most A T²/4; Δr − v₀T and Δr − v₁T are
at most A T²/2, and v₁ − v₀ at most A T. For a rigid body r is its centre of mass. In rotation,
from rest to rest, the angular momentum about the centre of mass is at most G min(t, T − t) for a
torque of norm at most G, so the body turns by at most G T²/(4 J_min).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.scenario.attitude import FixedAttitude, FreeAttitude
from berthing.scenario.authority import Authority, authority
from berthing.scenario.goal import End, InertialEnd
from berthing.scenario.motion import Fixed
from berthing.scenario.phase import Phase
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.scenario import Scenario
from berthing.scenario.user_model import UserModel
from berthing.scenario.vehicle import Vehicle

# Relative room for rounding: what exceeds its bound by less may be reachable.
ROUNDING = 1e-9


def check(scenario: Scenario, phase: Phase, vehicle: Vehicle) -> None:
    """Refuse ends outside the vehicle's limits, and a goal provably out of its reach.

    Where an end rides on a moving structure and the clock is not known beforehand (a free
    horizon), nothing is claimed; nor of models of the user's own.

    Raises:
        InputError: with the bound and the numbers.
    """
    ends = _resolved(scenario, phase, vehicle)
    if ends is None or isinstance(vehicle.model, UserModel):
        return
    start, goal = ends
    for name, end in (("start", start), ("goal", goal)):
        _check_limits(name, end, vehicle)
    strength = authority(vehicle)
    _check_speed(start, goal, vehicle, phase.horizon.max_s)
    _check_translation(start, goal, vehicle, strength, phase)
    if isinstance(vehicle.model, RigidBody):
        _check_rotation(start, goal, vehicle, strength, phase.horizon.max_s)


def _resolved(
    scenario: Scenario, phase: Phase, vehicle: Vehicle
) -> tuple[InertialEnd, InertialEnd] | None:
    index = [p.name for p in scenario.phases].index(phase.name)
    earlier = [p.horizon for p in scenario.phases[:index]]
    begins = sum(h.max_s for h in earlier)
    start_is_known = not any(h.is_free for h in earlier)
    known = {
        "start": start_is_known,
        "goal": start_is_known and not phase.horizon.is_free,
    }
    times = {"start": begins, "goal": begins + phase.horizon.max_s}
    ends: dict[str, End] = {"start": vehicle.start, "goal": vehicle.goal}
    for key, end in ends.items():
        moves = end.frame is not None and not isinstance(
            scenario.structure(end.frame).motion, Fixed
        )
        if moves and not known[key]:
            return None
    return ends["start"].resolve(times["start"], scenario), ends["goal"].resolve(
        times["goal"], scenario
    )


def _check_limits(name: str, end: InertialEnd, vehicle: Vehicle) -> None:
    """Each component that the end fixes must lie within its bounds, tolerances granted."""
    dim, limits = vehicle.dim, vehicle.limits
    given: list[tuple[slice, Array | None, float]] = [
        (slice(0, dim), end.position_m, end.position_tolerance_m),
        (slice(dim, 2 * dim), end.velocity_m_s, 0.0),
    ]
    if isinstance(vehicle.model, RigidBody) and not np.any(end.frame_rate_rad_s):
        given.append((slice(10, 13), end.relative_rate_rad_s, 0.0))
    for columns, value, slack in given:
        if value is None:
            continue
        lower, upper = limits.state_lower[columns], limits.state_upper[columns]
        outside = np.maximum(lower - value, value - upper) - slack
        worst = int(np.argmax(outside))
        if outside[worst] > ROUNDING * (1.0 + abs(value[worst])):
            column = vehicle.model.state_names[columns][worst]
            raise InputError(
                "goal",
                f"the {name} has {column} = {value[worst]:.6g}, outside the vehicle's limits",
                f"{lower[worst]:.6g} to {upper[worst]:.6g}",
            )


def _check_speed(start: InertialEnd, goal: InertialEnd, vehicle: Vehicle, time: float) -> None:
    dim, limits = vehicle.dim, vehicle.limits
    fastest = np.maximum(-limits.state_lower, limits.state_upper)[dim : 2 * dim]
    way = np.abs(goal.position_m - start.position_m)
    way = way - start.position_tolerance_m - goal.position_tolerance_m
    for axis, length, speed in zip("xyz", way, fastest, strict=False):
        if length > speed * time * (1.0 + ROUNDING):
            raise _out_of_reach(
                f"{length:.6g} m along {axis} at no more than {speed:.6g} m/s", time, length / speed
            )


@dataclass(frozen=True, eq=False)
class _Centre:
    """Centre of mass at an end: a ball of positions and, where known, a ball of velocities."""

    position: Array
    position_slack: float
    velocity: Array | None
    velocity_slack: float


def _centre(end: InertialEnd, vehicle: Vehicle) -> _Centre:
    frame_rate = float(np.linalg.norm(end.frame_rate_rad_s))
    swept_slack = frame_rate * end.position_tolerance_m
    if not isinstance(vehicle.model, RigidBody):
        return _Centre(end.position_m, end.position_tolerance_m, end.velocity_m_s, swept_slack)
    offset = vehicle.model.centre_of_mass_m
    arm = float(np.linalg.norm(offset))
    # Attitudes of the set move the centre of mass by at most a chord of its circle.
    attitude = end.attitude
    half = 0.5 * (attitude.tolerance_rad if isinstance(attitude, FixedAttitude) else np.pi)
    chord = 2.0 * arm * float(np.sin(half))
    rotation = quaternion.rotation_matrix(attitude.nominal())
    position = end.position_m + rotation @ offset
    slack = end.position_tolerance_m + chord
    velocity, rate = end.velocity_m_s, end.relative_rate_rad_s
    if arm == 0.0 or velocity is None:
        return _Centre(position, slack, velocity, swept_slack)
    if rate is None:
        return _Centre(position, slack, None, 0.0)
    # v_cm = v + R (ω_rel × o) + ω_F × R o.
    swept = rotation @ np.cross(rate, offset) + np.cross(end.frame_rate_rad_s, rotation @ offset)
    swept_slack += (float(np.linalg.norm(rate)) + frame_rate) * chord
    return _Centre(position, slack, velocity + swept, swept_slack)


def _check_translation(
    start: InertialEnd, goal: InertialEnd, vehicle: Vehicle, strength: Authority, phase: Phase
) -> None:
    a, b = _centre(start, vehicle), _centre(goal, vehicle)
    known = [(c.velocity, c.velocity_slack) for c in (a, b) if c.velocity is not None]
    if not known:
        return
    time = phase.horizon.max_s
    drift = sum((v for v, _ in known), np.zeros(vehicle.dim)) / len(known)
    slack = a.position_slack + b.position_slack + time * sum(s for _, s in known) / len(known)
    need = np.abs(b.position - a.position - drift * time)
    if phase.horizon.is_free:
        # For every T up to the longest, |Δr_i − v_i T| ≥ |Δr_i| − |v_i| T_max.
        need = np.maximum(np.abs(b.position - a.position) - np.abs(drift) * time, 0.0)
    half = 0.25 if len(known) == 2 else 0.5
    exact = slack == 0.0 and not any(np.any(v) for v, _ in known)
    for along, length, power in _norm_and_axes(need, strength):
        most = half * power * time**2
        if length - slack > most * (1.0 + ROUNDING):
            told = (
                f"thrust moves the centre of mass by at most {most:.6g} m{along} in that time, "
                f"and {length - slack:.6g} m are needed"
            )
            least = float(np.sqrt(length / (half * power))) if exact and power else None
            raise _out_of_reach(told, time, least)
    if len(known) == 2:
        _check_speed_change(known[1][0] - known[0][0], known[0][1] + known[1][1], strength, time)


def _check_speed_change(change: Array, slack: float, strength: Authority, time: float) -> None:
    for along, speed, power in _norm_and_axes(np.abs(change), strength):
        if speed - slack > power * time * (1.0 + ROUNDING):
            told = (
                f"thrust changes the velocity by at most {power * time:.6g} m/s{along} in that "
                f"time, and {speed - slack:.6g} m/s are needed"
            )
            raise _out_of_reach(told, time, (speed - slack) / power if power else None)


def _norm_and_axes(need: Array, strength: Authority) -> list[tuple[str, float, float]]:
    cases = [("", float(np.linalg.norm(need)), strength.acceleration_m_s2)]
    if strength.per_axis_m_s2 is not None:
        rows = zip("xyz", need, strength.per_axis_m_s2, strict=False)
        cases += [(f" along {axis}", float(n), float(power)) for axis, n, power in rows]
    return cases


def _check_rotation(
    start: InertialEnd, goal: InertialEnd, vehicle: Vehicle, strength: Authority, time: float
) -> None:
    angle = _least_turn(start, goal)
    fastest = np.maximum(-vehicle.limits.state_lower, vehicle.limits.state_upper)[10:13]
    rate = float(np.linalg.norm(fastest))
    if angle > rate * time * (1.0 + ROUNDING):
        told = f"a turn of {angle:.6g} rad at no more than {rate:.6g} rad/s"
        raise _out_of_reach(told, time, angle / rate)
    power = strength.angular_rad_s2
    at_rest = all(
        end.relative_rate_rad_s is not None
        and not np.any(end.relative_rate_rad_s)
        and not np.any(end.frame_rate_rad_s)
        for end in (start, goal)
    )
    if at_rest and angle > 0.25 * power * time**2 * (1.0 + ROUNDING):
        most = 0.25 * power * time**2
        told = (
            f"torque and thrust turn the vehicle by {most:.6g} rad in that time, from rest to "
            f"rest, and {angle:.6g} rad are needed"
        )
        raise _out_of_reach(told, time, float(np.sqrt(angle / (0.25 * power))) if power else None)


def _least_turn(start: InertialEnd, goal: InertialEnd) -> float:
    """The least angle between members of two sets of attitudes, or a lower bound on it."""
    a, b = start.attitude, goal.attitude
    if isinstance(a, FreeAttitude) or isinstance(b, FreeAttitude):
        return 0.0
    if isinstance(a, FixedAttitude):
        angle = float(b.error_rad(a.q))
    elif isinstance(b, FixedAttitude):
        angle = float(a.error_rad(b.q))
    else:
        return 0.0
    return max(0.0, angle - a.tolerance_rad - b.tolerance_rad)


def _out_of_reach(reason: str, time: float, least: float | None) -> InputError:
    expected = "" if least is None else f"a horizon of at least {least:.4g} s"
    return InputError("goal", f"is out of reach within {time:.6g} s: {reason}", expected)
