"""Which steps count as progress: less infeasibility or less objective, and never back.

The filter of Wächter and Biegler, 10.1007/s10107-004-0559-y, with their numbers.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

FEASIBILITY_SHARE, OBJECTIVE_SHARE = 1e-5, 1e-8
"""γ_θ, γ_φ: progress that counts, as a share of the infeasibility."""

ARMIJO = 1e-8
"""η_φ: share of the promised descent that is asked for."""

FEASIBILITY_POWER, SLOPE_POWER = 1.1, 2.3
"""s_θ, s_φ of the switching condition."""

LEAST, MOST = 1e-4, 1e4
"""Infeasibility, as a share of the first, below which descent may be asked for, and the most."""

ROUNDING = 10.0 * 2.2e-16
"""Objectives that differ by less than this share of themselves are equal."""


@dataclass(frozen=True)
class Merit:
    """Infeasibility θ and objective φ, barrier included, of a point."""

    theta: float
    phi: float

    @property
    def finite(self) -> bool:
        return math.isfinite(self.theta) and math.isfinite(self.phi)


@dataclass
class Filter:
    """Pairs (θ, φ) that no later point may be worse than in both."""

    first_theta: float
    _pairs: list[Merit] = field(default_factory=list)

    def clear(self) -> None:
        """Forget: φ means something else from now on."""
        self._pairs.clear()

    def admits(self, there: Merit) -> bool:
        """Whether no pair, nor the limit on infeasibility, shuts the point out."""
        return (
            there.finite
            and there.theta <= MOST * max(1.0, self.first_theta)
            and all(there.theta < p.theta or there.phi < p.phi for p in self._pairs)
        )

    def takes(self, here: Merit, there: Merit, length: float, slope: float) -> bool:
        """Whether a step from ``here`` is taken; remembers ``here`` where it should.

        Args:
            length: of the step, in (0, 1].
            slope: of φ along the full step.
        """
        if not self.admits(there):
            return False
        rounding = ROUNDING * abs(here.phi)
        descent = there.phi <= here.phi + ARMIJO * length * slope + rounding
        if self._descends(here, length, slope):
            return descent
        progress = (
            there.theta <= (1.0 - FEASIBILITY_SHARE) * here.theta
            or there.phi <= here.phi - OBJECTIVE_SHARE * here.theta + rounding
        )
        if progress:
            self.remember(here)
        return progress

    def remember(self, here: Merit) -> None:
        """Shut out points that are hardly better than ``here``."""
        self._pairs.append(
            Merit((1.0 - FEASIBILITY_SHARE) * here.theta, here.phi - OBJECTIVE_SHARE * here.theta)
        )

    def _descends(self, here: Merit, length: float, slope: float) -> bool:
        """Whether the step is one of descent: feasible enough, and steep enough."""
        if slope >= 0.0 or here.theta > LEAST * max(1.0, self.first_theta):
            return False
        return bool(length * (-slope) ** SLOPE_POWER > here.theta**FEASIBILITY_POWER)
