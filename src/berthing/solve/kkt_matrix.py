"""The symmetric systems of an interior-point step, factorised without pivoting.

    [H + δI   Jᵀ] [dx]
    [J       -E ] [y ]

With E > 0 and δ large enough the matrix is quasi-definite, and an LDLᵀ without pivoting exists for
every ordering (Vanderbei, 10.1137/0805005): one ordering serves all steps, and the signs of D are
the inertia. Pivoting, as MUMPS does it, takes ten times as long at these sizes.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import qdldl
from scipy import sparse

from berthing.geometry.arrays import Array


class KktMatrix:
    """Upper triangle of the matrix above, its numbers renewed in place.

    Args:
        hessian, jacobian: casadi patterns, the first of an upper triangle.

    Attributes:
        negative: how many pivots are, of the last factorisation; -1 where there is none.
    """

    def __init__(self, hessian: Any, jacobian: Any) -> None:
        m, n = jacobian.shape
        self.variables, self.rows = n, m
        h_row, h_column = (np.asarray(v) for v in hessian.get_triplet())
        j_row, j_column = (np.asarray(v) for v in jacobian.get_triplet())
        own, below = np.arange(n), n + np.arange(m)
        keys, place = np.unique(
            np.concatenate([h_column, own, n + j_row, below]) * (n + m)
            + np.concatenate([h_row, own, j_column, below]),
            return_inverse=True,
        )
        ends = np.cumsum([0, len(h_row), n, len(j_row), m])
        self._h, self._diagonal, self._j, self._e = (place[i:j] for i, j in pairwise(ends))
        starts = np.searchsorted(keys // (n + m), np.arange(n + m + 1))
        self._upper = sparse.csc_matrix(
            (np.zeros(len(keys)), (keys % (n + m)).astype(np.int32), starts.astype(np.int32)),
            shape=(n + m, n + m),
        )
        self._lower = self._upper.T  # shares the numbers
        self._on = np.concatenate([self._diagonal, self._e])
        self._factors: Any = None
        self._curvature = np.zeros(n)
        self.negative: int = -1

    def fill(self, hessian: Array, jacobian: Array) -> None:
        """Take the nonzeros of H and J."""
        data = self._upper.data
        data[:] = 0.0
        data[self._h] = hessian
        data[self._j] = jacobian
        self._curvature = data[self._diagonal].copy()

    def factorise(self, shift: float | Array, corner: Array) -> bool:
        """Factorise with δ = ``shift`` and the diagonal E = ``corner`` (m,); whether the inertia
        is (n, m, 0), so that steps descend."""
        data = self._upper.data
        data[self._diagonal] = self._curvature + shift
        data[self._e] = -corner
        try:
            if self._factors is None:
                self._factors = qdldl.Solver(self._upper, upper=True)
            else:
                self._factors.update(self._upper, upper=True)
        except RuntimeError:
            # A pivot of zero.
            self._factors, self.negative = None, -1
            return False
        self.negative = int(np.count_nonzero(self._factors.factors()[1] < 0.0))
        return bool(self.negative == self.rows)

    def solve(self, right: Array) -> Array:
        """The solution (n + m,), refined once."""
        first = self._factors.solve(right)
        return np.asarray(first + self._factors.solve(right - self.times(first)))

    def times(self, v: Array) -> Array:
        """The matrix, shift and corner included, times v (n + m,)."""
        return np.asarray(self._upper @ v + self._lower @ v - self._upper.data[self._on] * v)

    def transposed_times(self, y: Array) -> Array:
        """Jᵀ y (n,), from the block that holds it."""
        v = np.zeros(self.variables + self.rows)
        v[self.variables :] = y
        return np.asarray((self._upper @ v)[: self.variables])
