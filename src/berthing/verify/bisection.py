"""Breadth-first bisection in time of all pairs of parts of two bodies at once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.body_motion import Index, Mask
from berthing.verify.interval_bounds import first_order, second_order
from berthing.verify.leaves import Collector, Intervals, Leaves, Samples, Status
from berthing.verify.pair_motion import BodyPair, RelativeMotion, RelativePose, norm
from berthing.verify.part_pair import PartPair
from berthing.verify.settings import CertificateSettings


class Bisection:
    """The search over the pairs ``parts`` of two bodies; ``run`` gives the intervals it ends with.

    Each level works on all open intervals at once: first the second-order bound, from what is
    known at their ends; then one query at each middle and the first-order bound; what neither
    proves is split.
    """

    def __init__(
        self, bodies: BodyPair, parts: Sequence[PartPair], settings: CertificateSettings
    ) -> None:
        self._bodies, self._parts, self._settings = bodies, parts, settings
        self._offset = np.array([p.ball_a.centre for p in parts])
        self._radius = np.array([p.ball_a.radius for p in parts])
        self._centre_b = np.array([p.ball_b.centre for p in parts])
        self._radius_b = np.array([p.ball_b.radius for p in parts])
        extent = norm(self._centre_b) + self._radius + self._radius_b
        self._slack = settings.float_slack * (bodies.length(self._offset) + extent)
        self._collector = Collector(len(parts), settings)
        # Middles of the intervals that balls alone prove, with the gap between the balls there.
        self.far = Samples.none()

    def run(self, roots: Intervals) -> tuple[Leaves, Samples]:
        """Split ``roots`` until each interval is decided."""
        open_ = self._drop_far(roots)
        while len(open_):
            open_ = self._level(open_)
        return self._collector.leaves(), self._collector.samples()

    def _drop_far(self, open_: Intervals) -> Intervals:
        """Close the intervals that balls about the parts prove; they need no query."""
        motion, half = self._motion(open_)
        pose, pair = motion.pose, open_.pair
        centre = pose.position + (pose.rotation @ self._offset[pair, :, None])[:, :, 0]
        gap = self._centre_b[pair] - centre
        length = norm(gap)
        normal = gap / np.where(length > 0.0, length, 1.0)[:, None]
        value = length - self._radius[pair] - self._radius_b[pair]
        bound = self._first(open_, value, normal, motion, half)
        closed = bound >= open_.required
        self._close(open_, closed, bound, _constant(normal), Status.CERTIFIED)
        middle = 0.5 * (open_.t0 + open_.t1)
        self.far = Samples(pair, middle, value, open_.required).take(closed)
        return open_.take(~closed)

    def _level(self, open_: Intervals) -> Intervals:
        """Bound every interval, close what is decided, split the rest."""
        motion, half = self._motion(open_)
        bound = self._second(open_, motion, half)
        closed = bound >= open_.required
        self._close(open_, closed, bound, open_.normals, Status.CERTIFIED)
        keep = ~closed
        open_, motion, half, bound = open_.take(keep), motion.take(keep), half[keep], bound[keep]
        if not len(open_):
            return open_
        value, normal = self._sample(open_, 0.5 * (open_.t0 + open_.t1), motion.pose)
        first = self._first(open_, value, normal, motion, half)
        better = (first > bound)[:, None, None]
        normals = np.where(better, _constant(normal), open_.normals)
        bound = np.maximum(bound, first)
        left = self._abandon(open_, bound, normals, value)
        return self._split(open_.take(left), value[left], normal[left])

    def _abandon(self, open_: Intervals, bound: Array, normals: Array, value: Array) -> Mask:
        """Close what is proven, and what splitting would not decide; say what is left."""
        closed = bound >= open_.required
        self._close(open_, closed, bound, normals, Status.CERTIFIED)
        left = ~closed
        lowest = np.fmin(value, np.fmin(open_.values[:, 0], open_.values[:, 1]))
        for status, hopeless in self._collector.hopeless(open_, bound, lowest):
            self._close(open_, left & hopeless, bound, normals, status)
            left = left & ~hopeless
        if np.count_nonzero(left) > self._settings.max_intervals:
            self._close(open_, left, bound, normals, Status.UNDECIDED)
            left = np.zeros_like(left)
        return left

    def _split(self, open_: Intervals, value: Array, normal: Array) -> Intervals:
        """Quarters, with what is known at their ends; ``value`` and ``normal`` at the middles.

        Quarters rather than halves: a round of array operations costs as much as 200 queries.
        """
        if not len(open_):
            return open_
        middle = 0.5 * (open_.t0 + open_.t1)
        early, late = 0.5 * (open_.t0 + middle), 0.5 * (middle + open_.t1)
        times = np.stack([open_.t0, early, middle, late, open_.t1], axis=1)
        values = np.full(times.shape, np.nan)
        normals = np.zeros((*times.shape, 3))
        values[:, 2], normals[:, 2] = value, normal
        values[:, [0, 4]], normals[:, [0, 4]] = open_.values, open_.normals
        row, column = np.nonzero(np.isnan(values))
        # Each time belongs to the cell of its own interval, ends included.
        cells = tuple(cell[row] for cell in self._bodies.cells(middle))
        pose = self._bodies.pose(times[row, column], (cells[0], cells[1]))
        values[row, column], normals[row, column] = self._sample(
            open_.take(row), times[row, column], pose
        )
        return Intervals.join(
            [
                Intervals(
                    open_.pair,
                    times[:, i],
                    times[:, i + 1],
                    open_.required,
                    values[:, i : i + 2],
                    normals[:, i : i + 2],
                )
                for i in range(4)
            ]
        )

    def distances(self, pair: Index, t: Array) -> Array:
        """Exact distances (k,) of the pairs of parts (k,) at the times t (k,)."""
        pose = self._bodies.pose(t, self._bodies.cells(t))
        return self._ask(pair, pose)[2]

    def _motion(self, open_: Intervals) -> tuple[RelativeMotion, Array]:
        middle, half = 0.5 * (open_.t0 + open_.t1), 0.5 * (open_.t1 - open_.t0)
        cells = self._bodies.cells(middle)
        return self._bodies.motion(middle, half, cells, self._offset[open_.pair]), half

    def _first(
        self, open_: Intervals, value: Array, normal: Array, motion: RelativeMotion, half: Array
    ) -> Array:
        radius = self._radius[open_.pair]
        bound = first_order(value, normal, motion, half, radius, self._settings.motion_inflation)
        return _proof(bound - self._slack[open_.pair])

    def _second(self, open_: Intervals, motion: RelativeMotion, half: Array) -> Array:
        radius, v, n = self._radius[open_.pair], open_.values, open_.normals
        bound = second_order(
            (v[:, 0], v[:, 1]), (n[:, 0], n[:, 1]), motion, half, radius,
            self._settings.motion_inflation,
        )  # fmt: skip
        return _proof(bound - self._slack[open_.pair])

    def _sample(self, open_: Intervals, t: Array, pose: RelativePose) -> tuple[Array, Array]:
        """Plane bounds and normals at the times t, one of each interval."""
        values, normals, distances = self._ask(open_.pair, pose)
        self._collector.add(Samples(open_.pair, t, distances, open_.required))
        return values, normals

    def _ask(self, pair: Index, pose: RelativePose) -> tuple[Array, Array, Array]:
        """Plane bounds (k,), normals (k, 3) and distances (k,) of the pairs (k,) at poses (k,)."""
        k = len(pair)
        values, normals, distances = np.empty(k), np.empty((k, 3)), np.empty(k)
        order = np.argsort(pair, kind="stable")
        present, starts = np.unique(pair[order], return_index=True)
        for i, here in zip(present, np.split(order, starts[1:]), strict=True):
            found = self._parts[i].sample(pose.take(here))
            values[here], normals[here], distances[here] = found.bound, found.normal, found.distance
        return values, normals, distances

    def _close(
        self, open_: Intervals, which: Mask, bound: Array, normals: Array, status: Status
    ) -> None:
        self._collector.close(open_, which, bound, normals, status)


def _constant(normal: Array) -> Array:
    """(k, 3) → (k, 2, 3): the same at both ends."""
    return np.repeat(normal[:, None], 2, axis=1)


def _proof(bound: Array) -> Array:
    """A bound that is not a number proves nothing."""
    return np.where(np.isnan(bound), -np.inf, bound)
