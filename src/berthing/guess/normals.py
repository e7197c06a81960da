"""Normals that part the pairs of a scenario best, by exact distance queries."""

from __future__ import annotations

from collections.abc import Sequence

from berthing.clearance.separation import PairQuery
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.pair import Pair
from berthing.transcription.separation import Normals


def exact_normals(pairs: Sequence[Pair]) -> Normals:
    """The separating normal where the parts are apart, that of least penetration where not."""
    queries: dict[int, PairQuery] = {}

    def normals(pair: int, poses_a: Pose, poses_b: Pose) -> Array:
        if pair not in queries:
            parts = pairs[pair]
            queries[pair] = PairQuery(parts.part_a.shape, parts.part_b.shape)
        return queries[pair].batch(poses_a, poses_b)[1]

    return normals
