"""The native state and control of a trajectory as Taylor series of intervals."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.body_motion import Index
from berthing.verify.chebyshev import basis, derivative
from berthing.verify.interval import Interval
from berthing.verify.taylor import Taylor


@dataclass(frozen=True)
class Polynomials:
    """Vector polynomials of time, each on its own stretch.

    Attributes:
        t0_s, t1_s: the stretches (n,).
        orders: Chebyshev coefficients (n, degree + 1, c) of the derivatives, by order.
    """

    t0_s: Array
    t1_s: Array
    orders: tuple[Array, ...]

    @staticmethod
    def of(t0_s: Array, t1_s: Array, coefficients: Array, order: int) -> Polynomials:
        """With derivatives up to ``order``."""
        orders = [coefficients]
        for _ in range(order):
            orders.append(derivative(orders[-1], t1_s - t0_s))
        return Polynomials(t0_s, t1_s, tuple(orders))

    def over(self) -> Taylor:
        """Enclosed over each whole stretch: a series of vectors (c, n)."""
        terms = []
        for j, c in enumerate(self.orders):
            middle, reach = c[:, 0].T, np.abs(c[:, 1:]).sum(axis=1).T
            terms.append(Interval(middle - reach, middle + reach).scaled(1.0 / math.factorial(j)))
        return Taylor(tuple(terms))

    def at(self, t: Array, cells: Index) -> Taylor:
        """At the instants t (k,), each in its stretch: a series of vectors (c, k)."""
        middle, half = 0.5 * (self.t0_s + self.t1_s), 0.5 * (self.t1_s - self.t0_s)
        s = (t - middle[cells]) / half[cells]
        terms = []
        for j, c in enumerate(self.orders):
            values = np.einsum("ki,kic->ck", basis(s, c.shape[1]), c[cells])
            terms.append(Interval.of(values / math.factorial(j)))
        return Taylor(tuple(terms))


def clock(t0_s: Array, t1_s: Array, order: int) -> Taylor:
    """The time itself on stretches (n,), instants where both ends are one."""
    zero, one = np.zeros_like(t0_s), np.ones_like(t0_s)
    rest = [Interval.of(zero) for _ in range(order - 1)]
    return Taylor((Interval(t0_s, t1_s), Interval.of(one), *rest))
