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
from scipy import sparse

from berthing.clearance.placed_distance import of_sets
from berthing.geometry.arrays import Array
from berthing.geometry.body import Part
from berthing.geometry.pose import Pose
from berthing.scenario.pair import Pair
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.solve.contacts import Side, contacts, sides_of
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


@dataclass(frozen=True)
class HeldRows:
    """Rows gap + slope δ + slack ≥ 0, in the programme's length.

    Attributes:
        gap: (m,). slope: (m, n) by the stored variables.
        group: (m,) rows of one pair at one instant share a slack; of ``groups``.
        tilt: (m, t) slope by tilts of planes, each at most ``most`` to either side.
    """

    gap: Array
    slope: sparse.csr_matrix
    group: Index
    groups: int
    tilt: sparse.csr_matrix
    most: float


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

    def rows(self, around: Around, tilt: float, tilted_m: float) -> HeldRows:
        """Rows for all that is near.

        Args:
            tilt: of the planes, at most, and of the normals that find further points, rad.
            tilted_m: planes of pairs that keep more than this beyond their margin do not tilt.
        """
        entries: list[tuple[Index, Index, Array]] = []
        turns: list[tuple[Index, Index, Array]] = []
        gaps, groups = [np.empty(0)], [np.empty(0, np.int64)]
        count = first = 0
        for one in around.near:
            pair = self._pairs[one.pair]
            touching = contacts(*_sides(pair, one), tilt, one.short_m > -tilted_m)
            which, va, vb = (np.concatenate(v) for v in zip(*touching, strict=True))
            n, at, placed = one.normal[which], one.at[which], around.placed
            reach = one.pose_b[which].apply(vb) - one.pose_a[which].apply(va)
            gaps.append(np.sum(n * reach, axis=-1) - one.required_m[which])
            groups.append(first + which)
            lines = count + np.arange(len(which))
            count += len(which)
            entries += self._entries(placed, pair.owner_a, pair.part_a, lines, at, -n, va)
            entries += self._entries(placed, pair.owner_b, pair.part_b, lines, at, n, vb)
            turns.append((lines, first + which, reach))
            first += len(one.at)
        problem = self.samples.problem
        length_m, size = problem.layout.scale.length_m, problem.layout.variables.size
        group, gap = np.concatenate(groups), np.concatenate(gaps) / length_m
        slope = _matrix(entries, (count, size), length_m)
        tilts = self._tilts(around, turns, group, count, length_m)
        return HeldRows(gap, slope, group, first, tilts, tilt)

    def _tilts(
        self, around: Around, turns: list[tuple[Index, Index, Array]], group: Index, count: int,
        length_m: float,
    ) -> sparse.csr_matrix:
        """Slopes (m, t) by tilts of the planes that more than one pair of points touches."""
        if not turns:
            return sparse.csr_matrix((count, 0))
        normal = np.concatenate([one.normal for one in around.near])
        several = np.bincount(group, minlength=len(normal)) > 1
        number = np.cumsum(several) - 1
        sides = sides_of(normal)
        entries = []
        for lines, which, reach in turns:
            tilting = several[which]
            for k, side in enumerate(sides):
                value = np.sum(side[which] * reach, axis=-1)[tilting]
                column = len(sides) * number[which][tilting] + k
                entries.append((lines[tilting], column, value))
        return _matrix(entries, (count, len(sides) * int(np.sum(several))), length_m)

    def _entries(
        self, placed: Placed, owner: Vehicle | Structure, part: Part, lines: Index, at: Index,
        n: Array, v: Array,
    ) -> list[tuple[Index, Index, Array]]:  # fmt: skip
        """Rows, columns and values of the slope of n·(point v of the part), where it can move."""
        if isinstance(owner, Structure):
            return []
        slope = _slope(placed, owner, part, at, n, v)
        columns, values = self.samples.spread(owner.name, at, slope)
        rows = np.broadcast_to(lines[:, None, None], columns.shape)
        return [(rows.ravel(), columns.ravel(), values.ravel())]

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


def _sides(pair: Pair, one: Near) -> tuple[Side, Side]:
    a, b = one.pose_a.unrotate(one.normal), one.pose_b.unrotate(-one.normal)
    return Side(pair.part_a.shape, a, one.point_a), Side(pair.part_b.shape, b, one.point_b)


def _matrix(
    entries: list[tuple[Index, Index, Array]], shape: tuple[int, int], length_m: float
) -> sparse.csr_matrix:
    if not entries:
        return sparse.csr_matrix(shape)
    rows, columns, values = (np.concatenate(v) for v in zip(*entries, strict=True))
    return sparse.csr_matrix((values / length_m, (rows, columns)), shape)


def _slope(
    placed: Placed, owner: Vehicle, part: Part, at: Index, n: Array, v: Array
) -> Array:
    """Of n·(point v of the part) by what places its owner (m, c)."""
    body = part.placement.apply(v)
    by_turn = (body[:, :, None] * n[:, None, :]).reshape(len(n), -1)
    by_pose = np.concatenate([n, by_turn], axis=-1)
    return np.asarray(np.einsum("mp,mpc->mc", by_pose, placed.slopes[owner.name][at]))
