"""Rotation and its derivatives from a quaternion and its own."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array


def rotation_jet(q: Array, dq: Array, ddq: Array) -> tuple[Array, Array, Array]:
    """R, ω and its derivative, inertial axes, of the normalised quaternion.

    ω |q|² = 2 vec(q̇ ⊗ q*) =: N, whatever |q|, for the radial part of q̇ adds to the scalar only.
    Since q̇ ⊗ q̇* is a scalar, N' = 2 vec(q̈ ⊗ q*); and N' = ω' |q|² + 2 ω q·q̇.
    """
    square = np.einsum("ki,ki->k", q, q)[:, None]
    rate = 2.0 * _vector_of_product(dq, q) / square
    stretch = 2.0 * np.einsum("ki,ki->k", q, dq)[:, None] / square
    rate_dot = 2.0 * _vector_of_product(ddq, q) / square - rate * stretch
    return _rotation(q / np.sqrt(square)), rate, rate_dot


def _vector_of_product(p: Array, q: Array) -> Array:
    """vec(p ⊗ q*) = q₀ p⃗ − p₀ q⃗ − p⃗ × q⃗."""
    p0, p1, p2, p3 = p.T
    q0, q1, q2, q3 = q.T
    out = np.empty((len(p), 3))
    out[:, 0] = q0 * p1 - p0 * q1 - p2 * q3 + p3 * q2
    out[:, 1] = q0 * p2 - p0 * q2 - p3 * q1 + p1 * q3
    out[:, 2] = q0 * p3 - p0 * q3 - p1 * q2 + p2 * q1
    return out


def _rotation(q: Array) -> Array:
    """R(q) of unit quaternions (k, 4)."""
    w, x, y, z = q.T
    out = np.empty((len(q), 3, 3))
    out[:, 0, 0] = 1.0 - 2.0 * (y * y + z * z)
    out[:, 1, 1] = 1.0 - 2.0 * (x * x + z * z)
    out[:, 2, 2] = 1.0 - 2.0 * (x * x + y * y)
    xy, xz, yz, wx, wy, wz = x * y, x * z, y * z, w * x, w * y, w * z
    out[:, 0, 1], out[:, 1, 0] = 2.0 * (xy - wz), 2.0 * (xy + wz)
    out[:, 0, 2], out[:, 2, 0] = 2.0 * (xz + wy), 2.0 * (xz - wy)
    out[:, 1, 2], out[:, 2, 1] = 2.0 * (yz - wx), 2.0 * (yz + wx)
    return out


def rate_ceilings(q1: Array, q2: Array, q3: Array) -> tuple[Array, Array, Array]:
    """Bounds on ω, ω' and ω'' from those on |q̇|, |q̈|, |q⃛| over |q|.

    From ω|q|² = N and its derivatives, with |N| ≤ 2|q̇||q|, |N'| ≤ 2|q̈||q|,
    |N''| ≤ 2(|q⃛||q| + |q̈||q̇|), |(|q|²)'| ≤ 2|q||q̇|, |(|q|²)''| ≤ 2(|q̇|² + |q||q̈|),
    everything divided by |q|².
    """
    rate = 2.0 * q1
    rate_dot = 2.0 * q2 + 2.0 * q1 * rate
    rate_ddot = 2.0 * (q3 + q2 * q1) + 4.0 * q1 * rate_dot + 2.0 * (q1 * q1 + q2) * rate
    return rate, rate_dot, rate_ddot
