"""Distances of pairs over time, sampled for drawing; what is proven is in the verification."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from berthing.clearance.separation import PairQuery
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.trajectory import PhaseTrajectory, Plan

# Samples of one phase.
SAMPLES = 160


@dataclass(frozen=True, eq=False)
class Curve:
    """Clearance of one pair in one phase.

    Attributes:
        pair: its name.
        times_s, clearance_m: (k,).
        windows: (t0, t1, margin); the margin is None where the pair may touch.
    """

    pair: str
    times_s: Array
    clearance_m: Array
    windows: tuple[tuple[float, float, float | None], ...]


def clearance_curves(scenario: Scenario, plan: Plan) -> list[Curve]:
    """One curve for each phase and pair of parts."""
    found = []
    for trajectory in plan.phases:
        phase = scenario.phase(trajectory.phase)
        times = np.linspace(trajectory.t0_s, trajectory.t1_s, SAMPLES)
        poses = poses_at(scenario, phase, trajectory, times)
        found += [curve(scenario, pair, times, poses) for pair in scenario.pairs(phase)]
    return found


def poses_at(
    scenario: Scenario, phase: Phase, trajectory: PhaseTrajectory, times: Array
) -> dict[str, Pose]:
    """Poses of every vehicle and structure, by name, at the times (k,) of the phase."""
    poses = {s.name: s.motion.pose(times) for s in scenario.structures}
    for vehicle in phase.vehicles:
        states = trajectory.vehicle(vehicle.name).state(times)
        poses[vehicle.name] = vehicle.model.pose(states)
    return poses


def part_poses(pair: Pair, poses: Mapping[str, Pose]) -> tuple[Pose, Pose]:
    """Poses of the two parts, from those of their owners."""
    return (
        poses[pair.owner_a.name].compose(pair.part_a.placement),
        poses[pair.owner_b.name].compose(pair.part_b.placement),
    )


def curve(scenario: Scenario, pair: Pair, times: Array, poses: Mapping[str, Pose]) -> Curve:
    """The clearance of one pair at the times (k,) of the poses."""
    query = PairQuery(pair.part_a.shape, pair.part_b.shape)
    distance, _, _ = query.batch(*part_poses(pair, poses))
    span = (float(times[0]), float(times[-1]))
    windows = scenario.margins.windows(pair.ref_a, pair.ref_b, span)
    return Curve(pair.name, times, distance, tuple(windows))
