"""The small vocabulary in which users write their own dynamics, costs and constraints.

A function of the user's own, ``f(t, x, u, p, xp)``, is called in several forms: with casadi's
expressions to be solved, with numbers to be flown and checked, with enclosures to be proven. It
may use arithmetic, indices (``x[0]``, ``x[2:4]``), comparisons inside ``xp.where``, and what is
here. A scalar is a number, a vector a column that ``xp.vector`` makes.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any

import numpy as np

Scalar = Any
"""A number, a casadi expression or an enclosure."""

Vector = Any
"""Several of them in one column: indices and slices give its entries."""

Condition = Any
"""What a comparison gives."""


class Namespace(ABC):
    """One form of the vocabulary; elementwise functions take scalars and vectors."""

    pi = math.pi

    @abstractmethod
    def sin(self, a: Vector) -> Vector: ...
    @abstractmethod
    def cos(self, a: Vector) -> Vector: ...
    @abstractmethod
    def exp(self, a: Vector) -> Vector: ...
    @abstractmethod
    def log(self, a: Vector) -> Vector: ...
    @abstractmethod
    def sqrt(self, a: Vector) -> Vector: ...
    @abstractmethod
    def arctan(self, a: Vector) -> Vector: ...
    @abstractmethod
    def arctan2(self, y: Vector, x: Vector) -> Vector: ...
    @abstractmethod
    def abs(self, a: Vector) -> Vector: ...
    @abstractmethod
    def minimum(self, a: Vector, b: Vector) -> Vector: ...
    @abstractmethod
    def maximum(self, a: Vector, b: Vector) -> Vector: ...

    @abstractmethod
    def where(self, condition: Condition, a: Scalar, b: Scalar) -> Scalar:
        """``a`` where the comparison holds, ``b`` elsewhere."""

    @abstractmethod
    def vector(self, *parts: Vector) -> Vector:
        """Scalars and vectors one after the other."""

    @abstractmethod
    def size(self, a: Vector) -> int:
        """Entries of a vector; 1 for a scalar."""

    def tan(self, a: Vector) -> Vector:
        return self.sin(a) / self.cos(a)

    def tanh(self, a: Vector) -> Vector:
        # Of either sign the exponential grows no further than its argument allows.
        return 1.0 - 2.0 / (self.exp(2.0 * a) + 1.0)

    def dot(self, a: Vector, b: Vector) -> Scalar:
        """a · b."""
        return sum((a[i] * b[i] for i in range(1, self.size(a))), a[0] * b[0])

    def sumsqr(self, a: Vector) -> Scalar:
        """a · a."""
        return sum((a[i] ** 2 for i in range(1, self.size(a))), a[0] ** 2)

    def norm(self, a: Vector) -> Scalar:
        """√(a · a), which has no slope at zero."""
        return self.sqrt(self.sumsqr(a))

    def cross(self, a: Vector, b: Vector) -> Vector:
        """a × b (3,)."""
        return self.vector(
            a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
        )

    def matvec(self, rows: Sequence[Any], v: Vector) -> Vector:
        """A v, A given by its rows: nested lists, a NumPy matrix, or a list of vectors."""
        return self.vector(*(self.dot(row, v) for row in rows))

    def rotate_plane(self, angle: Scalar, v: Vector) -> Vector:
        """v (2,) turned by ``angle`` from x to y."""
        c, s = self.cos(angle), self.sin(angle)
        return self.vector(c * v[0] - s * v[1], s * v[0] + c * v[1])

    def rotate(self, q: Vector, v: Vector) -> Vector:
        """R(q) v, body → inertial for q_IB: Hamilton, scalar first; R normalises."""
        e = q[1:4]
        twice = self.cross(e, v) * (2.0 / self.sumsqr(q))
        return v + q[0] * twice + self.cross(e, twice)

    def unrotate(self, q: Vector, v: Vector) -> Vector:
        """R(q)ᵀ v, inertial → body for q_IB."""
        return self.rotate(self.vector(q[0], -q[1:4]), v)

    def quaternion_rate(self, q: Vector, w_body: Vector) -> Vector:
        """q̇ = ½ q ⊗ (0, ω), ω in body axes."""
        e = q[1:4]
        vector = q[0] * w_body + self.cross(e, w_body)
        return self.vector(-0.5 * self.dot(e, w_body), 0.5 * vector)


class NumPyNamespace(Namespace):
    """Plain numbers, one instant at a time."""

    def sin(self, a: Vector) -> Vector:
        return np.sin(a)

    def cos(self, a: Vector) -> Vector:
        return np.cos(a)

    def exp(self, a: Vector) -> Vector:
        return np.exp(a)

    def log(self, a: Vector) -> Vector:
        return np.log(a)

    def sqrt(self, a: Vector) -> Vector:
        return np.sqrt(a)

    def arctan(self, a: Vector) -> Vector:
        return np.arctan(a)

    def arctan2(self, y: Vector, x: Vector) -> Vector:
        return np.arctan2(y, x)

    def abs(self, a: Vector) -> Vector:
        return np.abs(a)

    def minimum(self, a: Vector, b: Vector) -> Vector:
        return np.minimum(a, b)

    def maximum(self, a: Vector, b: Vector) -> Vector:
        return np.maximum(a, b)

    def where(self, condition: Condition, a: Scalar, b: Scalar) -> Scalar:
        chosen: Vector = np.where(condition, a, b)
        return chosen[()]

    def vector(self, *parts: Vector) -> Vector:
        return np.concatenate([np.atleast_1d(np.asarray(p, dtype=np.float64)) for p in parts])

    def size(self, a: Vector) -> int:
        return int(np.size(a))


NUMPY = NumPyNamespace()
