"""Time a pose along the public pose law, beside a bare loop over ``coal`` in the same run."""

from __future__ import annotations

import time
from collections.abc import Callable
from itertools import product
from typing import Any

import coal
import numpy as np

from benchmarks._distance_sets import EXACT, SMOOTH, pose_law
from berthing.clearance.coal_pair import EPA_TOLERANCES, GJK_TOLERANCE, MAX_ITERATIONS
from berthing.clearance.coal_shapes import coal_pair
from berthing.clearance.placed_distance import distance
from berthing.clearance.signed_distance import SignedDistance
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose

# Poses of a stretch: some tens of milliseconds.
STRETCH = 5000


def speed(count: int, repeats: int) -> dict[str, Any]:
    """µs a pose of the processor's time, one core, gradients included.

    The poses in order, by stretches; ours and the loop take turns on each, and all pairs are gone
    through before the next repeat. Times of each stretch's best repeat, which other work on the
    machine disturbed least, and of the median one.
    """
    poses, pairs = pose_law(count), {**EXACT, **SMOOTH}
    stretches = [poses[i : i + STRETCH] for i in range(0, count, STRETCH)]
    ours = {name: np.zeros((repeats, len(stretches))) for name in pairs}
    bare = {name: np.zeros((repeats, len(stretches))) for name in EXACT}
    for repeat, (name, (a, b)) in product(range(repeats), pairs.items()):
        for i, some in enumerate(stretches):
            ours[name][repeat, i] = _timed(lambda a=a, b=b, some=some: distance(a, b, some))
            if name in EXACT:
                bare[name][repeat, i] = _timed(_coal_loop(a, b, some))
    table: dict[str, Any] = {}
    for name, (a, b) in pairs.items():
        table[name] = _summary("ours_us", ours[name], count) | _widths(distance(a, b, poses))
        if name in EXACT:
            table[name] |= _summary("coal_us", bare[name], count)
            for kind in ("", "_median"):
                ratio = table[name][f"ours_us{kind}"] / table[name][f"coal_us{kind}"]
                table[name][f"ratio{kind}"] = ratio
    return table


def _widths(found: SignedDistance) -> dict[str, float]:
    outside = found.lower_bound > 0.0
    width = found.upper_bound - found.lower_bound
    return {
        "overlapping_share": float(np.mean(~outside)),
        "widest_bracket_m": float(np.max(width[outside])),
        "widest_depth_bracket_m": float(np.max(width[~outside])),
    }


def _summary(name: str, seconds: Array, count: int) -> dict[str, float]:
    best, median = np.min(seconds, axis=0), np.median(seconds, axis=0)
    scale = 1e6 / count
    return {name: scale * float(np.sum(best)), f"{name}_median": scale * float(np.sum(median))}


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
