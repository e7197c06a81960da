"""Bounds on controls and states."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array


@dataclass(frozen=True, eq=False)
class Limits:
    """Componentwise bounds in native units; infinite where there is none.

    Attributes:
        control_lower, control_upper: (nu,), in the order of the model's ``control_names``.
        state_lower, state_upper: (nx,), likewise ``state_names``.

    Raises:
        InputError: NaN, lengths that differ, or a lower bound above its upper one.
    """

    control_lower: Array
    control_upper: Array
    state_lower: Array
    state_upper: Array

    def __post_init__(self) -> None:
        for kind in ("control", "state"):
            lower, upper = (
                np.array(getattr(self, f"{kind}_{end}"), dtype=np.float64)
                for end in ("lower", "upper")
            )
            if lower.ndim != 1 or lower.shape != upper.shape:
                raise InputError(f"{kind} limits", "differ in length", "two lists of one length")
            if not np.all(lower <= upper):
                raise InputError(f"{kind} limits", "have a lower bound above the upper, or NaN")
            for end, value in (("lower", lower), ("upper", upper)):
                value.setflags(write=False)
                object.__setattr__(self, f"{kind}_{end}", value)

    @staticmethod
    def unbounded(nx: int, nu: int) -> Limits:
        """No bounds at all."""
        inf = np.inf
        return Limits(np.full(nu, -inf), np.full(nu, inf), np.full(nx, -inf), np.full(nx, inf))
