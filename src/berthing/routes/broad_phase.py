"""Which of many balls at rest come near a point: k-d trees of SciPy, one a class of size.

The collision library has a tree of boxes, but its Python side cannot tell which of them met.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from berthing.geometry.arrays import Array

Index = npt.NDArray[np.intp]

# Up to so many balls are looked at one by one, which takes as long as asking a tree.
FEW = 64


class BroadPhase:
    """Balls at rest, found by their gap.

    Args:
        centres: (n, 3) in metres.
        radii: (n,) in metres; infinite ones are near everything.
    """

    def __init__(self, centres: Array, radii: Array) -> None:
        self._centres, self._radii = centres, radii
        # Radii within a factor of two share a tree, which is asked with the largest of them.
        octave = np.where(radii > 0.0, np.ceil(np.log2(np.maximum(radii, 1e-300))), -np.inf)
        whole = len(radii) <= FEW
        classes = [np.arange(len(radii))] if whole else [
            np.flatnonzero(octave == own) for own in np.unique(octave)
        ]  # fmt: skip
        self._classes = [
            (own, None if whole or np.isinf(radii[own[0]]) else cKDTree(centres[own]))
            for own in classes
            if len(own)
        ]

    def near(self, points: Array, reach_m: Array | float) -> tuple[Index, Index]:
        """Pairs (point, ball) of points (k, 3) whose gap to the ball is ``reach_m`` (k,) at most.

        Sorted by point, then by ball.
        """
        reach = np.broadcast_to(np.asarray(reach_m, dtype=np.float64), (len(points),))
        found = [self._of_class(points, reach, *own) for own in self._classes]
        rows, balls = (np.concatenate(column) for column in zip(*found, strict=True))
        order = np.lexsort((balls, rows)) if len(self._classes) > 1 else slice(None)
        return rows[order], balls[order]

    def _of_class(
        self, points: Array, reach: Array, own: Index, tree: cKDTree | None
    ) -> tuple[Index, Index]:
        if tree is None:
            away = np.linalg.norm(points[:, None] - self._centres[own], axis=-1)
            rows, columns = np.nonzero(away <= reach[:, None] + self._radii[own])
            return rows, own[columns]
        lists = tree.query_ball_point(points, reach + np.max(self._radii[own]), return_sorted=True)
        rows = np.repeat(np.arange(len(points)), [len(one) for one in lists])
        balls = own[np.concatenate([np.asarray(one, dtype=np.intp) for one in lists])]
        away = np.linalg.norm(points[rows] - self._centres[balls], axis=-1)
        close = away <= reach[rows] + self._radii[balls]
        return rows[close], balls[close]
