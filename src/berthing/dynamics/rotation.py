"""Attitude in casadi expressions: Hamilton quaternions, scalar first, body → inertial."""

from __future__ import annotations

import casadi as ca

from berthing.sym import Sym


def rotation_matrix(q: Sym) -> Sym:
    """R(q) with v_I = R(q) v_B; homogeneous of degree zero in q, so that no norm row is needed."""
    w, x, y, z = q[0], q[1], q[2], q[3]
    rows = [
        ca.horzcat(w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        ca.horzcat(2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        ca.horzcat(2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    ]
    return ca.vertcat(*rows) / ca.sumsqr(q)


def quaternion_rate(q: Sym, w_body: Sym) -> Sym:
    """q̇ = ½ q ⊗ (0, ω), that is η̇ = -½ εᵀω and ε̇ = ½(ηI + ε^×)ω (the paper prints minus)."""
    scalar = -0.5 * ca.dot(q[1:4], w_body)
    vector = 0.5 * (q[0] * w_body + ca.cross(q[1:4], w_body))
    return ca.vertcat(scalar, vector)


def attitude_error(q_target: Sym, q: Sym) -> Sym:
    """Vector part of q_target* ⊗ q, three components.

    It vanishes at q = ±q_target, which are one attitude; its length is sin(angle / 2) for unit
    quaternions. Fixing four components instead makes the terminal rows dependent, because the
    kinematics conserve the norm already.
    """
    return q_target[0] * q[1:4] - q[0] * q_target[1:4] - ca.cross(q_target[1:4], q[1:4])


def quaternion_product(p: Sym, q: Sym) -> Sym:
    """Hamilton product p ⊗ q."""
    scalar = p[0] * q[0] - ca.dot(p[1:4], q[1:4])
    return ca.vertcat(scalar, p[0] * q[1:4] + q[0] * p[1:4] + ca.cross(p[1:4], q[1:4]))
