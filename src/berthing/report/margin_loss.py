"""What keeping further away than asked for costs."""

from __future__ import annotations

import math

from berthing.trajectory import Plan
from berthing.verify.verification import Verification


def cost_lost(plan: Plan, verification: Verification) -> float | None:
    """About how much of the cost the back-off and the tube take; None where it is not known.

    From the slope of the least cost in the margins. A tube asks for as much back-off, so that both
    count alike.
    """
    if plan.cost_per_margin is None or not math.isfinite(verification.tube_m):
        return None
    return plan.cost_per_margin * (plan.backoff_m + verification.tube_m)
