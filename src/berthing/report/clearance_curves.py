"""Distances of pairs over time, sampled for drawing; what is proven is in the verification."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.clearance.separation import PairQuery
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle
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
        poses = _poses(scenario, phase, trajectory, times)
        found += [_curve(scenario, pair, times, poses) for pair in scenario.pairs(phase)]
    return found


def _poses(
    scenario: Scenario, phase: Phase, trajectory: PhaseTrajectory, times: Array
) -> dict[str, Pose]:
    poses = {s.name: s.motion.pose(times) for s in scenario.structures}
    for vehicle in phase.vehicles:
        poses[vehicle.name] = _vehicle_pose(vehicle, trajectory, times)
    return poses


def _vehicle_pose(vehicle: Vehicle, trajectory: PhaseTrajectory, times: Array) -> Pose:
    return vehicle.model.pose(trajectory.vehicle(vehicle.name).state(times))


def _curve(scenario: Scenario, pair: Pair, times: Array, poses: dict[str, Pose]) -> Curve:
    a = poses[pair.owner_a.name].compose(pair.part_a.placement)
    b = poses[pair.owner_b.name].compose(pair.part_b.placement)
    distance, _, _ = PairQuery(pair.part_a.shape, pair.part_b.shape).batch(a, b)
    span = (float(times[0]), float(times[-1]))
    windows = scenario.margins.windows(pair.ref_a, pair.ref_b, span)
    return Curve(pair.name, times, distance, tuple(windows))
