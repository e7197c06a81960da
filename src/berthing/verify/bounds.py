"""Bounds on the clearance of the pairs of parts of two bodies, at instants and over intervals."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.body_motion import Index
from berthing.verify.interval_bounds import chord_bound
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
        # A half-space has one plane: it adds no length but its distance from the origin.
        about_b = np.where(np.isfinite(self._radius_b), self._radius_b, 0.0)
        extent = norm(self._centre_b) + self._radius + about_b
        rounding = settings.float_slack * (bodies.length(self._offset) + extent)
        self.slack = rounding + np.array(tubes_m)

    def motion(self, intervals: Intervals) -> tuple[RelativeMotion, Array]:
        """Of the parts' centres about the middles, and half the lengths."""
        middle, half = intervals.middle, 0.5 * (intervals.t1 - intervals.t0)
        cells = self.bodies.cells(middle)
        return self.bodies.motion(middle, half, cells, self._offset[intervals.pair]), half

    def away(self, pair: Index, pose: RelativePose) -> Array:
        """From the centres of balls about A's parts to those about B's (k, 3)."""
        centre = pose.position + (pose.rotation @ self._offset[pair, :, None])[:, :, 0]
        return np.asarray(self._centre_b[pair] - centre)

    def of_balls(self, pair: Index, pose: RelativePose, normals: Array) -> Array:
        """Plane bounds (k,) of normals (k, 3) on the balls, which those on the parts reach."""
        along = np.einsum("ki,ki->k", normals, self.away(pair, pose))
        return np.asarray(along - norm(normals) * (self._radius[pair] + self._radius_b[pair]))

    def over(self, intervals: Intervals, motion: RelativeMotion, half: Array) -> Array:
        """From the plane bounds and normals at the ends; −∞ where they are not known."""
        radius = self._radius[intervals.pair]
        values, normals = intervals.values, intervals.normals
        bound = chord_bound(values, normals, motion, half, radius, self._inflation)
        # Less rounding and tube; what is not a number proves nothing.
        less = bound - self.slack[intervals.pair]
        return np.where(np.isnan(less), -np.inf, less)

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


def by_pair(pair: Index) -> list[tuple[int, Index]]:
    """For each pair that is present its rows."""
    if not len(pair):
        return []
    order = np.argsort(pair, kind="stable")
    present, starts = np.unique(pair[order], return_index=True)
    return list(zip(present.tolist(), np.split(order, starts[1:]), strict=True))
