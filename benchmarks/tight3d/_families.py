"""The families by name."""

from __future__ import annotations

import zlib
from collections.abc import Callable

import numpy as np

from benchmarks.tight3d import _bend, _clutter, _corridor, _dock, _truss, _two, _window
from benchmarks.tight3d._scene import Case

FAMILIES: dict[str, Callable[[str, int, np.random.Generator], Case]] = {
    "corridor": _corridor.make,
    "window": _window.make,
    "bend": _bend.make,
    "dock": _dock.make,
    "clutter": _clutter.make,
    "truss": _truss.make,
    "two": _two.make,
}


def made(family: str, seed: int) -> Case:
    """The case of that family and seed; the same on every machine."""
    rng = np.random.default_rng([zlib.crc32(family.encode()), seed])
    return FAMILIES[family](family, seed, rng)
