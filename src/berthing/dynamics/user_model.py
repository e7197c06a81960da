"""A model of the user's own, its functions called with casadi's expressions."""

from __future__ import annotations

import casadi as ca

from berthing.dynamics.casadi_xp import CASADI
from berthing.dynamics.kinematics import Kinematics
from berthing.dynamics.rotation import attitude_error, rotation_matrix
from berthing.scenario.user_model import ANGLE, NO_ATTITUDE, UserModel
from berthing.sym import Sym


def derivative(model: UserModel, t: Sym, x: Sym, u: Sym) -> Sym:
    """ẋ (nx,); InputError where the user's function fails."""
    return model.f(t, x, u, CASADI)


def kinematics(model: UserModel, x: Sym) -> Kinematics:
    """Pose and rates as the user's maps give them; InputError likewise."""
    position, attitude = model.placement(x, CASADI)
    velocity, rate = model.motion(x, CASADI) if model.tells_rates else (None, None)
    if model.attitude == NO_ATTITUDE:
        return Kinematics(position, ca.DM.eye(model.dim), velocity, None, None)
    if model.attitude == ANGLE:
        return Kinematics(
            position, planar_matrix(attitude), velocity, rate, lambda q: angle_error(q, attitude)
        )
    return Kinematics(
        position, rotation_matrix(attitude), velocity, rate,
        lambda q: attitude_error(q, attitude), attitude,
    )  # fmt: skip


def planar_matrix(angle: Sym) -> Sym:
    """R (2, 2) of a turn from x to y."""
    c, s = ca.cos(angle), ca.sin(angle)
    return ca.vertcat(ca.horzcat(c, -s), ca.horzcat(s, c))


def angle_error(q_target: Sym, angle: Sym) -> Sym:
    """sin of half the turn that is left to q_target = (cos θ/2, 0, 0, sin θ/2): one row."""
    return q_target[0] * ca.sin(0.5 * angle) - q_target[3] * ca.cos(0.5 * angle)
