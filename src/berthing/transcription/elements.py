"""A programme as a sum of small elements, so that it is built in milliseconds.

Every nonlinear row depends on a few variables through one of a handful of kernels: the dynamics
at a node, the separation at a site. With z_e the variables of element e gathered from x,

    f(x) = Σ_e φ_e(z_e, p_e, c_e),    g(x) = A x + Σ_e S_e ψ_e(z_e, p_e, c_e),

Jacobian and Hessian are the kernels' own, scattered. Kernels are differentiated once each and
mapped over their elements; differentiating the whole programme instead takes seconds.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array
from berthing.sym import Sym

Index = npt.NDArray[np.int64]


class Kernel:
    """Rows ψ (m) and a term φ of the objective over local variables z, parameters p, constants c.

    Args:
        z, p, c: SX columns; p and c may be empty.
        rows: SX column (m,).
        objective: SX scalar.
    """

    def __init__(self, z: Sym, p: Sym, c: Sym, rows: Sym, objective: Sym = 0.0) -> None:
        z, p, c, rows, objective = (ca.SX(ca.densify(ca.SX(v))) for v in (z, p, c, rows, objective))
        self.sizes = (z.numel(), p.numel(), c.numel(), rows.numel())
        inputs = [z, p, c]
        jacobian: Sym = ca.jacobian(rows, z)
        self.jacobian_pattern: Sequence[Index] = _pattern(jacobian.sparsity())
        gradient = ca.densify(ca.gradient(objective, z))
        lam, lam_f = ca.SX.sym("lam", rows.numel()), ca.SX.sym("lam_f")
        lagrangian = lam_f * objective + ca.dot(lam, rows)
        hessian: Sym = ca.triu(ca.hessian(lagrangian, z)[0])
        self.hessian_pattern: Sequence[Index] = _pattern(hessian.sparsity())
        self.value = ca.Function("value", inputs, [rows, objective])
        self.first = ca.Function("first", inputs, [_nonzeros(jacobian), gradient])
        self.second = ca.Function("second", [*inputs, lam, lam_f], [_nonzeros(hessian)])


@dataclass(frozen=True)
class Batch:
    """n elements of one kernel.

    Attributes:
        z: (n, nz) indices into the variables; p: (n, np) into the parameters.
        c: (n, nc) constants.
        rows: (n, m) rows that ψ adds to.
    """

    kernel: Kernel
    z: Index
    p: Index
    c: Array
    rows: Index


@dataclass
class Elements:
    """Batches and linear terms, collected while rows are written."""

    batches: list[Batch] = field(default_factory=list)
    _linear: list[tuple[Index, Index, Array]] = field(default_factory=list)

    def add(
        self, kernel: Kernel, z: npt.ArrayLike, p: npt.ArrayLike, c: npt.ArrayLike,
        rows: npt.ArrayLike,
    ) -> None:  # fmt: skip
        """Append elements of ``kernel``, one a line of the index arrays.

        Raises:
            ValueError: a line of ``z`` names a variable twice; the upper triangle of the element's
                Hessian would then hold only one of two equal terms.
        """
        z = np.atleast_2d(np.asarray(z, dtype=np.int64))
        n = len(z)
        if np.any(np.diff(np.sort(z, axis=1), axis=1) == 0):
            raise ValueError("an element names a variable twice")
        sizes = kernel.sizes
        self.batches.append(
            Batch(
                kernel, z.reshape(n, sizes[0]),
                np.asarray(p, dtype=np.int64).reshape(n, sizes[1]),
                np.asarray(c, dtype=np.float64).reshape(n, sizes[2]),
                np.asarray(rows, dtype=np.int64).reshape(n, sizes[3]),
            )
        )  # fmt: skip

    def add_linear(self, row: npt.ArrayLike, column: npt.ArrayLike, value: npt.ArrayLike) -> None:
        """Add value · x[column] to each row; the three broadcast against each other."""
        r, c, v = np.broadcast_arrays(row, column, value)
        self._linear.append((r.ravel().astype(np.int64), c.ravel().astype(np.int64),
                             v.ravel().astype(np.float64)))  # fmt: skip

    def programme(self, variables: int, parameters: int, rows: int) -> Mapping[str, Any]:
        """Casadi expressions x, p, f, g and the functions grad_f, jac_g, hess_lag of them."""
        x, p = ca.MX.sym("x", variables), ca.MX.sym("p", parameters)
        lam_f, lam_g = ca.MX.sym("lam_f"), ca.MX.sym("lam_g", rows)
        linear_rows, linear_columns, linear_values = self._linear_terms()
        A = _sparse(rows, variables, linear_rows, linear_columns, linear_values)
        f, g, gradient = ca.MX(0), ca.mtimes(A, x), ca.MX.zeros(variables)
        first = _Scatter((rows, variables), linear_rows, linear_columns, linear_values)
        second = _Scatter((variables, variables))
        for batch in self.batches:
            inputs = _inputs(batch, x, p)
            n, m = batch.rows.shape
            psi, phi = batch.kernel.value.map(n)(*inputs)
            f = f + ca.sum2(phi)
            jacobian, slope = batch.kernel.first.map(n)(*inputs)
            gradient = gradient + _added(variables, batch.z, slope)
            if m:
                g = g + _added(rows, batch.rows, psi)
                i, j = batch.kernel.jacobian_pattern
                first.add(batch.rows[:, i], batch.z[:, j], jacobian)
            lam = ca.reshape(lam_g[batch.rows.ravel().tolist()], m, n) if m else ca.MX(0, n)
            hessian = batch.kernel.second.map(n)(*inputs, lam, ca.repmat(lam_f, 1, n))
            i, j = batch.kernel.hessian_pattern
            a, b = batch.z[:, i], batch.z[:, j]
            second.add(np.minimum(a, b), np.maximum(a, b), hessian)
        return {
            "x": x, "p": p, "f": f, "g": g,
            "grad_f": ca.Function("grad_f", [x, p], [f, gradient]),
            "jac_g": ca.Function("jac_g", [x, p], [g, first.matrix()]),
            "hess_lag": ca.Function("hess_lag", [x, p, lam_f, lam_g], [second.matrix()]),
        }  # fmt: skip

    def _linear_terms(self) -> tuple[Index, Index, Array]:
        if not self._linear:
            return np.empty(0, np.int64), np.empty(0, np.int64), np.empty(0)
        parts = list(zip(*self._linear, strict=True))
        return np.concatenate(parts[0]), np.concatenate(parts[1]), np.concatenate(parts[2])


class _Scatter:
    """Sums nonzeros that land on the same entry of a sparse matrix."""

    def __init__(
        self, shape: tuple[int, int], rows: Index | None = None, columns: Index | None = None,
        values: Array | None = None,
    ) -> None:  # fmt: skip
        self.shape = shape
        empty = np.empty(0, np.int64)
        self.rows = [empty if rows is None else rows]
        self.columns = [empty if columns is None else columns]
        self.values: list[Sym] = [ca.MX(ca.DM(np.empty(0) if values is None else values))]

    def add(self, rows: Index, columns: Index, values: Sym) -> None:
        """Entries (n, k) with values (k, n), a casadi matrix."""
        self.rows.append(rows.ravel())
        self.columns.append(columns.ravel())
        self.values.append(ca.vec(values))

    def matrix(self) -> Sym:
        rows, columns = np.concatenate(self.rows), np.concatenate(self.columns)
        keys, position = np.unique(columns * self.shape[0] + rows, return_inverse=True)
        pattern = ca.Sparsity.triplet(
            *self.shape, (keys % self.shape[0]).tolist(), (keys // self.shape[0]).tolist()
        )
        gather = _sparse(len(keys), len(rows), position, np.arange(len(rows)), np.ones(len(rows)))
        nonzeros = ca.mtimes(gather, ca.vertcat(*self.values))
        return ca.MX(pattern, nonzeros)


def _inputs(batch: Batch, x: Sym, p: Sym) -> list[Sym]:
    n = len(batch.z)
    nz, n_p = batch.z.shape[1], batch.p.shape[1]
    z = ca.reshape(x[batch.z.ravel().tolist()], nz, n) if nz else ca.MX(0, n)
    parameters = ca.reshape(p[batch.p.ravel().tolist()], n_p, n) if n_p else ca.MX(0, n)
    return [z, parameters, ca.MX(ca.DM(batch.c.T)) if batch.c.size else ca.MX(0, n)]


def _added(size: int, index: Index, values: Sym) -> Sym:
    """Column (size,) with values (k, n) added at the indices (n, k)."""
    flat = index.ravel()
    gather = _sparse(size, len(flat), flat, np.arange(len(flat)), np.ones(len(flat)))
    return ca.mtimes(gather, ca.vec(values))


def _sparse(rows: int, columns: int, i: Index, j: Index, values: Array) -> Sym:
    # casadi keeps one of several values at a place; here they add up.
    keys, position = np.unique(j * rows + i, return_inverse=True)
    sums = np.bincount(position, values, minlength=len(keys))
    return ca.DM.triplet((keys % rows).tolist(), (keys // rows).tolist(), sums, rows, columns)


def _pattern(sparsity: Sym) -> tuple[Index, Index]:
    rows, columns = sparsity.get_triplet()
    return np.asarray(rows, np.int64), np.asarray(columns, np.int64)


def _nonzeros(matrix: Sym) -> Sym:
    return ca.vertcat(*matrix.nonzeros()) if matrix.nnz() else ca.SX(0, 1)
