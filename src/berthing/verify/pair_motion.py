"""The motion of one body seen from the frame of another.

In the frame of B, B's parts rest, so that bodies which move together cost nothing. Derivatives
are taken in that frame: with L = d/dt − ω_B×, the position d of a point of A from B's origin has
L d = ḋ − Ω×d, L²d = d̈ − 2Ω×ḋ − Ω̇×d + Ω×(Ω×d), and
‖L³d‖ ≤ J + 3ΩA + 3(Ω̇ + Ω²)V + (Ω̈ + 3ΩΩ̇ + Ω³)D with V, A, J the derivatives of d.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.body_motion import BodyMotion, Ceilings, Index, Jet, Mask


@dataclass(frozen=True)
class RelativePose:
    """A's frame in B's at times (k,): position (k, 3), rotation A → B (k, 3, 3)."""

    position: Array
    rotation: Array

    def take(self, which: Mask | Index) -> RelativePose:
        """Those where ``which`` (k,) holds, or those of these numbers."""
        return RelativePose(self.position[which], self.rotation[which])


@dataclass(frozen=True)
class RelativeMotion:
    """The centre of a part of A over intervals (k,) about their middles, axes of B.

    With p the centre's position and w the rate of A relative to B, and h half the interval:

    Attributes:
        pose: A's frame at the middle.
        velocity, acceleration: p′ and p″ at the middle (k, 3).
        jerk: bound on ‖p‴‖ over the interval (k,).
        rate, rate_dot: w and w′ at the middle (k, 3).
        rate_ceiling, rate_dot_ceiling: bounds on ‖w‖ and ‖w′‖ over the interval (k,).
    """

    pose: RelativePose
    velocity: Array
    acceleration: Array
    jerk: Array
    rate: Array
    rate_ceiling: Array
    rate_dot_ceiling: Array

    def take(self, which: Mask) -> RelativeMotion:
        """The intervals where ``which`` (k,) holds."""
        rest = (getattr(self, f.name)[which] for f in fields(self)[1:])
        return RelativeMotion(self.pose.take(which), *rest)


class BodyPair:
    """Two bodies in motion, and times cut where either stops being smooth."""

    def __init__(self, a: BodyMotion, b: BodyMotion) -> None:
        self.a, self.b = a, b
        start, end = max(a.edges_s[0], b.edges_s[0]), min(a.edges_s[-1], b.edges_s[-1])
        inner = np.concatenate([a.edges_s, b.edges_s])
        self.edges_s = np.unique(np.append(inner[(inner > start) & (inner < end)], [start, end]))
        self._ceilings = a.ceilings, b.ceilings

    def cells(self, middle: Array) -> tuple[Index, Index]:
        """The cells of both bodies that hold the intervals with these middles (k,)."""
        return _cells(self.a, middle), _cells(self.b, middle)

    def length(self, offset: Array) -> Array:
        """Lengths (k,) whose rounding enters the position of points (k, 3) of A."""
        total = sum(float(np.max(c.length)) for c in self._ceilings)
        return np.asarray(total + norm(offset))

    def pose(self, t: Array, cells: tuple[Index, Index]) -> RelativePose:
        """A's frame in B's at the times t (k,), each in its cells."""
        a, b = self.a.jet(t, cells[0]), self.b.jet(t, cells[1])
        to_b = np.swapaxes(b.rotation, 1, 2)
        return RelativePose(_turn(to_b, a.position - b.position), to_b @ a.rotation)

    def motion(
        self, middle: Array, half: Array, cells: tuple[Index, Index], offset: Array
    ) -> RelativeMotion:
        """Over the intervals middle ± half (k,), of the points ``offset`` (k, 3) of A's frame."""
        a, b = self.a.jet(middle, cells[0]), self.b.jet(middle, cells[1])
        ceilings = self._ceilings[0].at(cells[0]), self._ceilings[1].at(cells[1])
        to_b = np.swapaxes(b.rotation, 1, 2)
        pose = RelativePose(_turn(to_b, a.position - b.position), to_b @ a.rotation)
        d, v, acceleration = _difference(a, b, offset, self.a.turns)
        radius = norm(offset)
        A, J = _point_ceilings(ceilings[0], radius)
        w, w_dot, w_ddot = a.rate, a.rate_dot, ceilings[0].rate_ddot
        if not self.b.rests:
            A, J = A + ceilings[1].acceleration, J + ceilings[1].jerk
        if self.b.turns:
            D, V = norm(d) + half * (norm(v) + half * A), norm(v) + half * A
            J = _turning_jerk(J, A, V, D, ceilings[1])
            v, acceleration = _turning(d, v, acceleration, b)
            w, w_dot = w - b.rate, w_dot - b.rate_dot - cross(b.rate, w)
            w_ddot = _turning_rate_ddot(ceilings[0], ceilings[1])
        w_dot_ceiling = norm(w_dot) + w_ddot * half
        return RelativeMotion(
            pose,
            _turn(to_b, v),
            _turn(to_b, acceleration),
            J,
            _turn(to_b, w),
            norm(w) + w_dot_ceiling * half,
            w_dot_ceiling,
        )


