"""Pieces must make one motion on one clock."""

from dataclasses import replace

import numpy as np

from berthing.geometry.box import Box
from berthing.scenario.horizon import Horizon
from berthing.scenario.phase import Phase
from berthing.trajectory import PhaseTrajectory
from berthing.verify.continuity import (
    clock_faults,
    continuity_faults,
    gap_faults,
    linkage_faults,
)

CUBE = Box(np.ones(3))


def flown(make):
    own = make.vehicle(CUBE)
    return make.scenario([own], []), make.glide(own, (0, 0, 0), (3, 1, 0), 1.0)


def changed(trajectory, index: int, **changes):
    segments = list(trajectory.segments)
    segments[index] = replace(segments[index], **changes)
    return replace(trajectory, segments=tuple(segments))


def test_a_sound_trajectory(make) -> None:
    whole, own = flown(make)
    assert continuity_faults(own) == []
    assert clock_faults(whole, (PhaseTrajectory("main", (own,)),)) == []


def test_gaps_overlaps_and_reversed_segments(make) -> None:
    _, own = flown(make)
    assert "begins where none ends" in gap_faults(changed(own, 3, t1_s=3.9))[0]
    assert "begins where none ends" in gap_faults(changed(own, 3, t1_s=4.0 + 1e-12))[0]
    assert "ends at" in gap_faults(changed(own, 9, t1_s=8.0))[0]


def test_jumps(make) -> None:
    _, own = flown(make)
    shifted = own.segments[4].state.copy()
    shifted[0, 1] += 1e-5
    (first, second) = continuity_faults(changed(own, 4, state=shifted))
    assert "t = 4 s]: y_m jumps by 1e-05" in first
    assert "t = 5 s" in second
    shifted[0, 1] -= 9.5e-6
    assert continuity_faults(changed(own, 4, state=shifted)) == []


def test_the_clock(make) -> None:
    whole, own = flown(make)
    late = replace(
        own, segments=tuple(replace(s, t0_s=s.t0_s + 1, t1_s=s.t1_s + 1) for s in own.segments)
    )
    assert "begins at 1 s" in clock_faults(whole, (PhaseTrajectory("main", (late,)),))[0]
    slow = replace(
        own, segments=tuple(replace(s, t0_s=1.1 * s.t0_s, t1_s=1.1 * s.t1_s) for s in own.segments)
    )
    assert "lasts 11 s" in clock_faults(whole, (PhaseTrajectory("main", (slow,)),))[0]
    assert any(
        "share the clock" in fault
        for fault in clock_faults(whole, (PhaseTrajectory("main", (own, late)),))
    )
    free = replace(whole, phases=(replace(whole.phases[0], horizon=Horizon(5.0, 20.0)),))
    assert clock_faults(free, (PhaseTrajectory("main", (slow,)),)) == []


def test_phases_follow_each_other(make) -> None:
    whole, own = flown(make)
    phase = whole.phases[0]
    both = replace(whole, phases=(phase, Phase("next", phase.vehicles, phase.horizon)))
    later = replace(
        own, segments=tuple(replace(s, t0_s=s.t0_s + 10, t1_s=s.t1_s + 10) for s in own.segments)
    )
    trajectories = PhaseTrajectory("main", (own,)), PhaseTrajectory("next", (later,))
    assert clock_faults(both, trajectories) == []
    assert "jumps by 3" in linkage_faults(*trajectories)[0]
    assert "begins at 0 s" in clock_faults(both, (trajectories[0], trajectories[0]))[0]
