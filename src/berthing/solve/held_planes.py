"""Planes held where they part the pairs of a motion best, and the rows that they make of it.

With the normal n held, the gap n·(p_B - p_A) - d of the two nearest points is smooth in the poses,
and its slope is that of the distance (the envelope theorem). For bodies that only move, not turn,
the distance is convex in the motion, so that the row errs on the safe side however far the step. A
body that turns exchanges its nearest point for another: an edge or a face that lies along the plane
has several at once. All of these stand in rows, and the plane may tilt among them a little, or
edges would be held as if they were faces.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.clearance.placed_distance import of_sets
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.scenario import Scenario
from berthing.solve.samples import Placed, Samples
from berthing.transcription.elements import Index
from berthing.transcription.problem import Motion


@dataclass(frozen=True)
class Near:
    """One pair at the instants at which it is near.

    Attributes:
        pair: its index. at: (m,) the instants.
        short_m: (m,) margin less distance.
        required_m: (m,) the margin.
        normal: (m, d) world, from A to B.
        pose_a, pose_b: of the two parts.
        point_a, point_b: (m, d) where they are nearest to each other, in their own frames.
    """

    pair: int
    at: Index
    short_m: Array
    required_m: Array
    normal: Array
    pose_a: Pose
    pose_b: Pose
    point_a: Array
    point_b: Array


@dataclass(frozen=True)
class Around:
    """What is near on a motion.

    Attributes:
        motion: it. placed: the bodies on it.
        near: the pairs that come near: within ``reach_m`` beyond their margins.
    """

    motion: Motion
    placed: Placed
    near: tuple[Near, ...]
    reach_m: float

    @property
    def worst_m(self) -> float:
        """The largest shortfall; 0 where nothing is short."""
        return max((float(np.max(one.short_m, initial=0.0)) for one in self.near), default=0.0)

    @property
    def short_m(self) -> float:
        """The sum of all shortfalls."""
        return float(sum(np.sum(np.maximum(one.short_m, 0.0)) for one in self.near))


class HeldPlanes:
    """Every pair of a scenario at the samples of a problem.

    Args:
        backoff_m: added to every margin.
    """

    def __init__(self, samples: Samples, scenario: Scenario, backoff_m: float) -> None:
        self.samples, self.scenario = samples, scenario
        self._backoff_m = backoff_m
        self._pairs = samples.problem.pairs
        radii = [(p.part_a.shape.bounding_radius, p.part_b.shape.bounding_radius)
                 for p in self._pairs]  # fmt: skip
        self._radii = np.sum(np.array(radii).reshape(-1, 2), axis=1)
        self._margins: tuple[Array, Array] | None = None

    def around(self, motion: Motion, reach_m: float) -> Around:
        """What comes within ``reach_m`` beyond its margin on ``motion``."""
        placed = self.samples.place(self.scenario, motion)
        margins = self._margins_at(self.samples.times(motion))
        balls = self._centre_distances(placed) - self._radii[:, None] - margins
        found = []
        for p in np.flatnonzero(np.any(balls < reach_m, axis=1)):
            at = np.flatnonzero(balls[p] < reach_m)
            pair = self._pairs[p]
            a, b = (
                placed.poses[owner.name][at].compose(part.placement)
                for owner, part in ((pair.owner_a, pair.part_a), (pair.owner_b, pair.part_b))
            )
            known = of_sets(pair.part_a.shape, a, pair.part_b.shape, b)
            short = margins[p, at] - known.distance
            near = np.flatnonzero(short > -reach_m)
            if len(near):
                a, b, known = a[near], b[near], known[near]
                found.append(
                    Near(
                        int(p), at[near], short[near], margins[p, at[near]], known.normal, a, b,
                        a.inverse().apply(known.point_a), b.inverse().apply(known.point_b),
                    )
                )
        return Around(motion, placed, tuple(found), reach_m)

    def _centre_distances(self, placed: Placed) -> Array:
        """(pairs, k) of the balls' centres."""
        known: dict[str, Array] = {}
        out = np.empty((len(self._pairs), len(self.samples.fractions)))
        for i, pair in enumerate(self._pairs):
            for ref, owner, part in ((pair.ref_a, pair.owner_a, pair.part_a),
                                     (pair.ref_b, pair.owner_b, pair.part_b)):  # fmt: skip
                if ref not in known:
                    known[ref] = placed.poses[owner.name].apply(part.placement.position)
            out[i] = np.linalg.norm(known[pair.ref_b] - known[pair.ref_a], axis=-1)
        return out

    def _margins_at(self, times_s: Array) -> Array:
        """(pairs, k) with the back-off; -∞ where a pair may touch."""
        if self._margins is None or not np.array_equal(self._margins[0], times_s):
            policy, span = self.scenario.margins, (float(times_s[0]), float(times_s[-1]))
            out = np.empty((len(self._pairs), len(times_s)))
            for i, pair in enumerate(self._pairs):
                for t0, t1, margin in policy.windows(pair.ref_a, pair.ref_b, span):
                    inside = (times_s >= t0) & (times_s <= t1)
                    out[i, inside] = -np.inf if margin is None else margin + self._backoff_m
            self._margins = times_s, out
        return self._margins[1]
