"""Attitude quaternions: Hamilton product, scalar first, v_I = R(q_IB) v_B.

Every function takes arrays (..., 4) and broadcasts; none keeps state. The components equal
(η, ε) of the paper, whose C_sI is R(q_IB)ᵀ.
"""

from __future__ import annotations

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import last_axis, norm


def normalise(q: Array) -> Array:
    """q / |q| (..., 4); InputError where q is zero or not finite."""
    q = last_axis(q, 4, "quaternion")
    length = norm(q)
    if not np.all(np.isfinite(length) & (length > 0.0)):
        raise InputError("quaternion", "is zero or not finite", "four finite numbers, not all 0")
    return np.asarray(q / length[..., None])


def conjugate(q: Array) -> Array:
    """The inverse rotation of a unit quaternion."""
    return np.asarray(last_axis(q, 4, "quaternion") * np.array([1.0, -1.0, -1.0, -1.0]))


def multiply(p: Array, q: Array) -> Array:
    """Hamilton product p ⊗ q, so that R(p ⊗ q) = R(p) R(q)."""
    p, q = last_axis(p, 4, "quaternion p"), last_axis(q, 4, "quaternion q")
    a, b, c, d = p[..., 0], p[..., 1], p[..., 2], p[..., 3]
    w, x, y, z = q[..., 0], q[..., 1], q[..., 2], q[..., 3]
    # Component by component: several times faster than a cross product for one, as in
    # searches, and what cancels does so exactly.
    out = np.empty((*np.broadcast_shapes(p.shape[:-1], q.shape[:-1]), 4))
    out[..., 0] = a * w - (b * x + c * y + d * z)
    out[..., 1] = (a * x + w * b) + (c * z - d * y)
    out[..., 2] = (a * y + w * c) + (d * x - b * z)
    out[..., 3] = (a * z + w * d) + (b * y - c * x)
    return out


def rotation_matrix(q: Array) -> Array:
    """R(q) (..., 3, 3), q normalised first; v_I = R(q_IB) v_B. InputError where q is zero."""
    w, x, y, z = np.moveaxis(normalise(q), -1, 0)
    rows = (
        (1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)),
        (2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)),
        (2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)),
    )
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def from_axis_angle(axis: Array, angle: Array | float) -> Array:
    """The rotation by ``angle`` (...) in rad about ``axis`` (..., 3), of any length but zero."""
    axis = last_axis(axis, 3, "rotation axis")
    length = norm(axis)
    if not np.all(np.isfinite(length) & (length > 0.0)):
        raise InputError("rotation axis", "is zero or not finite", "a direction")
    half = 0.5 * np.asarray(angle, dtype=np.float64)
    vector = np.sin(half)[..., None] * (axis / length[..., None])
    scalar = np.broadcast_to(np.cos(half)[..., None], (*vector.shape[:-1], 1))
    return np.concatenate([scalar, vector], axis=-1)


def from_matrix(R: Array) -> Array:
    """The unit quaternion (..., 4) with scalar ≥ 0 of rotation matrices (..., 3, 3).

    4 q qᵀ is linear in R; its column with the largest diagonal entry is well conditioned
    (S. W. Shepperd, J. Guidance and Control 1(3), 1978, doi:10.2514/3.55767b).
    """
    R = np.asarray(R, dtype=np.float64)
    if R.shape[-2:] != (3, 3):
        raise InputError("rotation matrix", f"has the shape {R.shape}", "last axes of 3×3")
    r = np.moveaxis(R, (-2, -1), (0, 1))
    a, b, c = r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]
    d, e, f = r[0, 1] + r[1, 0], r[0, 2] + r[2, 0], r[1, 2] + r[2, 1]
    x, y, z = r[0, 0], r[1, 1], r[2, 2]
    outer = np.stack(
        [
            np.stack([1.0 + x + y + z, a, b, c], axis=-1),
            np.stack([a, 1.0 + x - y - z, d, e], axis=-1),
            np.stack([b, d, 1.0 - x + y - z, f], axis=-1),
            np.stack([c, e, f, 1.0 - x - y + z], axis=-1),
        ],
        axis=-2,
    )
    best = np.argmax(np.diagonal(outer, axis1=-2, axis2=-1), axis=-1)
    column = np.take_along_axis(outer, best[..., None, None], axis=-2)[..., 0, :]
    return normalise(np.where(column[..., :1] < 0.0, -column, column))


def rotation_vector(q: Array) -> Array:
    """Axis times angle (..., 3) of the shorter rotation of ±q, in rad; its length is ≤ π."""
    q = normalise(q)
    q = np.where(q[..., :1] < 0.0, -q, q)
    sine = norm(q[..., 1:])
    angle = 2.0 * np.arctan2(sine, q[..., 0])
    # angle / sine tends to 2 as sine tends to 0, and is accurate for any other sine.
    ratio = np.divide(angle, sine, out=np.full_like(sine, 2.0), where=sine > 0.0)
    return np.asarray(ratio[..., None] * q[..., 1:])


def from_rotation_vector(v: Array) -> Array:
    """The inverse of ``rotation_vector``: the rotation by |v| rad about v (..., 3)."""
    v = last_axis(v, 3, "rotation vector")
    half = 0.5 * norm(v)
    # np.sinc(x) = sin(πx)/(πx), so this is sin(half)/|v|, finite at 0.
    scale = 0.5 * np.sinc(half / np.pi)
    return np.concatenate([np.cos(half)[..., None], scale[..., None] * v], axis=-1)


def slerp(q0: Array, q1: Array, s: Array | float) -> Array:
    """Constant-rate rotation along the shorter arc from q0 (s = 0) to ±q1 (s = 1); s (...)."""
    start = normalise(q0)
    step = rotation_vector(multiply(conjugate(start), normalise(q1)))
    part = np.asarray(s, dtype=np.float64)[..., None] * step
    return multiply(start, from_rotation_vector(part))


def angle_between(q0: Array, q1: Array) -> Array:
    """The angle (...) in rad, 0 to π, of the rotation from q0 to q1; q and −q are one attitude."""
    relative = multiply(conjugate(normalise(q0)), normalise(q1))
    return np.asarray(2.0 * np.arctan2(norm(relative[..., 1:]), np.abs(relative[..., 0])))
