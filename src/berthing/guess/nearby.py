"""Which pairs the coarse problem has rows for: those that some guess, or an answer, brings near.

Cost grows with what is near, not with what exists. Leaving a pair out is no claim that it stays
clear: answers are sampled against all pairs, those that come too close are taken in, and what is
refined and certified knows every pair.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.body import Part
from berthing.geometry.pose import Pose
from berthing.scenario.pair import Pair
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion

ROOM = 0.25
"""Of the scenario's length: balls about the parts that stay further apart than this and the margin
on every guess are not near. Guesses go around things, so that detours are among them."""


def near_pairs(
    scenario: Scenario,
    pairs: Sequence[Pair],
    mesh: Mesh,
    motions: Iterable[Motion],
    within_m: float,
) -> set[int]:
    """Indices of the pairs whose bounding balls come within ``within_m`` beyond the margin in
    force, at a point of ``mesh``, on one of ``motions``.

    A pair that may touch for a while is judged by the default margin then.
    """
    found: set[int] = set()
    for motion in motions:
        times = motion.duration_s * mesh.point_fractions()
        owners: dict[str, Pose] = {}
        centres: dict[str, Array] = {}
        for i, pair in enumerate(pairs):
            if i in found:
                continue
            a = _centre(centres, owners, pair.ref_a, pair.owner_a, pair.part_a, motion, times)
            b = _centre(centres, owners, pair.ref_b, pair.owner_b, pair.part_b, motion, times)
            radii = pair.part_a.shape.bounding_radius + pair.part_b.shape.bounding_radius
            gap = float(np.min(np.linalg.norm(b - a, axis=-1))) - radii
            if gap <= scenario.margins.default_m + within_m:
                found.add(i)
    return found


def _centre(
    centres: dict[str, Array], owners: dict[str, Pose], ref: str, owner: Vehicle | Structure,
    part: Part, motion: Motion, times: Array,
) -> Array:  # fmt: skip
    """The middle of a part's ball at the times (k, d), worked out once a motion."""
    if ref not in centres:
        if owner.name not in owners:
            owners[owner.name] = pose_of(owner, motion.states, times)
        centres[ref] = owners[owner.name].apply(part.placement.position)
    return centres[ref]


def pose_of(owner: Vehicle | Structure, states: Mapping[str, Array], times: Array) -> Pose:
    """Of a body at the times (k,): a vehicle's from the states (nx, k) of a guess, by name."""
    if isinstance(owner, Structure):
        return owner.motion.pose(times)
    return owner.model.pose(states[owner.name].T)
