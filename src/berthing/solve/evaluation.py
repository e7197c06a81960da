"""A programme's functions on plain arrays: one call into casadi, nothing converted or copied."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import casadi as ca
import numpy as np

from berthing.geometry.arrays import Array


class Evaluation:
    """Values and derivatives of min f(x, p) with rows g(x, p).

    Handing numbers over as casadi matrices costs more than working them out, so that arguments and
    results live in buffers of their own. An object serves one solve at a time.

    Args:
        nlp: expressions and functions, as ``Elements.programme`` gives them.
        bounded: variables that are appended to the rows, so that rows alone have bounds.

    Attributes:
        variables, rows: sizes n and m.
        jacobian, hessian: casadi patterns (m, n), and (n, n) upper triangle.
    """

    def __init__(self, nlp: Mapping[str, Any], bounded: Sequence[int] = ()) -> None:
        x, p, own = nlp["x"], nlp["p"], nlp["g"].numel()
        columns = [int(i) for i in bounded]
        lam_f, lam_g = ca.MX.sym("lam_f"), ca.MX.sym("lam_g", own + len(columns))
        jacobian, hessian = nlp["jac_g"](x, p)[1], nlp["hess_lag"](x, p, lam_f, lam_g[:own])
        picked = ca.Sparsity.triplet(len(columns), x.numel(), [*range(len(columns))], columns)
        jacobian = ca.vertcat(jacobian, ca.MX(picked, ca.DM.ones(len(columns))))
        gradient = ca.densify(nlp["grad_f"](x, p)[1])
        rows = ca.densify(ca.vertcat(nlp["g"], x[columns] if columns else ca.MX(0, 1)))
        value = ca.Function("value", [x, p], [nlp["f"], rows])
        first = ca.Function("first", [x, p, lam_f, lam_g], [gradient, jacobian, hessian])
        self.jacobian, self.hessian = jacobian.sparsity(), hessian.sparsity()
        self.variables, self.rows = x.numel(), lam_g.numel()
        self._x, self._p = np.zeros(self.variables), np.zeros(p.numel())
        self._lam_f, self._lam_g = np.ones(1), np.zeros(self.rows)
        self._value = _Buffered(value, [self._x, self._p])
        self._first = _Buffered(first, [self._x, self._p, self._lam_f, self._lam_g])

    def at(self, parameters: Array) -> None:
        """Take these parameters from now on."""
        self._p[:] = parameters

    def value(self, x: Array) -> tuple[float, Array]:
        """f and g (m,) at x (n,)."""
        self._x[:] = x
        f, g = self._value()
        return float(f[0]), g

    def derivatives(self, x: Array, y: Array) -> tuple[Array, Array, Array]:
        """Gradient of f (n,), nonzeros of g's Jacobian and of the Hessian of f + yᵀ g."""
        self._x[:], self._lam_g[:] = x, y
        gradient, jacobian, hessian = self._first()
        return gradient, jacobian, hessian


class _Buffered:
    """A casadi function that reads and writes fixed arrays; returns copies of what it wrote."""

    def __init__(self, function: Any, inputs: list[Array]) -> None:
        buffer, self._call = function.buffer()
        self._keep: list[Any] = [function, buffer, inputs]
        self._outputs = [np.zeros(function.nnz_out(i)) for i in range(function.n_out())]
        for i, array in enumerate(inputs):
            if array.size:
                buffer.set_arg(i, array.data)
        for i, array in enumerate(self._outputs):
            if array.size:
                buffer.set_res(i, array.data)

    def __call__(self) -> list[Array]:
        call: Callable[[], None] = self._call
        call()
        return [array.copy() for array in self._outputs]
