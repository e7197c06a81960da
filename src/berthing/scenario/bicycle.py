"""A car in the plane: the kinematic bicycle, the rear axle its reference point."""

from __future__ import annotations

import math
from typing import Any

from berthing.errors import InputError
from berthing.scenario.user_model import ANGLE, UserModel
from berthing.xp import Namespace, Scalar, Vector

STATES = ("x_m", "y_m", "angle_rad", "speed_m_s", "steering_rad")
CONTROLS = ("acceleration_m_s2", "steering_rate_rad_s")


def bicycle(wheelbase_m: float) -> UserModel:
    """No wheel slips: ψ̇ = (v/L) tan δ, the rear axle moving along the body's x axis.

    States: rear axle x, y; heading ψ; speed v, negative backwards; steering δ of the front wheel.
    Controls: v̇ and δ̇. Source: R. Rajamani, Vehicle Dynamics and Control, section 2.2, with the
    reference at the rear axle (10.1007/978-1-4614-1433-9).

    Raises:
        InputError: a wheelbase that is not positive.

    >>> bicycle(2.7).control_names
    ('acceleration_m_s2', 'steering_rate_rad_s')
    """
    if not (math.isfinite(wheelbase_m) and wheelbase_m > 0.0):
        raise InputError("wheelbase_m", f"is {wheelbase_m}", "a positive number")
    return UserModel(
        "bicycle", 2, STATES, CONTROLS, _derivative, _place, ANGLE, _rates, _assemble,
        {"wheelbase_m": wheelbase_m},
    )  # fmt: skip


def _derivative(t: Scalar, x: Vector, u: Vector, p: Any, xp: Namespace) -> Vector:
    velocity, turning = _rates(x, p, xp)
    return xp.vector(velocity, turning, u[0], u[1])


def _place(x: Vector, p: Any, xp: Namespace) -> tuple[Vector, Scalar]:
    return x[0:2], x[2]


def _rates(x: Vector, p: Any, xp: Namespace) -> tuple[Vector, Scalar]:
    velocity = xp.vector(x[3] * xp.cos(x[2]), x[3] * xp.sin(x[2]))
    return velocity, x[3] * xp.tan(x[4]) / p["wheelbase_m"]


def _assemble(r: Any, angle: float, v: Any, rate: float, p: Any) -> list[float]:
    # Along the heading, backwards where that is the way it points; wheels straight.
    along = float(v[0]) * math.cos(angle) + float(v[1]) * math.sin(angle)
    return [float(r[0]), float(r[1]), angle, along, 0.0]
