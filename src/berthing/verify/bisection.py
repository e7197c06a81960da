"""Breadth-first bisection in time of all pairs of parts of two bodies at once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.body_motion import Index, Mask
from berthing.verify.bounds import Bounds
from berthing.verify.leaves import Collector, Intervals, Leaves, Samples, Status
from berthing.verify.pair_motion import RelativePose, norm
from berthing.verify.settings import CertificateSettings

# Intervals worked on at a time: beyond this memory grows and speed does not.
BLOCK = 16_384

# Plane bounds (k,) of pairs (k,) at poses (k,) with normals (k, 3).
Plane = Callable[[Index, RelativePose, Array], Array]


class Bisection:
    """The search over the pairs of two bodies; ``run`` gives the intervals it ends with.

    Each level works on all open intervals at once: first with the normals at their ends, where
    these are known; then one query at each middle, whose normal is held over the interval; what
    neither proves is split.
    """

    def __init__(self, bounds: Bounds, tubes_m: list[float], settings: CertificateSettings) -> None:
        self._bounds, self._settings = bounds, settings
        self._collector = Collector(tubes_m, settings)
        # Middles of the intervals that balls alone prove, with the gap between the balls there.
        self.far = Samples.none()

    def run(self, roots: Intervals) -> tuple[Leaves, Samples]:
        """Split ``roots`` until each interval is decided."""
        open_ = self._drop_far(roots)
        while len(open_):
            last = len(open_) > self._settings.max_intervals
            blocks = [self._level(block, last) for block in open_.blocks(BLOCK)]
            open_ = Intervals.join(blocks)
        return self._collector.leaves(), self._collector.samples()

    def _drop_far(self, open_: Intervals) -> Intervals:
        """Close the intervals that balls about the parts prove; they need no query."""
        motion, half = self._bounds.motion(open_)
        away = self._bounds.away(open_.pair, motion.pose)
        length = norm(away)
        normal = away / np.where(length > 0.0, length, 1.0)[:, None]
        balls = self._held(open_, normal, self._bounds.of_balls)
        bound = self._bounds.over(balls, motion, half)
        closed = bound >= open_.required
        self._close(open_, closed, bound, balls.normals, Status.CERTIFIED)
        gap = self._bounds.of_balls(open_.pair, motion.pose, normal)
        self.far = Samples(open_.pair, open_.middle, gap, open_.required).take(closed)
        return open_.take(~closed)

    def _held(self, open_: Intervals, normal: Array, plane: Plane) -> Intervals:
        """With one normal (k, 3) at both ends, and its plane bounds there."""
        first, second = self._bounds.bodies.cells(open_.middle)
        cells = np.repeat(first, 2), np.repeat(second, 2)
        times = np.stack([open_.t0, open_.t1], axis=1)
        pose = self._bounds.bodies.pose(times.ravel(), cells)
        values = plane(np.repeat(open_.pair, 2), pose, np.repeat(normal, 2, axis=0))
        normals = np.repeat(normal[:, None], 2, axis=1)
        return replace(open_, values=values.reshape(-1, 2), normals=normals)

    def _level(self, open_: Intervals, last: bool) -> Intervals:
        """Bound every interval, close what is decided, split the rest unless this is the last."""
        motion, half = self._bounds.motion(open_)
        bound = self._bounds.over(open_, motion, half)
        closed = bound >= open_.required
        self._close(open_, closed, bound, open_.normals, Status.CERTIFIED)
        keep = ~closed
        open_, motion, half, bound = open_.take(keep), motion.take(keep), half[keep], bound[keep]
        if not len(open_):
            return open_
        value, normal = self._sample(open_, open_.middle, motion.pose)
        held = self._held(open_, normal, self._bounds.plane)
        first = self._bounds.over(held, motion, half)
        better = (first > bound)[:, None, None]
        normals = np.where(better, held.normals, open_.normals)
        bound = np.maximum(bound, first)
        left = self._abandon(open_, bound, normals, value)
        if last:
            self._close(open_, left, bound, normals, Status.UNDECIDED)
            left = np.zeros_like(left)
        return self._split(open_.take(left), value[left], normal[left])

    def _abandon(self, open_: Intervals, bound: Array, normals: Array, value: Array) -> Mask:
        """Close what is proven, and what splitting would not decide; say what is left."""
        closed = bound >= open_.required
        self._close(open_, closed, bound, normals, Status.CERTIFIED)
        left = ~closed
        lowest = np.fmin(value, np.fmin(open_.values[:, 0], open_.values[:, 1]))
        lowest = lowest - self._bounds.slack[open_.pair]
        for status, hopeless in self._collector.hopeless(open_, bound, lowest):
            self._close(open_, left & hopeless, bound, normals, status)
            left = left & ~hopeless
        return left

    def _split(self, open_: Intervals, value: Array, normal: Array) -> Intervals:
        """Quarters, with what is known at their ends; ``value`` and ``normal`` at the middles.

        Quarters rather than halves: a round of array operations costs as much as 200 queries.
        """
        if not len(open_):
            return open_
        middle = open_.middle
        early, late = 0.5 * (open_.t0 + middle), 0.5 * (middle + open_.t1)
        times = np.stack([open_.t0, early, middle, late, open_.t1], axis=1)
        values = np.full(times.shape, np.nan)
        normals = np.zeros((*times.shape, 3))
        values[:, 2], normals[:, 2] = value, normal
        values[:, [0, 4]], normals[:, [0, 4]] = open_.values, open_.normals
        row, column = np.nonzero(np.isnan(values))
        # Each time belongs to the cell of its own interval, ends included.
        cells = tuple(cell[row] for cell in self._bounds.bodies.cells(middle))
        pose = self._bounds.bodies.pose(times[row, column], (cells[0], cells[1]))
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

    def _sample(self, open_: Intervals, t: Array, pose: RelativePose) -> tuple[Array, Array]:
        """Plane bounds and normals at the times t, one of each interval."""
        values, normals, distances = self._bounds.query(open_.pair, pose)
        self._collector.add(Samples(open_.pair, t, distances, open_.required))
        return values, normals

    def _close(
        self, open_: Intervals, which: Mask, bound: Array, normals: Array, status: Status
    ) -> None:
        self._collector.close(open_, which, bound, normals, status)
