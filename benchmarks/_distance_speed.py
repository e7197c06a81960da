"""Time a pose along the public pose law, beside a bare loop over ``coal`` in the same run."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import coal
import numpy as np

from benchmarks._distance_sets import EXACT, SMOOTH, pose_law
from berthing.clearance.coal_pair import EPA_TOLERANCES, GJK_TOLERANCE, MAX_ITERATIONS
from berthing.clearance.coal_shapes import coal_pair
from berthing.clearance.placed_distance import distance
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose


def speed(count: int, repeats: int) -> dict[str, Any]:
    """µs a pose of the processor's time, one core, gradients included: the best of the repeats, the
    one that other work on the machine disturbed least, and their median. Ours and the loop take
    turns."""
    poses = pose_law(count)
    table: dict[str, Any] = {}
    for name, (a, b) in {**EXACT, **SMOOTH}.items():
        ours, bare = [], []
        loop = _coal_loop(a, b, poses) if name in EXACT else None
        for _ in range(repeats):
            ours.append(_timed(lambda a=a, b=b: distance(a, b, poses)) / count * 1e6)
            if loop:
                bare.append(_timed(loop) / count * 1e6)
        found = distance(a, b, poses)
        outside = found.lower_bound > 0.0
        width = found.upper_bound - found.lower_bound
        row = {
            **_summary("ours_us", np.array(ours)),
            "overlapping_share": float(np.mean(~outside)),
            "widest_bracket_m": float(np.max(width[outside])),
            "widest_depth_bracket_m": float(np.max(width[~outside])),
        }
        if bare:
            row |= _summary("coal_us", np.array(bare))
            row |= {
                "ratio": row["ours_us"] / row["coal_us"],
                "ratio_median": float(np.median(np.array(ours) / np.array(bare))),
            }
        table[name] = row
    return table


def _summary(name: str, times: Array) -> dict[str, float]:
    return {name: float(np.min(times)), f"{name}_median": float(np.median(times))}


def _timed(work: Callable[[], object]) -> float:
    start = time.process_time()
    work()
    return time.process_time() - start


def _coal_loop(a: ConvexSet, b: ConvexSet, poses: Pose) -> Callable[[], object]:
    """Distances alone: no normal, no points, no check."""
    first, second = coal_pair(a, b, 1.0)
    request = coal.DistanceRequest()
    request.gjk_tolerance, request.gjk_max_iterations = GJK_TOLERANCE, MAX_ITERATIONS
    request.epa_tolerance, request.epa_max_iterations = EPA_TOLERANCES[0], MAX_ITERATIONS
    request.enable_signed_distance = True
    compute = coal.ComputeDistance(first.geometry, second.geometry)
    result, still, moved = coal.DistanceResult(), coal.Transform3s.Identity(), coal.Transform3s()
    turns = np.ascontiguousarray(first.turn.T @ poses.rotation @ second.turn)
    places = np.ascontiguousarray(poses.position @ first.turn)
    distances = np.empty(len(places))

    def loop() -> object:
        for i, (turn, place) in enumerate(zip(turns, places, strict=True)):
            moved.setTransform(turn, place)
            result.clear()
            distances[i] = compute(still, moved, request, result)
        return distances

    return loop
