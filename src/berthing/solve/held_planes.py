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
from berthing.scenario.motion import Fixed
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
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
        sides = [((p.ref_a, p.owner_a, p.part_a), (p.ref_b, p.owner_b, p.part_b))
                 for p in self._pairs]  # fmt: skip
        self._named = [side for both in sides for side in both]
        self._still: dict[str, Pose] = {}

    def around(self, motion: Motion, reach_m: float) -> Around:
        """What comes within ``reach_m`` beyond its margin on ``motion``."""
        placed = self.samples.place(self.scenario, motion)
        margins = self._margins_at(self.samples.times(motion))
        parts = self._parts(placed)
        balls = self._centre_distances(parts) - self._radii[:, None] - margins
        found = []
        for p in np.flatnonzero(np.any(balls < reach_m, axis=1)):
            at = np.flatnonzero(balls[p] < reach_m)
            pair = self._pairs[p]
            a, b = parts[pair.ref_a][at], parts[pair.ref_b][at]
            known = of_sets(pair.part_a.shape, a, pair.part_b.shape, b)
            short = margins[p, at] - known.distance
            near = np.flatnonzero(short > -reach_m)
            if not len(near):
                continue
            if len(near) < len(at):
                at, short, a, b, known = at[near], short[near], a[near], b[near], known[near]
            found.append(
                Near(
                    int(p), at, short, margins[p, at], known.normal, a, b,
                    a.unrotate(known.point_a - a.position), b.unrotate(known.point_b - b.position),
                )
            )  # fmt: skip
        return Around(motion, placed, tuple(found), reach_m)

    def _parts(self, placed: Placed) -> dict[str, Pose]:
        """Poses (k,) of all parts, by name."""
        known = dict(self._still)
        for ref, owner, part in self._named:
            if ref not in known:
                known[ref] = placed.poses[owner.name].compose(part.placement)
                if isinstance(owner, Structure) and isinstance(owner.motion, Fixed):
                    self._still[ref] = known[ref]
        return known

    def _centre_distances(self, parts: dict[str, Pose]) -> Array:
        """(pairs, k) of the balls' centres."""
        apart = np.array([parts[pair.ref_b].position - parts[pair.ref_a].position
                          for pair in self._pairs])  # fmt: skip
        shape = len(self._pairs), len(self.samples.fractions)
        return np.asarray(np.linalg.norm(apart.reshape(*shape, -1), axis=-1))

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
