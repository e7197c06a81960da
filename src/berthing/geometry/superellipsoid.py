"""The paper's superellipsoid: a sum of even powers of the coordinates."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import final

import numpy as np
import numpy.typing as npt
from scipy.optimize import brentq

from berthing.errors import InputError
from berthing.geometry.arrays import Array, as_array
from berthing.geometry.boundary_climb import Hill
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.convex_set import ConvexSet, last_axis, positive, positive_sizes
from berthing.geometry.mesh import Mesh, support_mesh
from berthing.geometry.power_form import power_form

# Newton's method for the multiplier: it converges from one side, in about six steps.
MAX_STEPS = 40
ROUNDING = 4e-16


@final
@dataclass(frozen=True, eq=False)
class Superellipsoid(ConvexSet):
    """{x : Σ_i (x_i / semi_axes_i)^exponents_i ≤ size^size_exponent}, the paper's eq. (c-func).

    With size 1 it reaches semi_axes_i along each axis. Exponents 2 make an ellipsoid; growing
    ones push the set towards its box.

    Attributes:
        semi_axes: a_i (2,) or (3,), the paper's shape factors, in metres.
        exponents: P_i, even, one an axis; a single one stands for all.
        size: l of the paper.
        size_exponent: P_{n+1}.

    Raises:
        InputError: sizes that are not positive and finite, exponents that are not even and
            positive.
    """

    semi_axes: Array
    exponents: npt.NDArray[np.int64]
    size: float = 1.0
    size_exponent: float = 2.0

    def __post_init__(self) -> None:
        where = "Superellipsoid"
        axes = positive_sizes(self.semi_axes, f"{where}.semi_axes")
        size = positive(self.size, f"{where}.size")
        power = positive(self.size_exponent, f"{where}.size_exponent")
        object.__setattr__(self, "semi_axes", axes)
        object.__setattr__(self, "exponents", _even(self.exponents, len(axes)))
        object.__setattr__(self, "size", size)
        object.__setattr__(self, "size_exponent", power)

    @property
    def dim(self) -> int:
        return len(self.semi_axes)

    @property
    def bound(self) -> float:
        """Right side of the inequality, size^size_exponent."""
        return float(self.size**self.size_exponent)

    @property
    def reaches(self) -> Array:
        """How far the set goes along each axis (dim,), in metres."""
        return np.asarray(self.semi_axes * self.bound ** (1.0 / self.exponents))

    @cached_property
    def bounding_radius(self) -> float:
        """|x|² = Σ r_i² t_i^(2/P_i), r_i the reaches and t_i ≥ 0 the terms, whose sum is 1.

        It is concave in t, so the largest value is where all marginal values (2/P_i) r_i²
        t_i^(2/P_i − 1) are equal. Those of exponent 2 are constant: they bound the common value
        from below, and the longest such axis takes what the others leave of the sum.
        """
        worth = 2.0 * self.reaches**2 / self.exponents
        curved = self.exponents > 2
        flat = float(np.max(worth[~curved], initial=0.0))
        power = self.exponents[curved] / (self.exponents[curved] - 2.0)

        def terms(price: float) -> Array:
            return np.asarray((worth[curved] / price) ** power)

        if not curved.any():
            return float(np.sqrt(flat))
        price = flat
        if flat == 0.0 or np.sum(terms(flat)) > 1.0:
            # Some term is 1 at the lower end, and all are at most an equal share at the upper.
            low = float(np.max(worth[curved]))
            high = float(np.max(worth[curved] * curved.sum() ** (1.0 / power)))
            price = brentq(lambda p: float(np.sum(terms(p))) - 1.0, low, high, xtol=1e-300)
        t = terms(price)
        rest = max(1.0 - float(np.sum(t)), 0.0) if price == flat else 0.0
        squares = self.reaches[curved] ** 2 * t ** (2.0 / self.exponents[curved])
        return float(np.sqrt(np.sum(squares) + rest * flat))

    def support(self, n: Array) -> tuple[Array, Array]:
        """By the multiplier λ of max n·x: each term is t_i = (k_i/λ)^q_i, q_i = P_i/(P_i − 1).

        With k_i = |n_i| r_i / P_i, the terms sum to 1 at one λ. The logarithm of the sum is convex
        and falling in s = ln λ, so Newton's method from below grows towards the root. Where all
        exponents are P it is linear and one step is exact: h(n) is the dual norm
        (Σ |n_i r_i|^q)^(1/q).
        """
        n = last_axis(n, self.dim, "Superellipsoid.support: n")
        k = np.abs(n) * self.reaches / self.exponents
        largest = np.max(k, axis=-1, keepdims=True)
        some = largest > 0.0
        with np.errstate(divide="ignore"):
            logs = np.log(np.divide(k, largest, out=np.zeros_like(k), where=some))
        logs = np.where(some, logs, 0.0)
        q = self.exponents / (self.exponents - 1.0)
        s = np.zeros(largest.shape)
        for _ in range(MAX_STEPS):
            terms = np.exp(q * (logs - s))
            total = np.sum(terms, axis=-1, keepdims=True)
            step = np.log(total) * total / np.sum(q * terms, axis=-1, keepdims=True)
            s = s + step
            if np.all(step <= ROUNDING * (1.0 + np.abs(s))):
                break
        terms = np.where(some, np.exp(q * (logs - s)), 0.0)
        point = np.sign(n) * self.reaches * terms ** (1.0 / self.exponents)
        return np.asarray(np.sum(n * point, axis=-1)), point

    def level(self, x: Array) -> Array:
        """Σ (x_i/a_i)^P_i − l^P_{n+1}, without unit."""
        x = last_axis(x, self.dim, "Superellipsoid.level: x")
        with np.errstate(over="ignore"):
            return np.asarray(np.sum((x / self.semi_axes) ** self.exponents, axis=-1) - self.bound)

    def level_gradient(self, x: Array) -> Array:
        """(..., dim), per metre: P_i (x_i/a_i)^(P_i − 1) / a_i."""
        x = last_axis(x, self.dim, "Superellipsoid.level_gradient: x")
        P, a = self.exponents, self.semi_axes
        with np.errstate(over="ignore"):
            return np.asarray(P / a * (x / a) ** (P - 1))

    def level_hessian(self, x: Array) -> Array:
        """(..., dim, dim), diagonal, per metre²: P_i (P_i − 1) (x_i/a_i)^(P_i − 2) / a_i²."""
        x = last_axis(x, self.dim, "Superellipsoid.level_hessian: x")
        P, a = self.exponents, self.semi_axes
        with np.errstate(over="ignore"):
            diagonal = P * (P - 1) / a**2 * (x / a) ** (P - 2)
        return np.asarray(diagonal[..., None] * np.eye(self.dim))

    def conic_form(self) -> ConicForm:
        """By repeated squaring, for exponents that are powers of two.

        Raises:
            CapabilityError: another exponent.
        """
        return power_form(self.reaches, self.exponents)

    @cached_property
    def hill(self) -> Hill:
        """What finds nearest points on the boundary."""
        return Hill(_Level(self), np.zeros(self.dim), 2.0 * self.bounding_radius)

    def mesh(self) -> Mesh:
        return support_mesh(self.support, self.dim)


@dataclass(frozen=True, eq=False)
class _Level:
    """The level function as one that is climbed on."""

    shape: Superellipsoid

    def all(self, x: Array) -> tuple[Array, Array, Array]:
        return self.shape.level(x), self.shape.level_gradient(x), self.shape.level_hessian(x)

    def along(self, x: Array, d: Array) -> tuple[Array, Array]:
        slope = np.sum(self.shape.level_gradient(x) * d, axis=-1)
        return self.shape.level(x), np.asarray(slope)


def _even(values: npt.ArrayLike, dim: int) -> npt.NDArray[np.int64]:
    where = "Superellipsoid.exponents"
    given = np.atleast_1d(values)
    each = np.broadcast_to(given, (dim,)) if given.shape == (1,) else given
    exponents = as_array(each, (dim,), where)
    for i, exponent in enumerate(exponents):
        if exponent < 2 or exponent % 2 != 0:
            raise InputError(f"{where}[{i}]", f"is {exponent:g}", "an even number, 2 or more")
    even = exponents.astype(np.int64)
    even.setflags(write=False)
    return even
