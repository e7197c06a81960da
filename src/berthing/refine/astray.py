"""Answers that step through things between their rows, from which nothing sound comes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from berthing.refine.sampling import SampledClearance
from berthing.scenario.pair import Pair

ASTRAY = 0.05
"""Of the smaller part's radius: pairs that overlap more deeply than this are stepped through. Sound
answers overlap by less than 0.01 before they are refined, those that cut a corner or pass through a
wall by 0.09 to 0.95."""


def astray(pairs: Sequence[Pair], sampled: SampledClearance) -> bool:
    """Whether a motion steps through something that it may not touch: the next answer from there
    may be in any passage."""
    for pair, distances, margins in zip(pairs, sampled.distances_m, sampled.margins_m, strict=True):
        radius_m = min(pair.part_a.shape.bounding_radius, pair.part_b.shape.bounding_radius)
        if np.any(distances[~np.isnan(margins)] < -ASTRAY * radius_m):
            return True
    return False
