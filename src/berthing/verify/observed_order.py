"""The order at which a cost settles as its mesh is refined, from costs on meshes twice halved."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

RESOLVED = 1e-10
"""Of the cost. Solves to 1e-10 leave errors that are nearly the same on all three meshes: on
Scenario A moves of 1e-12 still show the order that they should."""


@dataclass(frozen=True)
class Study:
    """The cost on one mesh, with every segment halved, and halved again.

    Attributes:
        degree: of the polynomials on each segment.
        expected: the order where the motion is smooth between breaks: one more than the degree up
            to which the nodes' quadrature is exact.
        segments, costs: of the three meshes, rows of separation where they are.
    """

    degree: int
    expected: int
    segments: tuple[int, int, int]
    costs: tuple[float, float, float]

    @property
    def moves(self) -> tuple[float, float]:
        """|J_h − J_h/2| and |J_h/2 − J_h/4| as shares of the cost."""
        first, second, third = self.costs
        scale = max(abs(third), 1e-300)
        return abs(first - second) / scale, abs(second - third) / scale

    @property
    def order(self) -> float | None:
        """p where the cost's error falls as the width of segments to the power p; None where
        the moves are too small to tell it from what solves leave."""
        wide, narrow = self.moves
        return math.log2(wide / narrow) if min(wide, narrow) >= RESOLVED else None

    def to_json(self) -> dict[str, Any]:
        """As plan.json holds it."""
        return {
            "degree": self.degree,
            "expected_order": self.expected,
            "segments": list(self.segments),
            "costs": list(self.costs),
            "moves": list(self.moves),
            "order": self.order,
        }


@dataclass(frozen=True)
class OrderCheck:
    """How fast the cost settles.

    Attributes:
        own: on the plan's mesh, with its degree: how well its cost is known.
        shown: the study that shows an order, of the highest degree that does: high degrees leave
            nothing to see, the mesh being fine enough for rounding. None where none does.
    """

    own: Study
    shown: Study | None

    @property
    def order(self) -> float | None:
        """That of ``shown``."""
        return None if self.shown is None else self.shown.order

    def to_json(self) -> dict[str, Any]:
        """As plan.json holds it."""
        return {
            "own_mesh": self.own.to_json(),
            "shown_by": None if self.shown is None else self.shown.to_json(),
        }
