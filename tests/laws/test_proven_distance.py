"""What ``berthing.distance`` says of any pair holds by the sets' own support and levels."""

from __future__ import annotations

import numpy as np
from benchmarks._distance_poses import random_poses

from berthing.clearance.placed_distance import distance
from berthing.geometry.convex_set import ConvexSet
from support.distances import faults

COUNT = 12


def test_answers_are_proven(pair: tuple[ConvexSet, ConvexSet], rng: np.random.Generator) -> None:
    a, b = pair
    poses = random_poses(rng, a, b, COUNT)
    assert faults(distance(a, b, poses), a, poses[0], b, poses[1]) == []
