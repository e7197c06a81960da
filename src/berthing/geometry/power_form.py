"""Sums of powers as second-order cones, by repeated squaring."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm, SecondOrderBlock, blocks_only, centred_block


def power_form(reaches: Array, exponents: npt.NDArray[np.int64]) -> ConicForm:
    """{x : Σ (x_i/reaches_i)^exponents_i ≤ 1}, every exponent a power of two.

    Where P = 2^k, t ≥ (x/r)^P holds for some t₁ ≥ (x/r)², t₂ ≥ t₁², …, t = t_k; the squares of
    exponent 2 share one t. Each t is a helping variable, times the largest reach to make it a
    length.

    Raises:
        CapabilityError: another exponent.
    """
    if np.any(exponents & (exponents - 1)):
        raise CapabilityError(
            f"a superellipsoid with exponents {exponents.tolist()} has no conic form; those have "
            "one whose exponents are all powers of two"
        )
    if np.all(exponents == 2):
        return blocks_only(len(reaches), centred_block(1.0, np.diag(1.0 / reaches)))
    return _Chain(reaches).form(exponents)


class _Chain:
    """Helping variables and blocks as they are added."""

    def __init__(self, reaches: Array) -> None:
        self.reaches, self.unit = reaches, float(np.max(reaches))
        self.links: list[list[tuple[int, float]]] = []

    def form(self, exponents: npt.NDArray[np.int64]) -> ConicForm:
        dim = len(self.reaches)
        lasts = [self._raised(i, int(P)) for i, P in enumerate(exponents) if P > 2]
        squares = [(i, 1.0 / self.reaches[i]) for i, P in enumerate(exponents) if P == 2]
        if squares:
            lasts.append(self._above(squares))
        size = dim + len(self.links)
        total = np.zeros((1, size))
        total[0, lasts] = 1.0
        blocks = tuple(self._block(k, size) for k in range(len(self.links)))
        return ConicForm(dim, total, np.array([self.unit]), blocks, len(self.links))

    def _raised(self, i: int, exponent: int) -> int:
        """Column of the variable that is at least (x_i/r_i)^exponent."""
        column, scale = i, 1.0 / self.reaches[i]
        while exponent > 1:
            column, scale = self._above([(column, scale)]), 1.0 / self.unit
            exponent //= 2
        return column

    def _above(self, terms: list[tuple[int, float]]) -> int:
        """Column of a new variable that is at least the sum of the squares of scaled columns."""
        self.links.append(terms)
        return len(self.reaches) + len(self.links) - 1

    def _block(self, k: int, size: int) -> SecondOrderBlock:
        """Σ u² ≤ t as ‖(2 u, t − 1)‖ ≤ t + 1."""
        terms = self.links[k]
        A, b = np.zeros((len(terms) + 1, size)), np.zeros(len(terms) + 1)
        for row, (column, scale) in enumerate(terms):
            A[row, column] = 2.0 * scale
        slope = np.zeros(size)
        slope[len(self.reaches) + k] = A[-1, len(self.reaches) + k] = 1.0 / self.unit
        b[-1] = -1.0
        return SecondOrderBlock(1.0, A, b, slope)
