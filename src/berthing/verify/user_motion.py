"""The frame of a vehicle whose pose is a map of the user's own, enclosed over cells of time."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.user_model import ANGLE, QUATERNION, UserModel
from berthing.trajectory import Segment
from berthing.verify.body_motion import Ceilings, Index, Jet, Mask
from berthing.verify.chebyshev import padded, split
from berthing.verify.enclosed_state import Polynomials
from berthing.verify.interval import Interval
from berthing.verify.polynomial_motion import (
    CLOCK_ROUNDING,
    QUATERNION_FLOOR,
    UnboundedAttitudeError,
)
from berthing.verify.taylor import Taylor, constant
from berthing.verify.taylor_xp import TAYLOR
from berthing.verify.turning import rate_ceilings, rotation_jet

CELLS_PER_SEGMENT = 4
"""Intervals of a map are wider than its range by a share that falls with the cell's length."""

MAX_HALVINGS = 8
"""Of cells of which nothing is known yet; then nothing is proven there."""

MAP_ROUNDING = 10.0
"""A map takes some more operations than the evaluation of a polynomial."""

ORDER = 3


class UserMotion:
    """A frame of contiguous pieces; its cells are parts of them.

    Raises:
        InputError: the user's map fails.
        UnboundedAttitudeError: its quaternion comes near zero.
    """

    rests = False

    def __init__(self, model: UserModel, segments: Sequence[Segment]) -> None:
        self._model = model
        self.turns = model.turns
        t0, t1 = (np.array([getattr(s, end) for s in segments]) for end in ("t0_s", "t1_s"))
        count = np.full(len(segments), CELLS_PER_SEGMENT)
        cells = split(t0, t1, padded([s.state for s in segments]), count)
        for halving in range(MAX_HALVINGS + 1):
            states = Polynomials.of(*cells, ORDER)
            self.ceilings, floor = self._bounds(states)
            unknown = _unknown(self.ceilings) | ~(floor >= QUATERNION_FLOOR)
            if halving < MAX_HALVINGS and np.any(unknown):
                cells = split(*cells, np.where(unknown, 2, 1))
        if np.any(~(floor > 0.0)):
            raise UnboundedAttitudeError(float(states.t0_s[np.argmin(floor)]))
        self._states = states
        self.edges_s = np.append(states.t0_s, states.t1_s[-1])

    def jet(self, t: Array, cells: Index) -> Jet:
        position, attitude = self._placement(self._states.at(t, cells))
        r, v, a = (_lifted(order) for order in _values(position)[:3])
        still = np.zeros_like(r)
        if attitude is None:
            return Jet(r, v, a, np.broadcast_to(np.eye(3), (len(t), 3, 3)), still, still)
        turned = _values(attitude)
        if self._model.attitude == QUATERNION:
            return Jet(r, v, a, *rotation_jet(*turned[:3]))
        rate, rate_dot = still.copy(), still.copy()
        rate[:, 2], rate_dot[:, 2] = turned[1][:, 0], turned[2][:, 0]
        return Jet(r, v, a, _about_z(turned[0][:, 0]), rate, rate_dot)

    def _placement(self, states: Taylor) -> tuple[Taylor, Taylor | None]:
        with np.errstate(all="ignore"):
            position, attitude = self._model.placement(states, TAYLOR)
        count, order = states.terms[0].low.shape[-1], len(states.terms) - 1
        spread = [None if p is None else _spread(p, count, order) for p in (position, attitude)]
        assert spread[0] is not None
        return spread[0], spread[1]

    def _bounds(self, states: Polynomials) -> tuple[Ceilings, Array]:
        """Ceilings (n,), and lower bounds on the norm of the quaternion, 1 without one."""
        position, attitude = self._placement(states.over())
        r0, r1, r2, r3 = (_norms(order) for order in _sizes(position))
        last = float(np.max(np.abs(states.t1_s)))
        length = MAP_ROUNDING * (r0 + CLOCK_ROUNDING * last * r1)
        zero, floor = np.zeros_like(r0), np.ones_like(r0)
        if attitude is None:
            return Ceilings(r2, r3, zero, zero, zero, length), floor
        q1, q2, q3 = (_norms(order) for order in _sizes(attitude)[1:])
        if self._model.attitude == ANGLE:
            return Ceilings(r2, r3, q1, q2, q3, length), floor
        floor = _floor(attitude)
        with np.errstate(all="ignore"):
            rate, *further = rate_ceilings(*(_known(q / floor) for q in (q1, q2, q3)))
        rate_dot, rate_ddot = map(_known, further)
        return Ceilings(r2, r3, _known(rate), rate_dot, rate_ddot, length), floor


def _floor(q: Taylor) -> Array:
    """Lower bounds (n,) on |q|, from the distance of each component from zero."""
    least = np.maximum(np.maximum(q.terms[0].low, -q.terms[0].high), 0.0)
    return _norms(least)


def _spread(value: Taylor | Array, count: int, order: int) -> Taylor:
    """Over all cells, also what does not depend on the state."""
    terms = constant(value, order).terms
    shape = (len(terms[0].low), count)
    ends = [(np.broadcast_to(t.low, shape), np.broadcast_to(t.high, shape)) for t in terms]
    return Taylor(tuple(Interval(*pair) for pair in ends))


def _sizes(series: Taylor) -> list[Array]:
    """Bounds on the derivatives' entries (c, n), by order."""
    factorial = np.cumprod([1.0, *range(1, len(series.terms))])
    return [f * term.size for f, term in zip(factorial, series.terms, strict=True)]


def _values(series: Taylor) -> list[Array]:
    """Derivatives (n, c) at instants, by order."""
    factorial = np.cumprod([1.0, *range(1, len(series.terms))])
    return [f * term.middle.T for f, term in zip(factorial, series.terms, strict=True)]


def _norms(sizes: Array) -> Array:
    """Norms (n,) of columns (c, n)."""
    return np.asarray(np.sqrt(np.sum(sizes**2, axis=0)))


def _known(bound: Array) -> Array:
    return np.where(np.isnan(bound), np.inf, bound)


def _unknown(c: Ceilings) -> Mask:
    total = c.acceleration + c.jerk + c.rate + c.rate_dot + c.rate_ddot + c.length
    return ~np.isfinite(total)


def _lifted(vectors: Array) -> Array:
    out = np.zeros((len(vectors), 3))
    out[:, : vectors.shape[1]] = vectors
    return out


def _about_z(angle: Array) -> Array:
    out = np.zeros((len(angle), 3, 3))
    c, s = np.cos(angle), np.sin(angle)
    out[:, 0, 0] = out[:, 1, 1] = c
    out[:, 1, 0], out[:, 0, 1] = s, -s
    out[:, 2, 2] = 1.0
    return out
