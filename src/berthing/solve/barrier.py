"""Rows with bounds as slacks behind logarithmic barriers.

Every row is g(x) - s = 0. Where both bounds are one number s is that number; elsewhere s is free
between its bounds, of which each is one line below: with σ = +1 for a lower and -1 for an upper
one, its distance d = σ (s - bound) > 0 and its multiplier z > 0.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array

PUSH = 1e-2
"""How far slacks begin inside their bounds, at most and as a share of the room there is."""


@dataclass(frozen=True)
class Bounds:
    """The bounds of m rows.

    Attributes:
        equal: (m,) whether the row is an equality.
        value: (m,) its value where it is one.
        row, sign, bound: (k,) of each one-sided bound.
        room: (k,) distance to the other bound of the row, infinite where there is none.
    """

    equal: npt.NDArray[np.bool_]
    value: Array
    row: npt.NDArray[np.int64]
    sign: Array
    bound: Array
    room: Array

    @staticmethod
    def of(lower: Array, upper: Array) -> Bounds:
        equal = lower == upper
        low = np.flatnonzero(~equal & np.isfinite(lower))
        high = np.flatnonzero(~equal & np.isfinite(upper))
        row = np.concatenate([low, high])
        sign = np.concatenate([np.ones(len(low)), -np.ones(len(high))])
        bound = np.concatenate([lower[low], upper[high]])
        return Bounds(equal, np.where(equal, lower, 0.0), row, sign, bound, (upper - lower)[row])

    def inside(self, g: Array, push: float = PUSH) -> Array:
        """Slacks (m,) next to g (m,) and inside their bounds."""
        s = np.where(self.equal, self.value, g)
        gap = np.minimum(push * np.maximum(np.abs(self.bound), 1.0), push * self.room)
        short = np.maximum(gap - self.distance(s), 0.0)
        return np.asarray(s + self.gather(self.sign * short))

    def distance(self, s: Array) -> Array:
        """d (k,)."""
        return np.asarray(self.sign * (s[self.row] - self.bound))

    def gather(self, values: Array) -> Array:
        """The sum over each row's bounds (m,) of values (k,)."""
        sums = np.bincount(self.row, values, minlength=len(self.equal))
        return np.asarray(sums, np.float64)

    def multiplier(self, y: Array) -> Array:
        """z (k,) that belongs to row multipliers y (m,) of f + yᵀ g; may be negative."""
        return np.asarray(-self.sign * y[self.row])


def longest(values: Array, steps: Array, keep: float) -> float:
    """The longest step in (0, 1] that leaves positive values (k,) at least 1 - ``keep`` of
    themselves."""
    shrinking = steps < 0.0
    if not np.any(shrinking):
        return 1.0
    return float(min(1.0, keep * np.min(values[shrinking] / -steps[shrinking])))
