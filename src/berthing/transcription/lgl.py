"""Legendre–Gauss–Lobatto points and weights (Fahroo and Ross, 10.2514/2.4709)."""

from __future__ import annotations

import numpy as np
from numpy.polynomial import legendre

from berthing.errors import InputError
from berthing.geometry.arrays import Array

NEWTON_STEPS = 3
"""Companion-matrix roots are good to 1e-12 or so; two Newton steps reach rounding, one to spare."""


def lobatto(n: int) -> tuple[Array, Array]:
    """Points (n,) with both ends and weights (n,), exact for polynomials of degree 2 n - 3.

    The inner points are the roots of P'_{n-1}; w_i = 2 / (n (n - 1) P_{n-1}(x_i)²).

    Raises:
        InputError: fewer than two points.
    """
    if n < 2:
        raise InputError("Lobatto points", f"{n} of them", "at least two")
    series = np.zeros(n)
    series[n - 1] = 1.0
    slope = legendre.legder(series)
    bend = legendre.legder(slope)
    inner = np.sort(np.real(legendre.legroots(slope)))
    for _ in range(NEWTON_STEPS):
        inner = inner - legendre.legval(inner, slope) / legendre.legval(inner, bend)
    # Their own mirror image, which rounding would spoil.
    inner = 0.5 * (inner - inner[::-1])
    x = np.concatenate([[-1.0], inner, [1.0]])
    return x, 2.0 / (n * (n - 1) * legendre.legval(x, series) ** 2)
