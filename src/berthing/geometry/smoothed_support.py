"""Support points of a smoothed polytope {x : Σ exp(Q_j (a_j·x − b_j)) ≤ 1}."""

from __future__ import annotations

from functools import cached_property

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array
from berthing.geometry.boundary_climb import Hill
from berthing.geometry.convex_set import norm
from berthing.geometry.hulls import enclosed, inner_point, normal_cones
from berthing.geometry.log_sum_exp import LogSumExp, lowest_point

# The set must reach this far below zero, in terms of its size, or it is called empty.
THINNEST = 1e-9
# Logarithms of weights: exp of the first is below rounding, of the second one face among many.
LEAST_LOG_WEIGHT, MODEST_LOG_WEIGHT = -40.0, -2.0
# Residual above which a support point is sought again from elsewhere.
ASTRAY = 1e-9
# How much smaller the exponents of a rounder set are.
ROUNDER = 4.0


class SmoothedSupport:
    """The set's support points, by Newton's method from a point that is often the answer already.

    Args:
        A: unit rows (m, d).
        b: (m,) in metres.
        Q: exponents (m,) to the base e, per metre.
        where: the name used in errors.

    Raises:
        InputError: half-spaces that enclose nothing, or no bounded set.
    """

    def __init__(self, A: Array, b: Array, Q: Array, where: str) -> None:
        self.A, self.b, self.Q, self.where = A, b, Q, where
        scale = Q / np.max(Q)
        # Where faces of small exponent are far, and those of large exponent may be near.
        middle = inner_point(scale[:, None] * A, scale * b, where)
        self.function = LogSumExp(Q[:, None] * A, Q * b, float(np.max(Q)))
        self.centre = lowest_point(self.function, middle)
        self.corners = enclosed(A, b, where)[2]
        width = 2.0 * float(np.max(norm(self.corners - middle)))
        self.hill = Hill(self.function, self.centre, width)

    @property
    def is_empty(self) -> bool:
        """Whether nothing is left of the polytope, or next to nothing."""
        return float(self.function.value(self.centre)) > -THINNEST * self.hill.size

    def points(self, n: Array) -> tuple[Array, Array]:
        """Support points (k, d) in unit directions n (k, d), and residuals (k,).

        What is left to gain along n is at most the residual times the greatest width. The few
        that an estimate does not lead to are approached another way: from closer to the vertex,
        then from rounder sets.
        """
        point, residual = np.empty_like(n), np.full(len(n), np.inf)
        for start in (self._far, self._near, self._rounded):
            astray = np.flatnonzero(residual > ASTRAY)
            if not len(astray):
                break
            again, left = self.hill.climb(n[astray], start(n[astray]))
            better = left < residual[astray]
            point[astray[better]], residual[astray[better]] = again[better], left[better]
        return point, residual

    def _far(self, n: Array) -> Array:
        return self._estimate(n, LEAST_LOG_WEIGHT)

    def _near(self, n: Array) -> Array:
        return self._estimate(n, MODEST_LOG_WEIGHT)

    def _rounded(self, n: Array) -> Array:
        rounder = SmoothedSupport(self.A, self.b, self.Q / ROUNDER, self.where)
        return self.centre + n if rounder.is_empty else rounder.points(n)[0]

    def _estimate(self, n: Array, least: float) -> Array:
        """Points (k, d) near the support points in unit directions n (k, d).

        Where only the rows that meet at one vertex count, n = Σ ν_j a_j gives each its share of
        the sum, w_j ∝ ν_j/Q_j, and a_j·x = b_j + ln(w_j)/Q_j gives x. A row without a share is
        taken for one of exp(least), or as far as the centre is.
        """
        rows, inverses = self._cones
        shares = np.einsum("ki,sij->ksj", n, inverses)
        nearest = np.argmax(np.min(shares, axis=-1), axis=-1)
        at, Q = rows[nearest], self.Q[rows[nearest]]
        weights = np.take_along_axis(shares, nearest[:, None, None], axis=1)[:, 0] / Q
        weights = weights / np.sum(np.abs(weights), axis=-1, keepdims=True)
        depth = Q * (self.b[at] - self.A[at] @ self.centre)
        logs = np.maximum(np.log(np.maximum(weights, np.exp(least))), -depth)
        return np.asarray(np.einsum("kij,kj->ki", inverses[nearest], self.b[at] + logs / Q))

    @cached_property
    def _cones(self) -> tuple[npt.NDArray[np.int64], Array]:
        """Rows (s, d) that meet at vertices, and the inverses (s, d, d) of their matrices."""
        rows = normal_cones(self.A, self.b, self.centre, self.where)
        return rows, np.asarray(np.linalg.inv(self.A[rows]))
