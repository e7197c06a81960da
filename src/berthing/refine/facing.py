"""How the best plane of a pair turns, seen from either body.

A face that meets a vertex or an edge keeps its normal in its own body's frame, and the clearance is
smooth: nothing is gained by a plane that holds for two instants, and a plane fixed in the other
body's frame would cost the face's length times the angle turned. Where the normal turns in both
frames, two vertices or edges meet, and only a shared plane keeps a solution from stepping through.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from berthing.guess.normals import exact_normals
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.transcription.extract import trajectories
from berthing.transcription.problem import Motion, Problem

PROBES = 5
"""Instants at which normals are compared."""

Turn = Callable[[int, float, float], float]
"""(pair, two fractions of the phase) → angle (rad) that the best normal turns by meanwhile, in the
frame of the body in which it turns less."""


def least_turn(scenario: Scenario, problem: Problem, motion: Motion) -> Turn:
    """The turning along ``motion``, a motion of ``problem``."""
    trajectory = trajectories(problem, motion)
    normals = exact_normals(problem.pairs)

    def turn(pair: int, begin: float, end: float) -> float:
        between = np.clip(np.linspace(begin, end, PROBES), 0.0, 1.0)
        t = trajectory.t0_s + motion.duration_s * between
        parts = problem.pairs[pair]
        poses = [
            (
                scenario.structure(owner.name).motion.pose(t)
                if isinstance(owner, Structure)
                else owner.model.pose(trajectory.vehicle(owner.name).state(t))
            ).compose(part.placement)
            for owner, part in ((parts.owner_a, parts.part_a), (parts.owner_b, parts.part_b))
        ]
        world = normals(pair, *poses)
        own = [pose.unrotate(world) for pose in poses]
        return float(min(np.max(np.linalg.norm(n - n[0], axis=-1)) for n in own))

    return turn
