"""Models of the user's own: twins of what the package has, and a rover."""

from __future__ import annotations

from typing import Any

import numpy as np

from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.user_model import UserModel

ROVER_CODE = """
from berthing import UserModel


def derivative(t, x, u, p, xp):
    along = x[3] * xp.cos(x[2]), x[3] * xp.sin(x[2])
    return xp.vector(*along, x[3] * xp.tan(x[4]) / p["wheelbase_m"], u)


def place(x, p, xp):
    return x[0:2], x[2]


def rates(x, p, xp):
    along = xp.vector(x[3] * xp.cos(x[2]), x[3] * xp.sin(x[2]))
    return along, x[3] * xp.tan(x[4]) / p["wheelbase_m"]


rover = UserModel(
    "rover", 2, ("x_m", "y_m", "angle_rad", "speed_m_s", "steering_rad"),
    ("throttle_m_s2", "steer_rad_s"), derivative, place, "angle", rates,
    parameters={"wheelbase_m": 1.0},
)


def sideways(t, x, u, p, xp):
    pull = x[3] ** 2 * xp.tan(x[4])
    return xp.vector(pull - p["most_m_s2"], -pull - p["most_m_s2"])


def steering(t, x, u, p, xp):
    return p["weight"] * x[4] ** 2


number = 3
"""


def rover() -> UserModel:
    """A car in the plane: (x, y, heading, speed, steering angle)."""
    names: dict[str, Any] = {}
    exec(ROVER_CODE, names)
    model: UserModel = names["rover"]
    return model


def twin(model: RigidBody) -> UserModel:
    """A rigid body without first moment and wrenches, written by a user."""

    def derivative(t, x, u, p, xp):
        q, w = x[6:10], x[10:13]
        torque = u[3:6] - xp.cross(w, xp.matvec(p["inertia"], w))
        return xp.vector(
            x[3:6],
            xp.rotate(q, u[0:3]) / p["mass"],
            xp.quaternion_rate(q, w),
            xp.matvec(p["inverse"], torque),
        )

    return UserModel(
        "twin",
        3,
        model.state_names,
        model.control_names,
        derivative,
        lambda x, p, xp: (x[0:3], x[6:10]),
        "quaternion",
        lambda x, p, xp: (x[3:6], x[10:13]),
        parameters={
            "mass": model.mass_kg,
            "inertia": model.inertia_kg_m2,
            "inverse": np.linalg.inv(model.inertia_kg_m2),
        },
    )


def sliding(mass_kg: float = 3.0, **changes: Any) -> UserModel:
    """A point mass in space, written by a user."""
    fields: dict[str, Any] = {
        "name": "sliding",
        "workspace_dim": 3,
        "states": ("x_m", "y_m", "z_m", "vx_m_s", "vy_m_s", "vz_m_s"),
        "controls": ("fx_n", "fy_n", "fz_n"),
        "derivative": lambda t, x, u, p, xp: xp.vector(x[3:6], u / p["mass"]),
        "place": lambda x, p, xp: x[0:3],
        "rates": lambda x, p, xp: x[3:6],
        "parameters": {"mass": mass_kg},
    }
    return UserModel(**(fields | changes))
