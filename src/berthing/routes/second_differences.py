"""The energy of states at equal times, and Newton steps on it and on terms of single states."""

from __future__ import annotations

import numpy as np
from scipy.linalg import solveh_banded

from berthing.geometry.arrays import Array
from berthing.routes.broad_phase import Index


class SecondDifferences:
    """Accelerations of n + 1 states that rest at both ends, where they stay.

    Args:
        count: n.
        step_s: between states.
        weights: (c,), by which the c numbers of an acceleration are multiplied before they are
            squared.
    """

    def __init__(self, count: int, step_s: float, weights: Array) -> None:
        self._squares = weights**2
        # From the differences (n) of states. The first and the last acceleration are those of half
        # a step, from rest.
        self._rise = (np.eye(count + 1, count) - np.eye(count + 1, count, -1)) / step_s**2
        self._rise[[0, -1]] *= 2.0
        self._times = np.full(count + 1, step_s)
        self._times[[0, -1]] *= 0.5
        inner = self._rise @ (np.eye(count, count - 1) - np.eye(count, count - 1, -1))
        self._down = 2.0 * inner.T * self._times
        hessian = self._down @ inner
        n, c = count - 1, len(weights)
        # By diagonals, c numbers a state: the states next to each other and the next but one.
        self._band = np.zeros((2 * c + 1, n, c))
        for k in range(3):
            self._band[k * c, : n - k] = np.diagonal(hessian, -k)[:, None] * self._squares
        self._largest = float(np.max(self._band[0]))

    def energy(self, differences: Array) -> float:
        """∫ |weights · acceleration|² dt, from the differences (n, c) of states."""
        return float(np.sum(self._times[:, None] * (self._rise @ differences) ** 2 * self._squares))

    def newton(
        self, differences: Array, where: Index, slope: Array, first: Array, second: Array,
        damping: float,
    ) -> Array:  # fmt: skip
        """The step (n - 1, c) of the inner states, of the energy and m terms more.

        Args:
            differences: (n, c) of states.
            where: the inner state of each term (m,).
            slope: how what a term depends on grows by a step of that state (m, c).
            first, second: derivatives (m,) of the term by it.
            damping: added to the Hessian, in terms of the energy's largest entry.
        """
        _, n, c = self._band.shape
        force = self._down @ (self._rise @ differences) * self._squares
        np.add.at(force, where, first[:, None] * slope)
        blocks = np.zeros((n, c, c))
        np.add.at(blocks, where, (second[:, None] * slope)[:, :, None] * slope[:, None, :])
        band = self._band.copy()
        for d in range(c):
            band[d, :, : c - d] += np.diagonal(blocks, -d, 1, 2)
        band[0] += damping * self._largest
        step = solveh_banded(
            band.reshape(2 * c + 1, n * c), -force.ravel(), overwrite_ab=True, lower=True,
            check_finite=False,
        )  # fmt: skip
        return np.asarray(step.reshape(n, c))
