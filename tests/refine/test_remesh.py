"""Segments are halved where the interpolant misses its own dynamics."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from berthing.refine.remesh import graded, split_unresolved
from berthing.scenario.phase import Phase
from berthing.trajectory import PhaseTrajectory
from berthing.transcription.extract import trajectories
from berthing.transcription.mesh import Mesh
from support.documents import puck, scenario
from support.solving import guessed, posed, solved


def bent_in_its_third() -> tuple[Mesh, Phase, PhaseTrajectory]:
    """Four segments, with a wave on top of one's position that the velocity knows nothing of."""
    found = solved(scenario(puck()), 4, 4)
    own = found.trajectory.vehicles[0]
    bent = own.segments[2].state.copy()
    bent[3, 0] += 0.05
    segments = (*own.segments[:2], replace(own.segments[2], state=bent), own.segments[3])
    wrong = replace(found.trajectory, vehicles=(replace(own, segments=segments),))
    return found.problem.mesh, found.problem.phase, wrong


def test_the_segment_that_is_wrong_is_halved_and_no_other() -> None:
    mesh, phase, wrong = bent_in_its_third()
    assert split_unresolved(mesh, phase, wrong) == mesh.split({2})


def test_as_many_segments_as_asked_for_gather_where_the_motion_is_wrong() -> None:
    mesh, phase, wrong = bent_in_its_third()
    assert graded(mesh, phase, wrong, 4) == mesh
    # Halves of it are the next worst.
    assert graded(mesh, phase, wrong, 7) == mesh.split({2}).split({2, 3})


def test_segments_that_are_equally_wrong_are_halved_together() -> None:
    problem = posed(scenario(puck()), 4, 4, sites=[])
    motion = guessed(problem)
    # Coasting controls under accelerating states: all segments miss the force alike at the ends.
    finer = split_unresolved(problem.mesh, problem.phase, trajectories(problem, motion))
    assert {0.125, 0.875} <= set(np.round(finer.breaks, 9))
    assert finer.segments > 5
