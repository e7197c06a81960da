"""New states where the legs of a path come too near something."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from berthing.geometry.arrays import Array
from berthing.routes.sliding import Slider
from berthing.routes.space import between

ROUNDS = 8

# New states are not put nearer to a leg's end than this share of it.
NEAREST = 0.05

# How much less than the pad a leg may keep that is not proven, in steps of the search: legs between
# states that touch cut corners.
LAX = 0.1


def refined(slides: Slider, path: Array, worst: Mapping[int, float]) -> Array | None:
    """With a new state in each leg that fails, settled; None where one could not be pushed out.

    Args:
        path: states (n + 1, V, 7).
        worst: by number of the leg that fails, the fraction where.
    """
    pieces = []
    for leg in range(len(path) - 1):
        pieces.append(path[leg : leg + 1])
        if leg in worst:
            at = float(np.clip(worst[leg], NEAREST, 1.0 - NEAREST))
            state = slides.settled(between(path[leg], path[leg + 1], np.array([at]))[0])
            if state is None:
                return None
            pieces.append(state[None])
    return np.concatenate([*pieces, path[-1:]])


def sampled(slides: Slider, path: Array) -> Array | None:
    """The path with what new states it takes for its legs to be clear at samples; None where
    these do not help. Nothing is proven of it."""
    for _ in range(ROUNDS):
        worst = {
            leg: at
            for leg in range(len(path) - 1)
            if (at := slides.blocked(path[leg], path[leg + 1], lax=LAX)) is not None
        }
        if not worst:
            return path
        more = refined(slides, path, worst)
        if more is None:
            return None
        path = more
    return None
