"""The one array type of the package, and the coercions that guard its borders."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from berthing.errors import InputError

Array = npt.NDArray[np.float64]


def as_array(value: npt.ArrayLike, shape: tuple[int | None, ...], where: str) -> Array:
    """Return ``value`` as a read-only float64 array of the given shape.

    Args:
        value: anything NumPy can read.
        shape: the lengths wanted; None stands for any length.
        where: the name used in the error.

    Raises:
        InputError: wrong shape, or an entry that is not finite.
    """
    wanted = "×".join("n" if n is None else str(n) for n in shape) or "a single number"
    try:
        array = np.array(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(where, "is not an array of numbers", wanted) from None
    fits = array.ndim == len(shape) and all(
        n is None or n == m for n, m in zip(shape, array.shape, strict=True)
    )
    if not fits:
        found = "×".join(map(str, array.shape)) or "a single number"
        raise InputError(where, f"has the shape {found}", wanted)
    if not np.all(np.isfinite(array)):
        raise InputError(where, "contains NaN or an infinite value", "finite numbers")
    array.setflags(write=False)
    return array


def skew(v: Array) -> Array:
    """Cross-product matrix: ``skew(v) @ w == cross(v, w)``; v (..., 3) → (..., 3, 3)."""
    matrix = np.zeros((*v.shape[:-1], 3, 3))
    matrix[..., 0, 1], matrix[..., 0, 2] = -v[..., 2], v[..., 1]
    matrix[..., 1, 0], matrix[..., 1, 2] = v[..., 2], -v[..., 0]
    matrix[..., 2, 0], matrix[..., 2, 1] = -v[..., 1], v[..., 0]
    return matrix
