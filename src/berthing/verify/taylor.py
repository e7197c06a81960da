"""Taylor series with interval coefficients: a function and its derivatives, enclosed.

Of a function of time on a cell, coefficient j holds f⁽ʲ⁾(t)/j! for every t of the cell; at an
instant the intervals are points. Sums and products follow Leibniz, elementary functions the
recurrences of their differential equations (Moore, Kearfott, Cloud, *Introduction to Interval
Analysis*, 2009, chapter 9).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from berthing.errors import InputError
from berthing.verify.body_motion import Mask
from berthing.verify.interval import Interval, chosen, hull

Terms = tuple[Interval, ...]


@dataclass(frozen=True)
class Certainty:
    """Where a comparison of series of that order holds and where it fails, for sure (k,)."""

    holds: Mask
    fails: Mask
    order: int


class Taylor:
    """Coefficients by order, each of a scalar (k,) or a vector (n, k), over k cells or instants."""

    # NumPy leaves arithmetic with these to the methods below.
    __array_ufunc__ = None

    def __init__(self, terms: Terms) -> None:
        self.terms = terms

    def __repr__(self) -> str:
        return f"Taylor(order {len(self.terms) - 1}, {self.terms[0].low.shape})"

    @property
    def is_vector(self) -> bool:
        """Whether it has entries."""
        return self.terms[0].low.ndim == 2

    def __len__(self) -> int:
        if not self.is_vector:
            raise TypeError("a scalar has no entries")
        return len(self.terms[0].low)

    def __getitem__(self, index: int | slice) -> Taylor:
        if not self.is_vector:
            if index == 0:
                return self
            raise IndexError("a scalar has one entry")
        return Taylor(tuple(term[index] for term in self.terms))

    def __neg__(self) -> Taylor:
        return Taylor(tuple(-term for term in self.terms))

    def __add__(self, other: Any) -> Taylor:
        return self._paired(other, lambda a, b: a + b)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Taylor:
        return self._paired(other, lambda a, b: a - b)

    def __rsub__(self, other: Any) -> Taylor:
        return self.like(other) - self

    def __mul__(self, other: Any) -> Taylor:
        return product(self, self.like(other))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Taylor:
        return quotient(self, self.like(other))

    def __rtruediv__(self, other: Any) -> Taylor:
        return quotient(self.like(other), self)

    def __pow__(self, exponent: Any) -> Taylor:
        if not isinstance(exponent, int | float) or exponent != int(exponent):
            raise InputError("power", f"is to the {exponent}", "a whole number; or exp and log")
        if exponent < 0:
            return 1.0 / self**-exponent
        return _power(self, int(exponent))

    def __lt__(self, other: Any) -> Certainty:
        a, b = self.terms[0], self.like(other).terms[0]
        return Certainty(a.high < b.low, a.low >= b.high, len(self.terms) - 1)

    def __gt__(self, other: Any) -> Certainty:
        a, b = self.terms[0], self.like(other).terms[0]
        return Certainty(a.low > b.high, a.high <= b.low, len(self.terms) - 1)

    def __le__(self, other: Any) -> Certainty:
        found = self > other
        return Certainty(found.fails, found.holds, found.order)

    def __ge__(self, other: Any) -> Certainty:
        found = self < other
        return Certainty(found.fails, found.holds, found.order)

    def like(self, value: Any) -> Taylor:
        """``value`` as a series of this one's order; a number or an array (n,) is constant."""
        return constant(value, len(self.terms) - 1)

    def _paired(self, other: Any, combine: Callable[[Interval, Interval], Interval]) -> Taylor:
        pairs = zip(self.terms, self.like(other).terms, strict=True)
        return Taylor(tuple(combine(a, b) for a, b in pairs))


def constant(value: Any, order: int) -> Taylor:
    """A number or an array (n,) as a series; what is one stays as it is."""
    if isinstance(value, Taylor):
        return value
    first = Interval.of(np.asarray(value, dtype=np.float64)[..., None])
    zero = Interval.of(np.zeros_like(first.low))
    return Taylor((first, *(zero for _ in range(order))))


def product(a: Taylor, b: Taylor) -> Taylor:
    """Σ_j a_j b_{k−j}."""
    return Taylor(tuple(_convolved(a.terms, b.terms, k, 0, k) for k in range(len(a.terms))))


def square(a: Taylor) -> Taylor:
    """a², whose even terms hold a true square."""
    terms = []
    for k in range(len(a.terms)):
        pairs = [(a.terms[j] * a.terms[k - j]).scaled(2.0) for j in range((k + 1) // 2)]
        if k % 2 == 0:
            pairs.append(a.terms[k // 2].square())
        terms.append(_sum(pairs))
    return Taylor(tuple(terms))


def quotient(a: Taylor, b: Taylor) -> Taylor:
    """c with b c = a: c_k = (a_k − Σ_{j≥1} b_j c_{k−j})/b_0."""
    terms: list[Interval] = []
    for k, term in enumerate(a.terms):
        known = _sum([b.terms[j] * terms[k - j] for j in range(1, k + 1)])
        terms.append((term - known) / b.terms[0])
    return Taylor(tuple(terms))


def integrated(
    first: Interval, slopes: Callable[[list[Interval], int], Interval], order: int
) -> Taylor:
    """The series that begins with ``first`` and whose k c_k is ``slopes(terms so far, k)``."""
    terms = [first]
    for k in range(1, order + 1):
        terms.append(slopes(terms, k).scaled(1.0 / k))
    return Taylor(tuple(terms))


def slope_of(a: Taylor) -> Terms:
    """k a_k for k = 0, 1, …: the terms of t·ȧ."""
    return tuple(term.scaled(float(k)) for k, term in enumerate(a.terms))


def picked(condition: Certainty, a: Taylor, b: Taylor, *, joined: bool) -> Taylor:
    """``a`` where the condition holds, ``b`` where it fails, both where that is not known.

    Where it is not known the value lies in the hull. So does the slope if a = b where the
    condition turns (``joined``); further derivatives do not exist there.
    """
    doubt = ~(condition.holds | condition.fails)
    terms = []
    for k, (x, y) in enumerate(zip(a.terms, b.terms, strict=True)):
        both = hull(x, y)
        if k > 1 or (k == 1 and not joined):
            both = Interval.whole(both.low.shape)
        terms.append(chosen(doubt, both, chosen(condition.holds, x, y)))
    return Taylor(tuple(terms))


def _power(a: Taylor, exponent: int) -> Taylor:
    if exponent == 0:
        return a * 0.0 + 1.0
    half = _power(a, exponent // 2) if exponent > 1 else None
    if half is None:
        return a
    even = square(half)
    return product(even, a) if exponent % 2 else even


def _convolved(a: Terms, b: Terms, k: int, first: int, last: int) -> Interval:
    return _sum([a[j] * b[k - j] for j in range(first, last + 1)])


def _sum(items: list[Interval]) -> Interval:
    total = Interval.of(0.0)
    for item in items:
        total = total + item
    return total
