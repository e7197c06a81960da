"""Legendre–Gauss–Radau points and weights (Garg et al., 10.1016/j.automatica.2010.06.048)."""

from __future__ import annotations

import numpy as np
from numpy.polynomial import legendre

from berthing.errors import InputError
from berthing.geometry.arrays import Array

NEWTON_STEPS = 3
"""Companion-matrix roots are good to 1e-12 or so; two Newton steps reach rounding, one to spare."""


def radau(n: int) -> tuple[Array, Array]:
    """Points (n,) with -1 first and weights (n,), exact for polynomials of degree 2 n - 2.

    The points are the roots of P_{n-1} + P_n; w_i = (1 - x_i) / (n P_{n-1}(x_i))².

    Raises:
        InputError: fewer than one point.
    """
    if n < 1:
        raise InputError("Radau points", f"{n} of them", "at least one")
    series = np.zeros(n + 1)
    series[n - 1] = series[n] = 1.0
    x = np.sort(np.real(legendre.legroots(series)))
    slope = legendre.legder(series)
    for _ in range(NEWTON_STEPS):
        x = x - legendre.legval(x, series) / legendre.legval(x, slope)
    x[0] = -1.0
    last = np.zeros(n)
    last[n - 1] = 1.0
    return x, (1.0 - x) / (n * legendre.legval(x, last)) ** 2


def with_end(points: Array) -> Array:
    """The points and the end 1, which Radau leaves out."""
    return np.append(points, 1.0)
