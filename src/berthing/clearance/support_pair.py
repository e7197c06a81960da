"""Distances of sets apart by the algorithm of Gilbert, Johnson and Keerthi."""

from __future__ import annotations

import numpy as np

from berthing.clearance.answer import Answer
from berthing.clearance.min_norm import nearest_weights
from berthing.clearance.searched_pair import TOUCHING, SearchedPair
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import norm

# Between the witnesses' distance and what the plane proves, in terms of the sizes.
GAP = 1e-11
MAX_STEPS = 200


class SupportPair(SearchedPair):
    """For any sets. Slow: one pose and one direction at a time.

    The vector from A to B of least length is sought in the hull of such vectors between support
    points (Gilbert, Johnson and Keerthi, IEEE J. Robotics and Automation 4, 1988): each step adds
    that of the current direction. All of its points stay members, and the plane of its direction
    proves what is left to gain.
    """

    def apart(self, rotation: Array, position: Array) -> list[Answer]:
        return [self._apart(*pose) for pose in zip(rotation, position, strict=True)]

    def _apart(self, rotation: Array, position: Array) -> Answer:
        on_a = on_b = np.zeros((0, self.dim))
        weights, best = np.ones(0), None
        across = position if norm(position) > 0.0 else np.eye(self.dim)[0]
        for _ in range(MAX_STEPS):
            length = float(norm(across))
            normal = across / length
            proven, new_a, new_b = self._support(normal, rotation, position)
            if best is None or length - proven < best.distance - best.proven:
                witnesses = (weights @ on_a, weights @ on_b) if len(weights) else (new_a, new_b)
                best = Answer(length, normal, *witnesses, proven)
            known = np.any(np.all(on_b - on_a == new_b - new_a, axis=1))
            if len(weights) and (known or length - proven <= GAP * self.size):
                break
            on_a, on_b = np.vstack([on_a, new_a]), np.vstack([on_b, new_b])
            weights = nearest_weights(on_b - on_a, np.append(weights, 0.0))
            used = weights > 0.0
            on_a, on_b, weights = on_a[used], on_b[used], weights[used]
            across = weights @ (on_b - on_a)
            if norm(across) <= TOUCHING * self.size:
                return Answer(0.0, normal, weights @ on_a, weights @ on_b, proven)
        assert best is not None
        return best

    def _support(self, n: Array, rotation: Array, position: Array) -> tuple[float, Array, Array]:
        """The plane bound of n, and the points of A and of B that are nearest along n."""
        extent_a, point_a = self.a.support(n)
        extent_b, point_b = self.b.support(-(n @ rotation))
        proven = float(n @ position - extent_a - extent_b)
        return proven, point_a, rotation @ point_b + position
