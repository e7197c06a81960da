"""A rigid body in the plane, pushed and turned by forces in its own axes."""

from __future__ import annotations

import math
from typing import Any

from berthing.errors import InputError
from berthing.scenario.user_model import ANGLE, UserModel
from berthing.xp import Namespace, Scalar, Vector

STATES = ("x_m", "y_m", "vx_m_s", "vy_m_s", "angle_rad", "wz_rad_s")
CONTROLS = ("fx_n", "fy_n", "gz_nm")


def free_flyer(mass_kg: float, inertia_kg_m2: float) -> UserModel:
    """m r̈ = R(θ) f and J θ̈ = g, the reference point its centre of mass.

    Raises:
        InputError: a mass or moment of inertia that is not positive.

    >>> free_flyer(1.0, 2.0).state_names
    ('x_m', 'y_m', 'vx_m_s', 'vy_m_s', 'angle_rad', 'wz_rad_s')
    """
    data = {"mass_kg": mass_kg, "inertia_kg_m2": inertia_kg_m2}
    for name, value in data.items():
        if not (math.isfinite(value) and value > 0.0):
            raise InputError(name, f"is {value}", "a positive number")
    return UserModel(
        "free-flyer", 2, STATES, CONTROLS, _derivative, _place, ANGLE, _rates, None, data
    )


def _derivative(t: Scalar, x: Vector, u: Vector, p: Any, xp: Namespace) -> Vector:
    push = xp.rotate_plane(x[4], u[0:2])
    return xp.vector(x[2:4], push / p["mass_kg"], x[5], u[2] / p["inertia_kg_m2"])


def _place(x: Vector, p: Any, xp: Namespace) -> tuple[Vector, Scalar]:
    return x[0:2], x[4]


def _rates(x: Vector, p: Any, xp: Namespace) -> tuple[Vector, Scalar]:
    return x[2:4], x[5]
