"""Frames whose position and quaternion are polynomials of time, piece by piece."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.body_motion import Ceilings, Index, Jet, Mask
from berthing.verify.chebyshev import basis, derivative, norm_ceiling, norm_floor, padded, restrict

# Ceilings are of whole cells; a piece of higher degree is cut into this many times fewer cells
# than its degree, so that its coefficients do not add up to far more than its range.
DEGREE_PER_CELL = 5

# The norm of the quaternion is bounded below on each cell, by no less than this: rates divide by
# it. A quarter turn within a cell leaves 0.6. Cells are halved until it holds.
QUATERNION_FLOOR = 0.5
MAX_HALVINGS = 6

# Share of speed · |t| that rounding of t can move a position by, in units of the float slack.
CLOCK_ROUNDING = 1e-2


class UnboundedAttitudeError(Exception):
    """The quaternion comes so near zero that its rotation is not bounded there."""

    def __init__(self, t_s: float) -> None:
        self.t_s = t_s
        super().__init__(f"the quaternion comes near zero about t = {t_s:.6g} s")


@dataclass(frozen=True)
class Piece:
    """Chebyshev coefficients on [t0, t1]: position (d, 3) in m; quaternion (d, 4), or None."""

    t0_s: float
    t1_s: float
    position: Array
    quaternion: Array | None


class PolynomialMotion:
    """A frame of contiguous pieces; its cells are the pieces, or parts of them.

    Raises:
        UnboundedAttitudeError: no bound on the rotation can be had.
    """

    rests = False

    def __init__(self, pieces: Sequence[Piece]) -> None:
        self.turns = pieces[0].quaternion is not None
        columns = [_columns(piece) for piece in pieces]
        t0, t1, coefficients = _cells(
            np.array([p.t0_s for p in pieces]), np.array([p.t1_s for p in pieces]), padded(columns)
        )
        self.edges_s = np.append(t0, t1[-1])
        self._middle, self._half = 0.5 * (t0 + t1), 0.5 * (t1 - t0)
        span = t1 - t0
        orders = [coefficients]
        for _ in range(3):
            orders.append(derivative(orders[-1], span))
        self._stack = np.concatenate(orders[:3], axis=2)
        self.ceilings = _ceilings(orders, t1)

    def jet(self, t: Array, cells: Index) -> Jet:
        s = (t - self._middle[cells]) / self._half[cells]
        coefficients = self._stack[cells]
        values = (basis(s, coefficients.shape[1])[:, None, :] @ coefficients)[:, 0]
        width = values.shape[1] // 3
        r, v, a = (values[:, i * width : i * width + 3] for i in range(3))
        if not self.turns:
            still = np.zeros_like(r)
            return Jet(r, v, a, np.broadcast_to(np.eye(3), (len(t), 3, 3)), still, still)
        q, dq, ddq = (values[:, i * width + 3 : (i + 1) * width] for i in range(3))
        return Jet(r, v, a, *_rotation_jet(q, dq, ddq))


def _columns(piece: Piece) -> Array:
    if piece.quaternion is None:
        return piece.position
    count = max(len(piece.position), len(piece.quaternion))
    out = np.zeros((count, 7))
    out[: len(piece.position), :3] = piece.position
    out[: len(piece.quaternion), 3:] = piece.quaternion
    return out


def _cells(t0: Array, t1: Array, coefficients: Array) -> tuple[Array, Array, Array]:
    count = -(-(coefficients.shape[1] - 1) // DEGREE_PER_CELL)
    if count > 1:
        t0, t1, coefficients = _split(t0, t1, coefficients, np.full(len(t0), count))
    for _ in range(MAX_HALVINGS):
        low = _is_low(coefficients)
        if not np.any(low):
            return t0, t1, coefficients
        t0, t1, coefficients = _split(t0, t1, coefficients, np.where(low, 2, 1))
    low = _is_low(coefficients)
    if np.any(low):
        raise UnboundedAttitudeError(float(t0[np.argmax(low)]))
    return t0, t1, coefficients


def _is_low(coefficients: Array) -> Mask:
    if coefficients.shape[2] == 3:
        return np.zeros(len(coefficients), dtype=np.bool_)
    return ~(norm_floor(coefficients[:, :, 3:]) >= QUATERNION_FLOOR)


def _split(t0: Array, t1: Array, coefficients: Array, parts: Index) -> tuple[Array, Array, Array]:
    """Each piece i cut into parts[i] equal cells."""
    index = np.repeat(np.arange(len(t0)), parts)
    step = np.arange(len(index)) - np.repeat(np.cumsum(parts) - parts, parts)
    low, high = step / parts[index], (step + 1) / parts[index]
    span = (t1 - t0)[index]
    start = t0[index] + low * span
    # A cell ends exactly where the next begins.
    end = np.append(start[1:], t1[-1])
    return start, end, restrict(coefficients[index], 2.0 * low - 1.0, 2.0 * high - 1.0)


def _rotation_jet(q: Array, dq: Array, ddq: Array) -> tuple[Array, Array, Array]:
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


def _ceilings(orders: Sequence[Array], t1: Array) -> Ceilings:
    r0, r1, r2, r3 = (norm_ceiling(c[:, :, :3]) for c in orders)
    length = r0 + CLOCK_ROUNDING * np.max(np.abs(t1)) * r1
    if orders[0].shape[2] == 3:
        zero = np.zeros_like(r0)
        return Ceilings(r2, r3, zero, zero, zero, length)
    floor = norm_floor(orders[0][:, :, 3:])
    q1, q2, q3 = (norm_ceiling(c[:, :, 3:]) / floor for c in orders[1:])
    # From ω|q|² = N and its derivatives, with |N| ≤ 2|q̇||q|, |N'| ≤ 2|q̈||q|,
    # |N''| ≤ 2(|q⃛||q| + |q̈||q̇|), |(|q|²)'| ≤ 2|q||q̇|, |(|q|²)''| ≤ 2(|q̇|² + |q||q̈|),
    # everything divided by |q|².
    rate = 2.0 * q1
    rate_dot = 2.0 * q2 + 2.0 * q1 * rate
    rate_ddot = 2.0 * (q3 + q2 * q1) + 4.0 * q1 * rate_dot + 2.0 * (q1 * q1 + q2) * rate
    return Ceilings(r2, r3, rate, rate_dot, rate_ddot, length)
