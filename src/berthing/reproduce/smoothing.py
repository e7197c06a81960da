"""How far the smoothed square and box of eq. (d-func3) lie inside the true ones."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from berthing.geometry.arrays import Array

EXPONENTS = np.array([2.0, 4, 8, 16, 32, 64, 128])
HALF_SIZES_M = np.array([0.1, 0.2, 0.5, 1.0, 2.0, 5.0])


@dataclass(frozen=True)
class CornerError:
    """Of squares: (exponents, sizes); NaN where the smoothed square is empty.

    Attributes:
        recession_m: along the normal of each of the two faces, from corner to smoothed corner.
    """

    exponents: Array
    half_sizes_m: Array
    recession_m: Array

    @property
    def relative(self) -> Array:
        """To the half-size."""
        return self.recession_m / self.half_sizes_m


def corner_error(exponents: Array = EXPONENTS, half_sizes_m: Array = HALF_SIZES_M) -> CornerError:
    """Every exponent with every size."""
    grid = [[recession(float(q), float(a), 2) for a in half_sizes_m] for q in exponents]
    return CornerError(exponents, half_sizes_m, np.array(grid))


def recession(exponent: float, half_size_m: float, dim: int) -> float:
    """a − x where Σ over ``dim`` axes of e^{Q(x−a)} + e^{Q(−x−a)} is 1; NaN where nothing is left.

    On the diagonal of a cube of half-size a; the corner itself is √dim times as far away.
    """

    def level(x: float) -> float:
        terms = exponent * np.array([x - half_size_m, -x - half_size_m])
        return float(np.logaddexp(*terms) + np.log(dim))

    if level(0.0) > 0.0:
        return float("nan")
    return half_size_m - float(brentq(level, 0.0, half_size_m, xtol=1e-14))
