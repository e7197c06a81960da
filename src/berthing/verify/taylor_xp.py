"""The user's vocabulary with Taylor series of intervals: what it encloses is proven."""

from __future__ import annotations

from typing import Any

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.interval import Interval, angle, cosine, monotone
from berthing.verify.taylor import (
    Certainty,
    Taylor,
    constant,
    integrated,
    picked,
    product,
    slope_of,
    square,
)
from berthing.xp import NUMPY, Condition, Namespace, Scalar, Vector


class TaylorNamespace(Namespace):
    """Enclosures of values and derivatives; what depends on nothing stays a number."""

    def sin(self, a: Vector) -> Vector:
        return _sin_cos(a)[0] if isinstance(a, Taylor) else NUMPY.sin(a)

    def cos(self, a: Vector) -> Vector:
        return _sin_cos(a)[1] if isinstance(a, Taylor) else NUMPY.cos(a)

    def exp(self, a: Vector) -> Vector:
        if not isinstance(a, Taylor):
            return NUMPY.exp(a)
        slopes = slope_of(a)

        def rule(c: list[Interval], k: int) -> Interval:
            return _dot(slopes, c, k)

        return integrated(monotone(np.exp, a.terms[0]), rule, len(a.terms) - 1)

    def log(self, a: Vector) -> Vector:
        if not isinstance(a, Taylor):
            return NUMPY.log(a)
        return _by_division(a, a, monotone(np.log, a.terms[0]))

    def sqrt(self, a: Vector) -> Vector:
        if not isinstance(a, Taylor):
            return NUMPY.sqrt(a)
        # c² = a: 2 c_0 c_k = a_k − Σ_{0<j<k} c_j c_{k−j}. Rounding may leave a square below zero.
        first = monotone(lambda v: np.sqrt(np.maximum(v, 0.0)), a.terms[0])
        terms = [first]
        for k in range(1, len(a.terms)):
            known = Interval.of(0.0)
            for j in range(1, k):
                known = known + terms[j] * terms[k - j]
            terms.append((a.terms[k] - known) / first.scaled(2.0))
        return Taylor(tuple(terms))

    def arctan(self, a: Vector) -> Vector:
        if not isinstance(a, Taylor):
            return NUMPY.arctan(a)
        return _by_division(a, square(a) + 1.0, monotone(np.arctan, a.terms[0]))

    def arctan2(self, y: Vector, x: Vector) -> Vector:
        if not (isinstance(y, Taylor) or isinstance(x, Taylor)):
            return NUMPY.arctan2(y, x)
        y = y if isinstance(y, Taylor) else x.like(y)
        x = y.like(x)
        # (x² + y²) θ̇ = x ẏ − y ẋ.
        turn = product(x, Taylor(slope_of(y))) - product(y, Taylor(slope_of(x)))
        return _divided(turn, square(x) + square(y), angle(y.terms[0], x.terms[0]))

    def abs(self, a: Vector) -> Vector:
        if not isinstance(a, Taylor):
            return NUMPY.abs(a)
        whole = picked(a > 0.0, a, -a, joined=True)
        first = Interval(np.maximum(whole.terms[0].low, 0.0), whole.terms[0].high)
        return Taylor((first, *whole.terms[1:]))

    def minimum(self, a: Vector, b: Vector) -> Vector:
        if not (isinstance(a, Taylor) or isinstance(b, Taylor)):
            return NUMPY.minimum(a, b)
        return -self.maximum(-a, -b)

    def maximum(self, a: Vector, b: Vector) -> Vector:
        if not (isinstance(a, Taylor) or isinstance(b, Taylor)):
            return NUMPY.maximum(a, b)
        a = a if isinstance(a, Taylor) else b.like(a)
        b = a.like(b)
        whole = picked(a > b, a, b, joined=True)
        x, y = a.terms[0], b.terms[0]
        first = Interval(np.maximum(x.low, y.low), np.maximum(x.high, y.high))
        return Taylor((first, *whole.terms[1:]))

    def where(self, condition: Condition, a: Scalar, b: Scalar) -> Scalar:
        if not isinstance(condition, Certainty):
            return a if condition else b
        a, b = constant(a, condition.order), constant(b, condition.order)
        return picked(condition, a, b, joined=False)

    def vector(self, *parts: Vector) -> Vector:
        series = next((p for p in parts if isinstance(p, Taylor)), None)
        if series is None:
            return NUMPY.vector(*parts)
        columns = [series.like(p) for p in parts]
        count = max(c.terms[0].low.shape[-1] for c in columns)
        terms = zip(*(c.terms for c in columns), strict=True)
        return Taylor(
            tuple(
                Interval(*(_stacked([getattr(i, end) for i in row], count) for end in _ENDS))
                for row in terms
            )
        )

    def size(self, a: Vector) -> int:
        if not isinstance(a, Taylor):
            return NUMPY.size(a)
        return len(a) if a.is_vector else 1


_ENDS = ("low", "high")
TAYLOR = TaylorNamespace()


def _sin_cos(a: Taylor) -> tuple[Taylor, Taylor]:
    """ṡ = c ȧ and ċ = −s ȧ."""
    slopes, first = slope_of(a), a.terms[0]
    quarter = Interval.of(0.5 * np.pi)
    s, c = [cosine(first - quarter)], [cosine(first)]
    for k in range(1, len(a.terms)):
        s_k, c_k = _dot(slopes, c, k), -_dot(slopes, s, k)
        s.append(s_k.scaled(1.0 / k))
        c.append(c_k.scaled(1.0 / k))
    return Taylor(tuple(s)), Taylor(tuple(c))


def _dot(slopes: tuple[Interval, ...], c: list[Interval], k: int) -> Interval:
    """Σ_{j=1…k} j a_j c_{k−j}."""
    total = Interval.of(0.0)
    for j in range(1, k + 1):
        total = total + slopes[j] * c[k - j]
    return total


def _by_division(a: Taylor, divisor: Taylor, first: Interval) -> Taylor:
    """c with ċ = ȧ/d."""
    return _divided(Taylor(slope_of(a)), divisor, first)


def _divided(slopes: Taylor, divisor: Taylor, first: Interval) -> Taylor:
    """c that begins with ``first`` and has d·(k c_k) = ``slopes``."""

    def rule(c: list[Interval], k: int) -> Interval:
        known = Interval.of(0.0)
        for j in range(1, k):
            known = known + c[j].scaled(float(j)) * divisor.terms[k - j]
        return (slopes.terms[k] - known) / divisor.terms[0]

    return integrated(first, rule, len(slopes.terms) - 1)


def _stacked(rows: list[Any], count: int) -> Array:
    """Scalars (k,) and vectors (n, k) of k = 1 or ``count`` one above the other."""
    lifted = [row if row.ndim == 2 else row[None] for row in rows]
    return np.concatenate([np.broadcast_to(row, (len(row), count)) for row in lifted])
