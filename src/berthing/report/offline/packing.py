"""Numbers as the page carries them: little-endian arrays in base64, each once."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
import numpy.typing as npt

# Types that the page reads, by the name that it knows them by.
TYPES = {"f32": "<f4", "f64": "<f8", "u16": "<u2", "u32": "<u4"}


class Packing:
    """Collects arrays; equal ones are kept once, so that plans compared share their shapes.

    Attributes:
        buffers: the base64 texts that references count.
    """

    def __init__(self) -> None:
        self.buffers: list[str] = []
        self._known: dict[bytes, int] = {}

    def floats(self, values: npt.ArrayLike) -> dict[str, Any]:
        """A reference to values kept to seven digits, which no screen resolves; NaN stays."""
        return self._add(np.asarray(values), "f32")

    def exact(self, values: npt.ArrayLike) -> dict[str, Any]:
        """A reference to values kept as they are, for times: their steps may be tiny."""
        return self._add(np.asarray(values), "f64")

    def indices(self, values: npt.ArrayLike) -> dict[str, Any]:
        """A reference to whole numbers from 0, in two bytes each where they fit."""
        whole = np.asarray(values)
        return self._add(whole, "u16" if whole.max(initial=0) < 1 << 16 else "u32")

    def _add(self, values: npt.NDArray[Any], kind: str) -> dict[str, Any]:
        with np.errstate(over="ignore"):
            raw = np.ascontiguousarray(values, dtype=TYPES[kind]).tobytes()
        if raw not in self._known:
            self._known[raw] = len(self.buffers)
            self.buffers.append(base64.b64encode(raw).decode("ascii"))
        return {"b": self._known[raw], "t": kind, "n": list(values.shape)}
