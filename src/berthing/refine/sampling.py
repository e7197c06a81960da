"""Clearance of every pair along a trajectory, sampled densely: it steers, it proves nothing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from berthing.clearance.along import distances_along
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.pair import Pair
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import PhaseTrajectory


@dataclass(frozen=True)
class SampledClearance:
    """Distances of each pair over time.

    Attributes:
        times_s: (k,).
        distances_m: (pairs, k); where the bounding balls are further apart than asked for, a
            lower bound stands in.
        margins_m: (pairs, k) the margin in force, NaN where the pair may touch.
    """

    times_s: Array
    distances_m: Array
    margins_m: Array

    @property
    def shortfall_m(self) -> Array:
        """Margin less distance (pairs, k); −∞ where the pair may touch."""
        return np.where(np.isnan(self.margins_m), -np.inf, self.margins_m - self.distances_m)

    @property
    def worst_m(self) -> float:
        """The largest shortfall; negative when everything keeps its margin at the samples."""
        return float(np.max(self.shortfall_m)) if self.distances_m.size else -np.inf


def sample_clearance(
    scenario: Scenario,
    pairs: Sequence[Pair],
    trajectory: PhaseTrajectory,
    times_s: Array,
    near_m: float,
) -> SampledClearance:
    """Distances at ``times_s`` (k,), exact where bounding balls come within ``near_m``."""
    distances = np.empty((len(pairs), len(times_s)))
    margins = np.empty_like(distances)
    owners: dict[str, Pose] = {}
    for i, pair in enumerate(pairs):
        a = _owner_pose(owners, pair.owner_a, trajectory, times_s)
        b = _owner_pose(owners, pair.owner_b, trajectory, times_s)
        distances[i] = distances_along(pair.part_a, a, pair.part_b, b, near_m)
        for t0, t1, margin in scenario.margins.windows(
            pair.ref_a, pair.ref_b, (float(times_s[0]), float(times_s[-1]))
        ):
            inside = (times_s >= t0) & (times_s <= t1)
            margins[i, inside] = np.nan if margin is None else margin
    return SampledClearance(times_s, distances, margins)


def _owner_pose(
    known: dict[str, Pose], owner: Vehicle | Structure, trajectory: PhaseTrajectory, t: Array
) -> Pose:
    if owner.name not in known:
        if isinstance(owner, Structure):
            known[owner.name] = owner.motion.pose(t)
        else:
            known[owner.name] = owner.model.pose(trajectory.vehicle(owner.name).state(t))
    return known[owner.name]


def sample_times(trajectory: PhaseTrajectory, per_segment: int) -> Array:
    """``per_segment`` equal steps in every segment, ends included (k,)."""
    breaks = trajectory.vehicles[0].breaks_s
    steps = np.linspace(0.0, 1.0, per_segment + 1)[:-1]
    inner = breaks[:-1, None] + np.diff(breaks)[:, None] * steps
    return np.append(inner.ravel(), breaks[-1])
