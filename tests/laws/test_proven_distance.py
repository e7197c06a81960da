"""What ``berthing.distance`` says of any pair holds by the sets' own support and levels."""

from __future__ import annotations

import numpy as np

from berthing.clearance.placed_distance import distance
from berthing.clearance.set_numbers import set_numbers
from berthing.geometry.convex_set import ConvexSet
from support.distances import faults, random_poses

COUNT = 12


def test_answers_are_proven(pair: tuple[ConvexSet, ConvexSet], rng: np.random.Generator) -> None:
    a, b = pair
    compiled = all(set_numbers(shape) is not None for shape in pair)
    poses = random_poses(rng, a, b, COUNT if compiled else 1)
    wrong = faults(distance(a, b, poses), a, poses[0], b, poses[1])
    if not compiled:
        # Where those overlap, nothing is proven from inside.
        wrong = [fault for fault in wrong if not fault.startswith("bounds too far apart")]
    assert wrong == []
