"""Which of many axis-parallel boxes overlap: a binary tree of boxes, searched level by level."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array

Indices = npt.NDArray[np.int64]

# Bits an axis of the Morton code: 2²¹ cells an axis fill 63 bits.
MORTON_BITS = 21
# Pairs of nodes that are looked at together; more would need much memory and gain no speed.
BATCH = 1 << 20


@dataclass(frozen=True, eq=False)
class BoxTree:
    """Boxes in the order of a space-filling curve, joined two by two up to one.

    Attributes:
        order: which box stands at each leaf (n,).
        lower, upper: corners of the boxes of each level, the root's first; leaves that pad the
            last level to a power of two are empty (+∞, −∞).
    """

    order: Indices
    lower: tuple[Array, ...]
    upper: tuple[Array, ...]

    @staticmethod
    def of(lower: Array, upper: Array) -> BoxTree:
        """From corners (n, 3), n > 0."""
        order = np.argsort(_morton(0.5 * (lower + upper)), kind="stable")
        leaves = 1 << int(np.ceil(np.log2(len(order))))
        low, high = np.full((leaves, 3), np.inf), np.full((leaves, 3), -np.inf)
        low[: len(order)], high[: len(order)] = lower[order], upper[order]
        levels = [(low, high)]
        while len(levels[-1][0]) > 1:
            low, high = levels[-1]
            levels.append((low.reshape(-1, 2, 3).min(axis=1), high.reshape(-1, 2, 3).max(axis=1)))
        levels.reverse()
        return BoxTree(order, tuple(a for a, _ in levels), tuple(b for _, b in levels))

    def overlapping(self) -> Iterator[tuple[Indices, Indices]]:
        """Every pair of boxes (i, j), i ≠ j, that share a point, once; in batches."""
        root = np.zeros(1, dtype=np.int64)
        waiting = [(0, root, root)]
        while waiting:
            level, a, b = waiting.pop()
            if len(a) > BATCH:
                middle = len(a) // 2
                waiting += [(level, a[:middle], b[:middle]), (level, a[middle:], b[middle:])]
            elif level == len(self.lower) - 1:
                apart = a != b
                yield self.order[a[apart]], self.order[b[apart]]
            else:
                waiting.append((level + 1, *self._children(level + 1, a, b)))

    def _children(self, level: int, a: Indices, b: Indices) -> tuple[Indices, Indices]:
        same = a == b
        one = np.concatenate([2 * a, 2 * a, 2 * a + 1, 2 * a[~same] + 1])
        other = np.concatenate([2 * b, 2 * b + 1, 2 * b + 1, 2 * b[~same]])
        low, high = self.lower[level], self.upper[level]
        meet = np.all((low[one] <= high[other]) & (low[other] <= high[one]), axis=1)
        return one[meet], other[meet]


def _morton(points: Array) -> npt.NDArray[np.uint64]:
    """Codes (n,) whose order keeps near points (n, 3) near."""
    span = np.ptp(points, axis=0)
    share = (points - points.min(axis=0)) / np.where(span > 0.0, span, 1.0)
    cells = np.minimum(share * 2.0**MORTON_BITS, 2.0**MORTON_BITS - 1.0).astype(np.uint64)
    spread = _spread(cells)
    return np.asarray(
        spread[:, 0] | (spread[:, 1] << np.uint64(1)) | (spread[:, 2] << np.uint64(2))
    )


def _spread(x: npt.NDArray[np.uint64]) -> npt.NDArray[np.uint64]:
    """Put two zero bits between each two of the lower 21 (the usual masks of Morton codes)."""
    masks = (
        (32, 0x1F00000000FFFF),
        (16, 0x1F0000FF0000FF),
        (8, 0x100F00F00F00F00F),
        (4, 0x10C30C30C30C30C3),
        (2, 0x1249249249249249),
    )
    for shift, mask in masks:
        x = (x | (x << np.uint64(shift))) & np.uint64(mask)
    return x
