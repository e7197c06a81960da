"""Segments are halved where the interpolant misses its own dynamics."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from berthing.refine.remesh import split_unresolved
from berthing.transcription.extract import trajectories
from support.documents import puck, scenario
from support.solving import guessed, posed, solved


def test_the_segment_that_is_wrong_is_halved_and_no_other() -> None:
    found = solved(scenario(puck()), 4, 4)
    own = found.trajectory.vehicles[0]
    bent = own.segments[2].state.copy()
    # A wave on top of the position that the velocity knows nothing of.
    bent[3, 0] += 0.05
    segments = (*own.segments[:2], replace(own.segments[2], state=bent), own.segments[3])
    wrong = replace(found.trajectory, vehicles=(replace(own, segments=segments),))
    finer = split_unresolved(found.problem.mesh, found.problem.phase, wrong)
    assert finer == found.problem.mesh.split({2})


def test_segments_that_are_equally_wrong_are_halved_together() -> None:
    problem = posed(scenario(puck()), 4, 4, sites=[])
    motion = guessed(problem)
    # Coasting controls under accelerating states: all segments miss the force alike at the ends.
    finer = split_unresolved(problem.mesh, problem.phase, trajectories(problem, motion))
    assert {0.125, 0.875} <= set(np.round(finer.breaks, 9))
    assert finer.segments > 5
