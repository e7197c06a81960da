"""What every convex set of the package can do, whatever its shape."""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array

DIMENSIONS = (2, 3)


class ConvexSet(ABC):
    """A closed convex set in its own frame, in two or three dimensions.

    Compact, but for the half-space: its support value is +∞ in all directions but one, and so is
    its bounding radius.

    A set is fully described by its support function; what else a set may offer (a conic form,
    vertices, half-spaces, a level function, a mesh) is asked for in ``capability``.
    Members are frozen dataclasses, compared and hashed by identity, so they may key a cache.
    """

    @property
    @abstractmethod
    def dim(self) -> int:
        """2 or 3."""

    @abstractmethod
    def support(self, n: Array) -> tuple[Array, Array]:
        """Support function h(n) = max n·x over the set, and a point that attains it.

        Args:
            n: directions (..., dim) in the set's own frame; of any length, zero included.
                h is homogeneous: h(c n) = c h(n) for c ≥ 0.

        Returns:
            values (...), in metres times the length of ``n``, and members of the set (..., dim)
            in metres; where no closed form is known, the value is an upper bound, and both are
            within 1e-9 of the set's size.

        Raises:
            InputError: the last axis of ``n`` is not ``dim``.
        """

    @property
    @abstractmethod
    def bounding_radius(self) -> float:
        """sup |x| over the set, about its own origin, in metres.

        Never less; where no closed form is known, up to 0.1% more.
        """


TINY = 1e-200
"""A square above this has lost nothing to underflow, which begins at 1e-308."""


def last_axis(x: Array, dim: int, where: str) -> Array:
    """``x`` as float64, its last axis checked to be ``dim``; InputError where it is not."""
    array = np.asarray(x, dtype=np.float64)
    if array.ndim == 0 or array.shape[-1] != dim:
        raise InputError(where, f"has the shape {array.shape}", f"a last axis of {dim}")
    return array


def unit(v: Array) -> Array:
    """v / |v| along the last axis; zero stays zero.

    Where squares would underflow or overflow, the largest entry is divided by first.
    """
    square = np.einsum("...i,...i->...", v, v)
    if square.size and np.min(square) > TINY and np.max(square) < 1.0 / TINY:
        return np.asarray(v / np.sqrt(square)[..., None])
    largest = np.max(np.abs(v), axis=-1, keepdims=True)
    scaled = np.divide(v, largest, out=np.zeros_like(v), where=largest > 0.0)
    length = np.sqrt(np.sum(scaled * scaled, axis=-1, keepdims=True))
    return np.asarray(np.divide(scaled, length, out=np.zeros_like(v), where=length > 0.0))


def norm(v: Array) -> Array:
    """Euclidean length (...) of v (..., k)."""
    return np.asarray(np.sqrt(np.einsum("...i,...i->...", v, v)))


def positive(value: float, where: str) -> float:
    """``value`` as a float; InputError unless it is finite and above zero."""
    number = finite(value, where)
    if number <= 0.0:
        raise InputError(where, f"is {number:g}", "a number above zero, in metres")
    return number


def finite(value: float, where: str) -> float:
    """``value`` as a float; InputError unless it is a finite number."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise InputError(where, f"is {value!r}", "a number") from None
    if not np.isfinite(number):
        raise InputError(where, f"is {number}", "a finite number")
    return number


def positive_sizes(values: Array, where: str) -> Array:
    """``values`` as a read-only (2,) or (3,) array of positive sizes in metres, or InputError."""
    try:
        sizes = np.array(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(where, "is not an array of numbers", "2 or 3 sizes in metres") from None
    if sizes.ndim != 1 or len(sizes) not in DIMENSIONS:
        raise InputError(where, f"has the shape {sizes.shape}", "2 or 3 sizes in metres")
    for i, size in enumerate(sizes):
        positive(float(size), f"{where}[{i}]")
    sizes.setflags(write=False)
    return sizes
