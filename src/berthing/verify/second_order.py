"""What is known of the second-order condition at an answer, by the solver's own derivatives."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any


@dataclass(frozen=True)
class SecondOrder:
    """The Hessian of the Lagrangian on the null space of what is active.

    Attributes:
        variables, rows: of the programme, without those of separation rows that do not pull.
        negative: curvatures below −``flat_below``; none at a minimum.
        flat: curvatures between −``flat_below`` and ``flat_below``, too small to have a sign.
        flat_below: in the solver's units, in which variables and cost are of order one.
        least: a power of ten that all curvatures are above; None where not all are positive.
    """

    variables: int
    rows: int
    negative: int
    flat: int
    flat_below: float
    least: float | None

    @property
    def minimum(self) -> bool:
        """Whether the sufficient condition for a strict local minimum of the programme holds."""
        return self.negative == 0 and self.flat == 0

    def to_json(self) -> dict[str, Any]:
        """As plan.json holds it."""
        return {**asdict(self), "minimum": self.minimum}
