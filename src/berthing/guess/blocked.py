"""Whether a guess leads through things, too deeply to be pushed out of them, or far around them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from berthing.clearance.along import distances_along
from berthing.geometry.pose import Pose
from berthing.guess.nearby import pose_of
from berthing.guess.path import Guess
from berthing.scenario.pair import Pair
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion

DEPTH = 0.1
"""Of the smaller part's radius: the overlap up to which a guess counts as clear. Going past a
thing by no more than it takes cuts its corners by less."""


DETOUR = 2.0
"""Lengths of the straight way, beyond which a path leads far around."""


def is_detour(guess: Guess) -> bool:
    """Whether the path of a vehicle is so much longer than the straight one."""
    for path in guess.paths.values():
        r = path.positions_m
        length_m = float(np.sum(np.linalg.norm(np.diff(r, axis=0), axis=1)))
        if length_m > DETOUR * float(np.linalg.norm(r[-1] - r[0])):
            return True
    return False


def is_blocked(pairs: Sequence[Pair], mesh: Mesh, motion: Motion) -> bool:
    """Whether parts of a pair overlap by more than ``DEPTH`` at a point of ``mesh``.

    Margins do not count, nor that a pair may touch.
    """
    times = motion.duration_s * mesh.point_fractions()
    owners: dict[str, Pose] = {}
    for pair in pairs:
        for owner in (pair.owner_a, pair.owner_b):
            if owner.name not in owners:
                owners[owner.name] = pose_of(owner, motion.states, times)
        a, b = pair.part_a, pair.part_b
        allowed_m = DEPTH * min(a.shape.bounding_radius, b.shape.bounding_radius)
        body_a, body_b = owners[pair.owner_a.name], owners[pair.owner_b.name]
        if np.any(distances_along(a, body_a, b, body_b, -allowed_m) < -allowed_m):
            return True
    return False
