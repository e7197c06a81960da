"""ln Σ exp(Q_j (a_j·x − b_j)) / q, safe against overflow, with two derivatives."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array


@dataclass(frozen=True, eq=False)
class LogSumExp:
    """The paper's eq. (d-func3): convex, as it is LSE of affine functions.

    Attributes:
        rows: Q_j a_j (m, d), per metre.
        offsets: Q_j b_j (m,).
        divisor: q, per metre.
    """

    rows: Array
    offsets: Array
    divisor: float

    def value(self, x: Array) -> Array:
        """(...) in metres at x (..., d)."""
        return self._softmax(x)[0]

    def gradient(self, x: Array) -> Array:
        """(..., d), without unit."""
        return np.asarray(self._softmax(x)[1] @ self.rows / self.divisor)

    def hessian(self, x: Array) -> Array:
        """(..., d, d), per metre."""
        return self.all(x)[2]

    def all(self, x: Array) -> tuple[Array, Array, Array]:
        """Value (...), gradient (..., d) and Hessian (..., d, d): one softmax for the three."""
        value, weights = self._softmax(x)
        gradient = weights @ self.rows
        second = np.einsum("...m,mi,mj->...ij", weights, self.rows, self.rows)
        hessian = second - gradient[..., :, None] * gradient[..., None, :]
        return value, gradient / self.divisor, hessian / self.divisor

    def along(self, x: Array, d: Array) -> tuple[Array, Array]:
        """Value (...) and slope (...) in the direction d (..., d)."""
        value, weights = self._softmax(x)
        return value, np.sum(weights * (d @ self.rows.T), axis=-1) / self.divisor

    def _softmax(self, x: Array) -> tuple[Array, Array]:
        """Value (...) and the weights w_j (..., m), which sum to 1."""
        z = x @ self.rows.T - self.offsets
        largest = np.max(z, axis=-1, keepdims=True)
        terms = np.exp(z - largest)
        total = np.sum(terms, axis=-1, keepdims=True)
        return ((largest + np.log(total)) / self.divisor)[..., 0], terms / total


# Newton's method for the lowest point: quadratic at the end, and a few halvings before.
MAX_STEPS, SHORTEST_STEP = 60, 1e-9
# Of the predicted gain over the value's size, below which nothing is left to gain.
GAIN_TOLERANCE = 1e-14
REGULARISER = 1e-12


def lowest_point(f: LogSumExp, start: Array) -> Array:
    """Where f is least (d,), by Newton's method with halved steps from ``start`` (d,).

    Started at the point deepest inside the half-spaces, where several faces are equally near, it
    needs a few steps. The value of whatever it returns is an upper bound on the least.
    """
    x, value = start, float(f.value(start))
    for _ in range(MAX_STEPS):
        _, gradient, hessian = f.all(x)
        curved = hessian + REGULARISER * np.trace(hessian) * np.eye(len(x))
        if not np.trace(curved) > 0.0:
            break
        step = -np.linalg.solve(curved, gradient)
        length = 1.0
        while f.value(x + length * step) >= value and length > SHORTEST_STEP:
            length *= 0.5
        gained = value - float(f.value(x + length * step))
        if gained <= GAIN_TOLERANCE * abs(value):
            break
        x, value = x + length * step, value - gained
    return x
