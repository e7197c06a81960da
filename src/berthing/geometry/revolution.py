"""What bodies of revolution about one of their own axes share."""

from __future__ import annotations

from typing import Literal

from berthing.errors import InputError
from berthing.geometry.arrays import Array

Axis = Literal["x", "y", "z"]
AXES: tuple[str, ...] = ("x", "y", "z")


def axis_index(axis: str, dim: int, where: str) -> int:
    """0, 1 or 2; InputError for another axis than the dimension has."""
    options = AXES[:dim]
    if axis not in options:
        raise InputError(where, f"is {axis!r}", " or ".join([", ".join(options[:-1]), options[-1]]))
    return AXES.index(axis)


def split(v: Array, index: int) -> tuple[Array, Array]:
    """The component along the axis (...), and v with that component set to zero (..., d)."""
    across = v.copy()
    across[..., index] = 0.0
    return v[..., index], across
