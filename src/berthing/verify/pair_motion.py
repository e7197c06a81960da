"""The motion of one body seen from the frame of another.

In the frame of B, B's parts rest, so that bodies which move together cost nothing. A point of A at
d from B's origin, in inertial axes, is at z = Rᵀd there, R the rotation of B. With B's rate Ω, and
all in inertial axes, R z′ = ḋ − Ω×d and R z″ = d̈ − 2Ω×ḋ − Ω̇×d + Ω×(Ω×d). The norms of R and its
derivatives are at most 1, Ω, Ω̇ + Ω², Ω̈ + 3ΩΩ̇ + Ω³; with those of d they bound z‴ by Leibniz' rule.
"""

from __future__ import annotations

from collections.abc import Sequence
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

    With z the centre's position and Q the rotation of A relative to B:

    Attributes:
        pose: A's frame at the middle.
        velocity, acceleration: z′ and z″ at the middle (k, 3).
        jerk: bound on ‖z‴‖ over the interval (k,).
        turn_rate, turn_bend: bounds on ‖Q′‖ and ‖Q″‖ over the interval (k,).
    """

    pose: RelativePose
    velocity: Array
    acceleration: Array
    jerk: Array
    turn_rate: Array
    turn_bend: Array

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
        turns = _turn_ceilings(ceilings[0])
        jerk = ceilings[0].jerk + radius * turns[3]
        w, w_dot = a.rate, a.rate_dot
        if not self.b.rests:
            jerk = jerk + ceilings[1].jerk
        if self.b.turns:
            other = _turn_ceilings(ceilings[1])
            jerk = third(other, _ceilings_about(d, v, acceleration, jerk, half))
            turns = [*turns[:3], third(other, turns)]
            v, acceleration = _turning(d, v, acceleration, b)
            w, w_dot = w - b.rate, w_dot - b.rate_dot - cross(b.rate, w)
        rate = norm(w)
        # Q′ = w × Q and Q″ = w′ × Q + w × (w × Q) at the middle.
        turn_bend = norm(w_dot) + rate**2 + half * turns[3]
        return RelativeMotion(
            pose,
            _turn(to_b, v),
            _turn(to_b, acceleration),
            jerk,
            rate + half * turn_bend,
            turn_bend,
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


def _turn_ceilings(c: Ceilings) -> list[Array]:
    """Bounds on the norms of a rotation and its first three derivatives."""
    bend = c.rate_dot + c.rate**2
    return [np.ones_like(c.rate), c.rate, bend, c.rate_ddot + 3.0 * c.rate * c.rate_dot + c.rate**3]


def _ceilings_about(d: Array, v: Array, a: Array, jerk: Array, half: Array) -> list[Array]:
    """Bounds over an interval on d and its derivatives, from their values at its middle."""
    a_ceiling = norm(a) + half * jerk
    v_ceiling = norm(v) + half * a_ceiling
    return [norm(d) + half * v_ceiling, v_ceiling, a_ceiling, jerk]


def third(f: Sequence[Array], g: Sequence[Array]) -> Array:
    """Bound on the third derivative of a product, from those of its factors: Leibniz' rule."""
    return np.asarray(f[3] * g[0] + 3.0 * f[2] * g[1] + 3.0 * f[1] * g[2] + f[0] * g[3])


def _turning(d: Array, v: Array, acceleration: Array, b: Jet) -> tuple[Array, Array]:
    """L d and L²d."""
    swept = cross(b.rate, d)
    return v - swept, acceleration - cross(b.rate_dot, d) - cross(b.rate, 2.0 * v - swept)


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
