"""What a phase minimises."""

from __future__ import annotations

import math
from dataclasses import dataclass

from berthing.errors import InputError


@dataclass(frozen=True)
class Cost:
    """J = ∫ (control_energy ‖u‖² + time) dt in physical units.

    The paper's index is (1, 0). It mixes N² with (N·m)², and is energy rather than fuel.

    Raises:
        InputError: a weight negative or not finite, or both zero.
    """

    control_energy: float = 1.0
    time: float = 0.0

    def __post_init__(self) -> None:
        for name in ("control_energy", "time"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value >= 0.0):
                raise InputError(name, f"is {value}", "a number that is not negative")
        if self.control_energy == 0.0 and self.time == 0.0:
            raise InputError("cost", "has no weight above zero", "something to minimise")
