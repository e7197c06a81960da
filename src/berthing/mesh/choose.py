"""Which outer bound each part gets: volume is spent where it saves most faces."""

from __future__ import annotations

from collections.abc import Sequence

from berthing.mesh.fit import Fit


def chosen(options: Sequence[Sequence[Fit]], volume_m3: float) -> list[Fit]:
    """One fit a part, the sum of their volumes at most ``volume_m3`` where that can be.

    Args:
        options: of each part, the tightest first, each cheaper than the one before.
        volume_m3: the budget.
    """
    taken = [0] * len(options)
    spare = volume_m3 - sum(fits[0].volume for fits in options)
    while True:
        steps = [
            (gain, i, k)
            for i, fits in enumerate(options)
            for k in range(taken[i] + 1, len(fits))
            if (gain := _gain(fits[taken[i]], fits[k], spare)) is not None
        ]
        if not steps:
            return [fits[k] for fits, k in zip(options, taken, strict=True)]
        _, i, k = max(steps)
        spare -= options[i][k].volume - options[i][taken[i]].volume
        taken[i] = k


def _gain(now: Fit, then: Fit, spare: float) -> float | None:
    """Faces saved for each m³ added; None where the budget does not allow it."""
    added = then.volume - now.volume
    return None if added > spare else (now.cost - then.cost) / max(added, 1e-300)
