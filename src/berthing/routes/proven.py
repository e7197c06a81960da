"""From a path that is clear at samples to one whose every leg is certified."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.routes.checker import Checker
from berthing.routes.legs import Legs
from berthing.routes.sliding import Slider
from berthing.routes.space import between

ROUNDS = 8

# New states are not put nearer to a leg's end than this share of it.
NEAREST = 0.05


def proven(checker: Checker, slider: Slider, path: Array) -> tuple[Array, Legs]:
    """The path (n + 1, V, 7), and what is proven of it; certified if that could be had.

    Where a leg comes too near something, the state there is pushed out and the leg goes through
    it, a few times over.
    """
    legs = checker.legs(path)
    for _ in range(ROUNDS):
        if legs.certified:
            break
        refined = _refined(slider, path, legs)
        if refined is None:
            break
        path, legs = refined, checker.legs(refined)
    return path, legs


def _refined(slider: Slider, path: Array, legs: Legs) -> Array | None:
    """With a new state in each leg that fails; None where one could not be pushed out."""
    worst: dict[int, float] = {}
    for at in legs.trouble:
        leg = min(int(at), len(path) - 2)
        worst.setdefault(leg, float(np.clip(at - leg, NEAREST, 1.0 - NEAREST)))
    pieces = []
    for leg in range(len(path) - 1):
        pieces.append(path[leg : leg + 1])
        if leg in worst:
            middle = between(path[leg], path[leg + 1], np.array([worst[leg]]))[0]
            state = slider.settled(middle)
            if state is None:
                return None
            pieces.append(state[None])
    return np.concatenate([*pieces, path[-1:]])
