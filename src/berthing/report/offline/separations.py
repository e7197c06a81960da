"""How far apart things are, for the page: curves, what is proven, and the closest pair."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from berthing.clearance.separation import PairQuery
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.report.clearance_curves import Curve, curve, part_poses, poses_at
from berthing.report.offline.packing import Packing
from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.trajectory import PhaseTrajectory
from berthing.verify.claims import PairClaim, PhaseClaims

# Even samples of one phase for curves and closest points, and those with which pairs are ranked.
SAMPLES, COARSE_SAMPLES = 401, 41
# Pairs drawn, the closest first: as many as there are colours. With many bays, the rest is far.
DRAWN = 10
# Steps of one pair's proven bound: neighbours are joined where there are more.
MOST_STEPS = 2000


def packed_separations(
    scenario: Scenario,
    trajectory: PhaseTrajectory,
    marked_s: Sequence[float],
    claims: PhaseClaims,
    packing: Packing,
) -> dict[str, Any]:
    """Everything about clearance in one phase.

    Args:
        marked_s: times that are sampled too.
        claims: what is proven in this phase.
    """
    phase = scenario.phase(trajectory.phase)
    pairs = _drawn_pairs(scenario, phase, trajectory)
    even = np.linspace(trajectory.t0_s, trajectory.t1_s, SAMPLES)
    times = np.unique(np.clip([*even, *marked_s], trajectory.t0_s, trajectory.t1_s))
    poses = poses_at(scenario, phase, trajectory, times)
    curves = [curve(scenario, pair, times, poses) for pair in pairs]
    order = np.argsort([c.clearance_m.min() for c in curves]).tolist()
    pairs, curves = [pairs[i] for i in order], [curves[i] for i in order]
    proven = {claim.pair: claim for claim in claims.pairs}
    return {
        "phase": phase.name,
        "t": packing.exact(times),
        "pairs": [_packed_pair(c, proven.get(c.pair), packing) for c in curves[:DRAWN]],
        "more": len(scenario.pairs(phase)) - len(curves[:DRAWN]),
        "closest": _closest(pairs, curves, poses, packing),
    }


def _drawn_pairs(scenario: Scenario, phase: Phase, trajectory: PhaseTrajectory) -> list[Pair]:
    """The pairs that come nearest, and each that is the nearest of all at some instant."""
    pairs = scenario.pairs(phase)
    if len(pairs) <= DRAWN:
        return list(pairs)
    times = np.linspace(trajectory.t0_s, trajectory.t1_s, COARSE_SAMPLES)
    poses = poses_at(scenario, phase, trajectory, times)
    distance = np.stack([curve(scenario, pair, times, poses).clearance_m for pair in pairs])
    chosen = {*np.argsort(distance.min(axis=1))[:DRAWN].tolist()}
    chosen |= {*np.argmin(distance, axis=0).tolist()}
    return [pair for i, pair in enumerate(pairs) if i in chosen]


def _packed_pair(found: Curve, claim: PairClaim | None, packing: Packing) -> dict[str, Any]:
    return {
        "name": found.pair,
        "d": packing.floats(found.clearance_m),
        "windows": [list(window) for window in found.windows],
        "proven": packing.exact(np.empty((0, 3)) if claim is None else _steps(claim)),
    }


def _steps(claim: PairClaim) -> Array:
    """Rows (from, to, bound): what is proven for every instant of each interval."""
    rows = np.stack([claim.t0, claim.t1, claim.bound], axis=1)
    if len(rows) <= MOST_STEPS:
        return rows
    starts = np.linspace(0, len(rows), MOST_STEPS, endpoint=False).astype(int)
    ends = np.append(starts[1:], len(rows)) - 1
    least = np.minimum.reduceat(rows[:, 2], starts)
    return np.stack([rows[starts, 0], rows[ends, 1], least], axis=1)


def _closest(
    pairs: Sequence[Pair], curves: Sequence[Curve], poses: Mapping[str, Pose], packing: Packing
) -> dict[str, Any] | None:
    """The closest pair at each time: which, its points, the normal of its separating plane.

    A pair that may touch at that time counts only where no other has a margin.
    """
    if not pairs:
        return None
    distance = np.stack([c.clearance_m for c in curves])
    held = np.stack([_held(c) for c in curves])
    counts = np.where(held | ~held.any(axis=0), distance, np.inf)
    which = np.argmin(counts, axis=0).tolist()
    queries = {i: PairQuery(pairs[i].part_a.shape, pairs[i].part_b.shape) for i in set(which)}
    placed = {i: part_poses(pairs[i], poses) for i in queries}
    found = [queries[i].query(placed[i][0][k], placed[i][1][k]) for k, i in enumerate(which)]
    return {
        "names": [pair.name for pair in pairs],
        "pair": packing.indices(which),
        "d": packing.floats([s.distance for s in found]),
        "a": packing.floats(_in_space([s.point_a for s in found])),
        "b": packing.floats(_in_space([s.point_b for s in found])),
        "n": packing.floats(_in_space([s.normal for s in found])),
    }


def _held(found: Curve) -> npt.NDArray[np.bool_]:
    """At which times (k,) the pair has a margin."""
    t = found.times_s
    windows = [(t >= t0) & (t <= t1) for t0, t1, margin in found.windows if margin is not None]
    return np.asarray(np.any([np.zeros(len(t), dtype=np.bool_), *windows], axis=0))


def _in_space(rows: Sequence[Array]) -> Array:
    """Rows (k, 2 or 3) as rows of space (k, 3)."""
    flat = np.stack(rows)
    return np.pad(flat, ((0, 0), (0, 3 - flat.shape[1])))
