"""Whether the pieces of a trajectory make one motion on the scenario's clock."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from berthing.scenario.scenario import Scenario
from berthing.trajectory import PhaseTrajectory, Segment, VehicleTrajectory
from berthing.verify.chebyshev import at_end, at_start
from berthing.verify.settings import CONTINUITY_TOLERANCE, TIME_TOLERANCE


def clock_faults(scenario: Scenario, phases: tuple[PhaseTrajectory, ...]) -> list[str]:
    """Phases that do not follow each other from 0, or do not last as long as they should."""
    found = []
    expected = 0.0
    for phase, trajectory in zip(scenario.phases, phases, strict=True):
        for own in trajectory.vehicles:
            where = f"clock[{phase.name}, {own.vehicle}]"
            if abs(own.t0_s - expected) > TIME_TOLERANCE:
                found.append(f"{where}: begins at {own.t0_s:.9g} s, not at {expected:.9g} s")
            if own.t0_s != trajectory.t0_s or own.t1_s != trajectory.t1_s:
                found.append(f"{where}: does not share the clock of the other vehicles")
            span, horizon = own.t1_s - own.t0_s, phase.horizon
            tolerance = TIME_TOLERANCE * max(1.0, horizon.max_s)
            if not horizon.min_s - tolerance <= span <= horizon.max_s + tolerance:
                found.append(
                    f"{where}: lasts {span:.9g} s, not {horizon.min_s:g} to {horizon.max_s:g} s"
                )
        expected = trajectory.t1_s
    return found


def gap_faults(trajectory: VehicleTrajectory) -> list[str]:
    """Segments that run backwards or do not begin exactly where the last one ended."""
    found = []
    for segment in trajectory.segments:
        if not segment.t0_s < segment.t1_s:
            found.append(f"{_name(trajectory, segment)} ends at {segment.t1_s:.9g} s")
    for before, after in pairwise(trajectory.segments):
        if before.t1_s != after.t0_s:
            found.append(
                f"{_name(trajectory, after)} begins where none ends; the last ended at "
                f"{before.t1_s:.17g} s"
            )
    return found


def continuity_faults(trajectory: VehicleTrajectory) -> list[str]:
    """The same, and breaks at which the state jumps."""
    found = gap_faults(trajectory)
    for before, after in pairwise(trajectory.segments):
        jump = _jump(trajectory, before, after)
        if jump:
            found.append(f"{_name(trajectory, after)}: {jump}")
    return found


def linkage_faults(before: PhaseTrajectory, after: PhaseTrajectory) -> list[str]:
    """Vehicles whose native state jumps from one phase to the next."""
    found = []
    earlier = {own.vehicle: own for own in before.vehicles}
    for own in after.vehicles:
        last = earlier.get(own.vehicle)
        if last is not None and last.state_names == own.state_names:
            jump = _jump(own, last.segments[-1], own.segments[0])
            if jump:
                found.append(f"linkage[{own.vehicle}, {before.phase} to {after.phase}]: {jump}")
    return found


def _jump(trajectory: VehicleTrajectory, before: Segment, after: Segment) -> str:
    """The component that jumps most; empty where none does."""
    jump = np.abs(at_start(after.state) - at_end(before.state))
    if np.max(jump) <= CONTINUITY_TOLERANCE:
        return ""
    worst = int(np.argmax(jump))
    return f"{trajectory.state_names[worst]} jumps by {jump[worst]:.3g}"


def _name(trajectory: VehicleTrajectory, segment: Segment) -> str:
    return f"segment[{trajectory.vehicle}, t = {segment.t0_s:.9g} s]"