def _cells(body: BodyMotion, middle: Array) -> Index:
    if len(body.edges_s) == 2:
        return np.zeros(len(middle), dtype=np.intp)
    index = np.searchsorted(body.edges_s, middle, side="right") - 1
    return np.clip(index, 0, len(body.edges_s) - 2)


def _difference(a: Jet, b: Jet, offset: Array, turns: bool) -> tuple[Array, Array, Array]:
    """Position, velocity and acceleration from B's origin of points fixed in A, inertial axes."""
    arm = _turn(a.rotation, offset)
    d = a.position - b.position + arm
    v = a.velocity - b.velocity
    acceleration = a.acceleration - b.acceleration
    if turns:
        swept = cross(a.rate, arm)
        v = v + swept
        acceleration = acceleration + cross(a.rate_dot, arm) + cross(a.rate, swept)
    return d, v, acceleration


def _point_ceilings(c: Ceilings, radius: Array) -> tuple[Array, Array]:
    """Bounds on acceleration and jerk of points at ``radius`` from the frame's origin."""
    acceleration = c.acceleration + radius * (c.rate_dot + c.rate**2)
    jerk = c.jerk + radius * (c.rate_ddot + 3.0 * c.rate * c.rate_dot + c.rate**3)
    return acceleration, jerk


def _turning(d: Array, v: Array, acceleration: Array, b: Jet) -> tuple[Array, Array]:
    """L d and L²d."""
    swept = cross(b.rate, d)
    return v - swept, acceleration - cross(b.rate_dot, d) - cross(b.rate, 2.0 * v - swept)


def _turning_jerk(J: Array, A: Array, V: Array, D: Array, b: Ceilings) -> Array:
    o, o1, o2 = b.rate, b.rate_dot, b.rate_ddot
    return J + 3.0 * o * A + 3.0 * (o1 + o * o) * V + (o2 + 3.0 * o * o1 + o**3) * D


def _turning_rate_ddot(a: Ceilings, b: Ceilings) -> Array:
    """‖L²w‖ ≤ ‖ẅ‖ + 2Ω‖ẇ‖ + (Ω̇ + Ω²)‖w‖ for w = ω_A − Ω."""
    w, w1, w2 = a.rate + b.rate, a.rate_dot + b.rate_dot, a.rate_ddot + b.rate_ddot
    return w2 + 2.0 * b.rate * w1 + (b.rate_dot + b.rate**2) * w


def norm(v: Array) -> Array:
    """‖v‖ (k,) of v (k, 3)."""
    return np.asarray(np.sqrt(np.einsum("ki,ki->k", v, v)))


def _turn(rotation: Array, v: Array) -> Array:
    return np.asarray((rotation @ v[:, :, None])[:, :, 0])


def cross(a: Array, b: Array) -> Array:
    """a × b (k, 3), several times faster than np.cross."""
    a0, a1, a2 = a.T
    b0, b1, b2 = b.T
    out = np.empty((len(a), 3))
    out[:, 0] = a1 * b2 - a2 * b1
    out[:, 1] = a2 * b0 - a0 * b2
    out[:, 2] = a0 * b1 - a1 * b0
    return out
