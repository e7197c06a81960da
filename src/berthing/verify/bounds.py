"""Bounds on the clearance of the pairs of parts of two bodies, at instants and over intervals."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.body_motion import Index
from berthing.verify.interval_bounds import first_order, second_order
from berthing.verify.leaves import Intervals
from berthing.verify.pair_motion import BodyPair, RelativeMotion, RelativePose, norm
from berthing.verify.part_pair import PartPair
from berthing.verify.settings import CertificateSettings


class Bounds:
    """Of the pairs ``parts`` of two bodies, of which one index tells which is meant.

    What flies stays within ``tubes_m`` (one length a pair) of the interpolant. Values at instants
    are of the interpolant, bounds over intervals of what flies.

    Attributes:
        slack: what every bound over an interval loses to rounding and to the tube (m), by pair.
    """

    def __init__(
        self,
        bodies: BodyPair,
        parts: Sequence[PartPair],
        tubes_m: Sequence[float],
        settings: CertificateSettings,
    ) -> None:
        self.bodies, self._parts = bodies, parts
        self._inflation = settings.motion_inflation
        self._offset = np.array([p.ball_a.centre for p in parts])
        self._radius = np.array([p.ball_a.radius for p in parts])
        self._centre_b = np.array([p.ball_b.centre for p in parts])
        self._radius_b = np.array([p.ball_b.radius for p in parts])
        extent = norm(self._centre_b) + self._radius + self._radius_b
        rounding = settings.float_slack * (bodies.length(self._offset) + extent)
        self.slack = rounding + np.array(tubes_m)

    def motion(self, intervals: Intervals) -> tuple[RelativeMotion, Array]:
        """Of the parts' centres about the middles, and half the lengths."""
        middle, half = intervals.middle, 0.5 * (intervals.t1 - intervals.t0)
        cells = self.bodies.cells(middle)
        return self.bodies.motion(middle, half, cells, self._offset[intervals.pair]), half

    def apart(self, pair: Index, pose: RelativePose) -> tuple[Array, Array]:
        """Gaps (k,) between balls about the parts, and unit normals (k, 3) from centre to centre.

        The plane bound of these normals is no less than the gap.
        """
        centre = pose.position + (pose.rotation @ self._offset[pair, :, None])[:, :, 0]
        away = self._centre_b[pair] - centre
        length = norm(away)
        normal = away / np.where(length > 0.0, length, 1.0)[:, None]
        return length - self._radius[pair] - self._radius_b[pair], normal

    def first(
        self,
        intervals: Intervals,
        value: Array,
        normal: Array,
        motion: RelativeMotion,
        half: Array,
    ) -> Array:
        """From the plane bounds (k,) of normals (k, 3) at the middles; −∞ where NaN."""
        radius = self._radius[intervals.pair]
        bound = first_order(value, normal, motion, half, radius, self._inflation)
        return self._of_what_flies(intervals, bound)

    def second(self, intervals: Intervals, motion: RelativeMotion, half: Array) -> Array:
        """From the plane bounds and normals at the ends; −∞ where they are not known."""
        radius, v, n = self._radius[intervals.pair], intervals.values, intervals.normals
        ends = (v[:, 0], v[:, 1]), (n[:, 0], n[:, 1])
        bound = second_order(*ends, motion, half, radius, self._inflation)
        return self._of_what_flies(intervals, bound)

    def query(self, pair: Index, pose: RelativePose) -> tuple[Array, Array, Array]:
        """Plane bounds (k,), normals (k, 3) and distances (k,) of the pairs (k,) at poses (k,)."""
        k = len(pair)
        values, normals, distances = np.empty(k), np.empty((k, 3)), np.empty(k)
        for i, here in by_pair(pair):
            found = self._parts[i].sample(pose.take(here))
            values[here], normals[here], distances[here] = found.bound, found.normal, found.distance
        return values, normals, distances

    def plane(self, pair: Index, pose: RelativePose, normals: Array) -> Array:
        """Plane bounds (k,) of given normals (k, 3), ‖n‖ ≤ 1, at poses (k,)."""
        values = np.empty(len(pair))
        for i, here in by_pair(pair):
            values[here] = self._parts[i].plane(pose.take(here), normals[here])
        return values

    def distances(self, pair: Index, t: Array) -> Array:
        """Exact distances (k,) of the pairs of parts (k,) at the times t (k,)."""
        pose = self.bodies.pose(t, self.bodies.cells(t))
        return self.query(pair, pose)[2]

    def _of_what_flies(self, intervals: Intervals, bound: Array) -> Array:
        """Less rounding and tube; what is not a number proves nothing."""
        less = bound - self.slack[intervals.pair]
        return np.where(np.isnan(less), -np.inf, less)


def by_pair(pair: Index) -> list[tuple[int, Index]]:
    """For each pair that is present its rows."""
    if not len(pair):
        return []
    order = np.argsort(pair, kind="stable")
    present, starts = np.unique(pair[order], return_index=True)
    return list(zip(present.tolist(), np.split(order, starts[1:]), strict=True))
