"""The distance of one pair of sets at many poses, as bare arrays: compiled where that can be."""

from __future__ import annotations

import numpy as np

from berthing.clearance.kernel import BY_A, BY_B, DISTANCE, WIDTH, kernel
from berthing.clearance.queried_distance import queried_distance
from berthing.clearance.set_numbers import set_numbers
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose

# How near to the true distance a search has to come, in metres, apart and overlapping. Routes
# keep further than that from margins, and no certificate rests on it.
APART_M, OVERLAP_M = 1e-9, 1e-3


class FramesQuery:
    """Distances of A and B, many poses, without the checks that one pose costs most by.

    Args:
        a, b: sets of the same dimension.
    """

    def __init__(self, a: ConvexSet, b: ConvexSet) -> None:
        self._a, self._b = a, b
        numbers_a, numbers_b = set_numbers(a), set_numbers(b)
        self._compute = None
        if numbers_a is not None and numbers_b is not None:
            self._compute = kernel()
            self._numbers = numbers_a, numbers_b
            self._addresses = numbers_a.ctypes.data, numbers_b.ctypes.data

    def __call__(self, turn_a: Array, place_a: Array, turn_b: Array, place_b: Array) -> Array:
        """Rows (k, 24) at rotations (k or 1, 3, 3) and origins (k or 1, 3), planar ones at z = 0.

        The last axes of all four are contiguous.
        """
        rows = np.empty((max(len(turn_a), len(turn_b)), WIDTH))
        if self._compute is None:
            return self._slowly(rows, turn_a, place_a, turn_b, place_b)
        # All or one: poses follow each other at a fixed distance in memory, or stand still.
        turn_a, place_a, step_a = _steps(turn_a, place_a)
        turn_b, place_b, step_b = _steps(turn_b, place_b)
        done = self._compute(
            *self._addresses, self._a.dim, len(rows),
            turn_a.ctypes.data, place_a.ctypes.data, step_a,
            turn_b.ctypes.data, place_b.ctypes.data, step_b,
            APART_M, OVERLAP_M, rows.ctypes.data,
        )  # fmt: skip
        if done < 0:
            raise MemoryError("no memory for the distance search")
        return rows

    def _slowly(
        self, rows: Array, turn_a: Array, place_a: Array, turn_b: Array, place_b: Array
    ) -> Array:
        d = self._a.dim
        found = queried_distance(
            self._a, _spread(turn_a, place_a, len(rows), d),
            self._b, _spread(turn_b, place_b, len(rows), d),
        )  # fmt: skip
        rows[:] = 0.0
        rows[:, DISTANCE] = found.distance
        axes = [0, 1, 5] if d == 2 else list(range(6))
        for columns, gradient in ((BY_A, found.gradient_a), (BY_B, found.gradient_b)):
            rows[:, columns][:, axes] = gradient
        return rows


def _spread(turn: Array, place: Array, count: int, d: int) -> Pose:
    """So many poses, of as many or of one."""
    turns = np.broadcast_to(turn[:, :d, :d], (count, d, d))
    return Pose.sound(np.broadcast_to(place[:, :d], (count, d)), turns)


def _steps(turn: Array, place: Array) -> tuple[Array, Array, int]:
    if len(turn) == 1:
        return turn, place, 0
    step = turn.strides[0] // (9 * turn.itemsize)
    if place.strides[0] != 3 * step * place.itemsize:
        turn, place, step = np.ascontiguousarray(turn), np.ascontiguousarray(place), 1
    return turn, place, step
