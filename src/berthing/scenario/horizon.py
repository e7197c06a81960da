"""How long a phase lasts."""

from __future__ import annotations

import math
from dataclasses import dataclass

from berthing.errors import InputError


@dataclass(frozen=True)
class Horizon:
    """Duration of a phase: fixed where ``min_s == max_s``, free between the two otherwise.

    Raises:
        InputError: a bound not positive or not finite, or min above max.
    """

    min_s: float
    max_s: float

    def __post_init__(self) -> None:
        if not (0.0 < self.min_s <= self.max_s < math.inf):
            found = f"runs from {self.min_s} to {self.max_s} s"
            raise InputError("horizon", found, "0 < min_s <= max_s, both finite")

    @staticmethod
    def fixed(duration_s: float) -> Horizon:
        """A horizon of exactly this length."""
        return Horizon(duration_s, duration_s)

    @property
    def is_free(self) -> bool:
        """Whether the duration is for the solver to choose."""
        return self.min_s < self.max_s

    @property
    def nominal_s(self) -> float:
        """The duration where it is fixed; the geometric mean of the bounds where it is free."""
        return math.sqrt(self.min_s * self.max_s) if self.is_free else self.min_s
