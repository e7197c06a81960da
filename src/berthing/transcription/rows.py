"""Rows of the programme, each with a name, so that a failure can say which one it is."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array
from berthing.transcription.elements import Index


@dataclass(frozen=True)
class RowBlock:
    """Consecutive rows that share a label.

    Attributes:
        key: the same in two programmes where the rows mean the same.
        label: (index within the block) → name, made only when asked for.
        unit_scale: multiply a row's violation by this to get the unit named.
    """

    offset: int
    size: int
    key: str
    label: Callable[[int], str]
    unit_scale: float
    unit: str


class RowBook:
    """The rows in order."""

    def __init__(self) -> None:
        self._lower: list[Array] = []
        self._upper: list[Array] = []
        self.blocks: list[RowBlock] = []
        self.size = 0

    def add(
        self,
        count: int,
        lower: npt.ArrayLike,
        upper: npt.ArrayLike,
        label: Callable[[int], str],
        *,
        unit_scale: float = 1.0,
        unit: str = "",
        key: str = "",
    ) -> Index:
        """Append ``count`` rows between ``lower`` and ``upper``; returns their indices.

        Without a ``key`` the rows are known by their place.
        """
        self._lower.append(np.array(np.broadcast_to(np.asarray(lower, np.float64), count)))
        self._upper.append(np.array(np.broadcast_to(np.asarray(upper, np.float64), count)))
        block = RowBlock(self.size, count, key or f"#{len(self.blocks)}", label, unit_scale, unit)
        self.blocks.append(block)
        self.size += count
        return np.arange(block.offset, self.size)

    def block_of(self, row: int) -> RowBlock:
        """The block that a row is in."""
        return self.blocks[bisect_right(self.blocks, row, key=lambda block: block.offset) - 1]

    def bounds(self) -> tuple[Array, Array]:
        """Lower and upper bounds (size,)."""
        if not self._lower:
            return np.empty(0), np.empty(0)
        return np.concatenate(self._lower), np.concatenate(self._upper)

    def carry(self, values: Array, other: RowBook) -> Array:
        """``values`` (size,) of these rows on those of ``other``; zero where it has new ones."""
        mine = {block.key: block for block in self.blocks}
        out = np.zeros(other.size)
        for block in other.blocks:
            old = mine.get(block.key)
            if old is not None and old.size == block.size:
                out[block.offset : block.offset + block.size] = values[
                    old.offset : old.offset + old.size
                ]
        return out

    def worst(self, values: Array) -> str:
        """Name of the row that ``values`` (size,) violates most, and by how much."""
        if not self.size:
            return "no rows"
        lower, upper = self.bounds()
        violation = np.maximum(np.maximum(lower - values, values - upper), 0.0)
        i = int(np.argmax(violation))
        block = self.block_of(i)
        amount = violation[i] * block.unit_scale
        return f"{block.label(i - block.offset)} short by {amount:.3g} {block.unit}".rstrip()
