"""What a phase minimises."""

from __future__ import annotations

import math
from dataclasses import dataclass

from berthing.errors import InputError
from berthing.scenario.user_function import UserFunction


@dataclass(frozen=True, eq=False)
class RunningCost:
    """The paper's h(x, u, t) of one vehicle (eq. cost-func), the user's own.

    Attributes:
        vehicle: whose state and control it takes.
        function: one value.
        scale: its usual size, which conditions the solver and changes nothing else.

    Raises:
        InputError: a scale that is not positive.
    """

    vehicle: str
    function: UserFunction
    scale: float = 1.0

    def __post_init__(self) -> None:
        if not (math.isfinite(self.scale) and self.scale > 0.0):
            raise InputError("scale", f"is {self.scale}", "a positive number")


@dataclass(frozen=True)
class Cost:
    """J = ∫ (control_energy ‖u‖² + time + Σ h) dt in physical units.

    The paper's index in its examples is (1, 0). It mixes N² with (N·m)², and is energy rather
    than fuel.

    Attributes:
        control_energy, time: weights.
        running: costs h of the user's own, added up.

    Raises:
        InputError: a weight negative or not finite, or nothing to minimise.
    """

    control_energy: float = 1.0
    time: float = 0.0
    running: tuple[RunningCost, ...] = ()

    def __post_init__(self) -> None:
        for name in ("control_energy", "time"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value >= 0.0):
                raise InputError(name, f"is {value}", "a number that is not negative")
        object.__setattr__(self, "running", tuple(self.running))
        if self.control_energy == 0.0 and self.time == 0.0 and not self.running:
            raise InputError("cost", "has no weight above zero", "something to minimise")
