"""The one owner of packing: named blocks ↔ one vector, and physical units ↔ the solver's.

A block holds an array of physical values; in the vector it is stored scaled,
physical = shift + scale · stored, column-major, as casadi's vec does.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array


@dataclass(frozen=True)
class Block:
    """One named array: its place, shape, scaling and bounds (physical)."""

    name: str
    offset: int
    shape: tuple[int, int]
    scale: Array
    shift: Array
    lower: Array
    upper: Array

    @property
    def size(self) -> int:
        return self.shape[0] * self.shape[1]

    @property
    def indices(self) -> npt.NDArray[np.int64]:
        """Place of every entry in the vector, in the block's own shape."""
        return self.offset + np.arange(self.size).reshape(self.shape, order="F")


class Packing:
    """An ordered set of blocks."""

    def __init__(self) -> None:
        self.blocks: dict[str, Block] = {}
        self.size = 0

    def add(
        self,
        name: str,
        shape: tuple[int, int],
        *,
        scale: npt.ArrayLike = 1.0,
        shift: npt.ArrayLike = 0.0,
        lower: npt.ArrayLike = -np.inf,
        upper: npt.ArrayLike = np.inf,
    ) -> Block:
        """Append a block; scale, shift and bounds broadcast to its shape (rows first)."""
        if name in self.blocks:
            raise ValueError(f"two blocks are called {name!r}")
        grids = [_grid(v, shape) for v in (scale, shift, lower, upper)]
        block = Block(name, self.size, shape, *grids)
        self.blocks[name] = block
        self.size += block.size
        return block

    def bounds(self) -> tuple[Array, Array]:
        """Lower and upper bounds of the stored vector."""
        lower, upper = np.empty(self.size), np.empty(self.size)
        for block in self.blocks.values():
            part = slice(block.offset, block.offset + block.size)
            lower[part] = ((block.lower - block.shift) / block.scale).ravel(order="F")
            upper[part] = ((block.upper - block.shift) / block.scale).ravel(order="F")
        return lower, upper

    def carry(self, vector: Array, other: Packing, fallback: Array) -> Array:
        """The stored vector of these blocks in the order of ``other``'s, which must scale alike;
        ``fallback`` where a block of ``other`` is not among these."""
        out = fallback.copy()
        for block in other.blocks.values():
            old = self.blocks.get(block.name)
            if old is not None and old.shape == block.shape:
                out[block.offset : block.offset + block.size] = vector[
                    old.offset : old.offset + old.size
                ]
        return out

    def join(self, values: Mapping[str, npt.ArrayLike]) -> Array:
        """Physical arrays by name → stored vector. KeyError where a block is missing."""
        vector = np.empty(self.size)
        for block in self.blocks.values():
            stored = (_grid(values[block.name], block.shape) - block.shift) / block.scale
            vector[block.offset : block.offset + block.size] = stored.ravel(order="F")
        return vector

    def split(self, vector: Array) -> dict[str, Array]:
        """Stored vector → physical arrays by name."""
        out = {}
        for block in self.blocks.values():
            stored = vector[block.offset : block.offset + block.size]
            out[block.name] = block.shift + block.scale * stored.reshape(block.shape, order="F")
        return out


def _grid(value: npt.ArrayLike, shape: tuple[int, int]) -> Array:
    if isinstance(value, float):
        # By far the commonest, and told apart much sooner than broadcast.
        return np.full(shape, value)
    array = np.asarray(value, dtype=np.float64)
    if array.shape == shape:
        return array.copy()
    if array.ndim == 1:
        array = array[:, None]
    return np.array(np.broadcast_to(array, shape))
