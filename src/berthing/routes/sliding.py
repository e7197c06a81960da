"""Pushing a state out of what it is too near to, so that a search slides along things."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.routes.checker import Checker
from berthing.routes.space import moved

ROUNDS = 8

# A state further in than this, in steps, is given up; a push aims beyond the pad by that share.
DEEP, BEYOND = 3.0, 0.4

# Singular values of the pushes below this share of the largest do not count.
RANK = 1e-3


class Slider:
    """Settles states at margin and pad, by Newton steps of least length on what is too near.

    Args:
        checker: of the scenario.
        pad_m: kept beyond every margin.
        step_m: of the search.
    """

    def __init__(self, checker: Checker, pad_m: float, step_m: float) -> None:
        self._checker, self._pad_m, self._deep_m = checker, pad_m, DEEP * step_m
        space = checker.space
        arms = np.where(space.arm_m > 0.0, space.arm_m, 1.0)
        # Turns by the metres that they move; components that there are not stay 0.
        self._scale = space.free / np.repeat(
            np.stack([np.ones_like(arms), arms], axis=1), 3, axis=1
        )

    def settled(self, x: Array) -> Array | None:
        """A state near ``x`` (V, 7) that keeps margins and pad; None where none was found."""
        space = self._checker.space
        for _ in range(ROUNDS):
            short, slopes = self._checker.short_of(x, self._pad_m)
            if not short:
                return x if space.within(x) else None
            if max(short) > self._deep_m:
                return None
            J = np.array(slopes) * self._scale
            wanted = np.array(short) + BEYOND * self._pad_m
            by = np.linalg.lstsq(J.reshape(len(short), -1), wanted, rcond=RANK)[0]
            x = moved(x, by.reshape(self._scale.shape) * self._scale)
            x[:, :3] = np.clip(x[:, :3], space.lower_m, space.upper_m)
        return x if self._checker.valid_state(x, self._pad_m) else None
