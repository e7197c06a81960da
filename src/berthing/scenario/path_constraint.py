"""The paper's g(x, u, t) ≤ 0 (eq. gen-const), the user's own."""

from __future__ import annotations

import math
from dataclasses import dataclass

from berthing.errors import InputError
from berthing.scenario.user_function import UserFunction


@dataclass(frozen=True, eq=False)
class PathConstraint:
    """Rows that one vehicle keeps at or below zero at every instant.

    The solver asks for them at its nodes; the check proves them between the nodes too.

    Attributes:
        name: unique in its vehicle.
        function: one value a row, as many at all times.
        tolerance: a row above zero by no more is no fault, in its own unit.
        scale: the usual size of the rows, which conditions the solver and changes nothing else.

    Raises:
        InputError: a tolerance or scale that is not positive.
    """

    name: str
    function: UserFunction
    tolerance: float = 1e-4
    scale: float = 1.0

    def __post_init__(self) -> None:
        for key in ("tolerance", "scale"):
            value = getattr(self, key)
            if not (math.isfinite(value) and value > 0.0):
                raise InputError(key, f"is {value}", "a positive number")
