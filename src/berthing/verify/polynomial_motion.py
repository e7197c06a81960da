"""Frames whose position and quaternion are polynomials of time, piece by piece."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.body_motion import Ceilings, Index, Jet, Mask
from berthing.verify.chebyshev import basis, derivative, norm_ceiling, norm_floor, padded, split
from berthing.verify.turning import rate_ceilings, rotation_jet

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
        return Jet(r, v, a, *rotation_jet(q, dq, ddq))


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
        t0, t1, coefficients = split(t0, t1, coefficients, np.full(len(t0), count))
    for _ in range(MAX_HALVINGS):
        low = _is_low(coefficients)
        if not np.any(low):
            return t0, t1, coefficients
        t0, t1, coefficients = split(t0, t1, coefficients, np.where(low, 2, 1))
    low = _is_low(coefficients)
    if np.any(low):
        raise UnboundedAttitudeError(float(t0[np.argmax(low)]))
    return t0, t1, coefficients


def _is_low(coefficients: Array) -> Mask:
    if coefficients.shape[2] == 3:
        return np.zeros(len(coefficients), dtype=np.bool_)
    return ~(norm_floor(coefficients[:, :, 3:]) >= QUATERNION_FLOOR)


def _ceilings(orders: Sequence[Array], t1: Array) -> Ceilings:
    r0, r1, r2, r3 = (norm_ceiling(c[:, :, :3]) for c in orders)
    length = r0 + CLOCK_ROUNDING * np.max(np.abs(t1)) * r1
    if orders[0].shape[2] == 3:
        zero = np.zeros_like(r0)
        return Ceilings(r2, r3, zero, zero, zero, length)
    floor = norm_floor(orders[0][:, :, 3:])
    q1, q2, q3 = (norm_ceiling(c[:, :, 3:]) / floor for c in orders[1:])
    return Ceilings(r2, r3, *rate_ceilings(q1, q2, q3), length)
