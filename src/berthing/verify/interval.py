"""Intervals of numbers, many at once.

Ends are computed in floating point without outward rounding: whoever uses the bounds enlarges
them by ``motion_inflation`` and ``float_slack``, as with every other bound here.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.body_motion import Mask


@dataclass(frozen=True)
class Interval:
    """low ≤ value ≤ high, elementwise; infinite where nothing is known."""

    low: Array
    high: Array

    @staticmethod
    def of(value: Any) -> Interval:
        """Exactly ``value``."""
        array = np.asarray(value, dtype=np.float64)
        return Interval(array, array)

    @staticmethod
    def whole(shape: tuple[int, ...]) -> Interval:
        """Any number at all."""
        return Interval(np.full(shape, -np.inf), np.full(shape, np.inf))

    def __getitem__(self, index: Any) -> Interval:
        return Interval(self.low[index], self.high[index])

    def __neg__(self) -> Interval:
        return Interval(-self.high, -self.low)

    def __add__(self, other: Interval) -> Interval:
        return Interval(self.low + other.low, self.high + other.high)

    def __sub__(self, other: Interval) -> Interval:
        return Interval(self.low - other.high, self.high - other.low)

    def __mul__(self, other: Interval) -> Interval:
        with np.errstate(invalid="ignore"):
            corners = [a * b for a in (self.low, self.high) for b in (other.low, other.high)]
        # Zero times anything is zero, also times the unknown.
        products = np.stack([np.where(np.isnan(c), 0.0, c) for c in np.broadcast_arrays(*corners)])
        return Interval(products.min(axis=0), products.max(axis=0))

    def __truediv__(self, other: Interval) -> Interval:
        zero = (other.low <= 0.0) & (other.high >= 0.0)
        with np.errstate(all="ignore"):
            inverse = Interval(1.0 / other.high, 1.0 / other.low)
        everything = Interval.whole(zero.shape)
        return chosen(zero, everything, self * inverse)

    def scaled(self, factor: float) -> Interval:
        """Times a number."""
        return self * Interval.of(factor)

    def square(self) -> Interval:
        """The values squared, none of which is negative."""
        a, b = self.low**2, self.high**2
        crosses = (self.low <= 0.0) & (self.high >= 0.0)
        return Interval(np.where(crosses, 0.0, np.minimum(a, b)), np.maximum(a, b))

    @property
    def size(self) -> Array:
        """Upper bound on the magnitude; infinite where an end is not a number."""
        largest = np.maximum(np.abs(self.low), np.abs(self.high))
        return np.where(np.isnan(largest), np.inf, largest)

    @property
    def middle(self) -> Array:
        """Of both ends."""
        return 0.5 * (self.low + self.high)


def chosen(condition: Mask, a: Interval, b: Interval) -> Interval:
    """``a`` where the condition holds, ``b`` elsewhere."""
    return Interval(np.where(condition, a.low, b.low), np.where(condition, a.high, b.high))


def hull(a: Interval, b: Interval) -> Interval:
    """The least interval that holds both."""
    return Interval(np.minimum(a.low, b.low), np.maximum(a.high, b.high))


def monotone(function: Any, a: Interval) -> Interval:
    """Values of a function that never falls."""
    with np.errstate(all="ignore"):
        return Interval(function(a.low), function(a.high))


def cosine(a: Interval) -> Interval:
    """Values of the cosine; also of unknown angles."""
    with np.errstate(all="ignore"):
        ends = np.cos(a.low), np.cos(a.high)
        # A multiple of 2π inside makes 1, an odd one of π makes −1.
        top = np.ceil(a.low / (2.0 * np.pi)) <= np.floor(a.high / (2.0 * np.pi))
        bottom = np.ceil(a.low / (2.0 * np.pi) - 0.5) <= np.floor(a.high / (2.0 * np.pi) - 0.5)
        low = np.where(bottom, -1.0, np.minimum(*ends))
        high = np.where(top, 1.0, np.maximum(*ends))
    return Interval(np.where(np.isnan(low), -1.0, low), np.where(np.isnan(high), 1.0, high))


def angle(y: Interval, x: Interval) -> Interval:
    """Values of arctan2 over boxes; all of them where a box meets the cut or the origin."""
    corners = np.stack(
        np.broadcast_arrays(*(np.arctan2(b, a) for a in (x.low, x.high) for b in (y.low, y.high)))
    )
    cut = (x.low <= 0.0) & (y.low <= 0.0) & (y.high >= 0.0)
    # A box beside the origin is seen under less than half a turn, its corners outermost.
    return chosen(
        cut,
        Interval(np.full(cut.shape, -np.pi), np.full(cut.shape, np.pi)),
        Interval(corners.min(axis=0), corners.max(axis=0)),
    )
