"""The binary container of glTF 2.0: one JSON chunk, one chunk of numbers (Khronos, §4.4)."""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

FLOAT, UNSIGNED_INT = 5126, 5125
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963
_KINDS = {1: "SCALAR", 3: "VEC3", 4: "VEC4"}
_MAGIC, _VERSION, _JSON, _BIN = 0x46546C67, 2, 0x4E4F534A, 0x004E4942


@dataclass
class Glb:
    """A file in the making.

    Attributes:
        document: the JSON; whoever builds the scene adds to it.
        data: the numbers so far.
    """

    document: dict[str, Any]
    data: bytearray = field(default_factory=bytearray)

    def add(self, values: npt.ArrayLike, *, target: int | None = None) -> int:
        """Store numbers, floats as float32 and whole ones as uint32; the accessor's index.

        Args:
            values: (k,) or (k, 3 or 4).
            target: what a buffer view is bound to; None for animations.
        """
        array = np.asarray(values)
        whole = array.dtype.kind in "iu"
        array = np.ascontiguousarray(array, dtype="<u4" if whole else "<f4")
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": array.nbytes}
        if target is not None:
            view["target"] = target
        # Every number takes four bytes, so each view begins at a multiple of four.
        self.data += array.tobytes()
        rows = array.reshape(len(array), -1)
        accessor = {
            "bufferView": self.append("bufferViews", view),
            "componentType": UNSIGNED_INT if whole else FLOAT,
            "count": len(rows),
            "type": _KINDS[rows.shape[1]],
            "min": rows.min(axis=0).tolist(),
            "max": rows.max(axis=0).tolist(),
        }
        return self.append("accessors", accessor)

    def append(self, key: str, item: Any) -> int:
        """Add to one of the document's lists; the index of what was added."""
        items: list[Any] = self.document.setdefault(key, [])
        items.append(item)
        return len(items) - 1

    def write(self, path: Path) -> None:
        """Write header and chunks, each padded to a multiple of four bytes."""
        document = {**self.document, "buffers": [{"byteLength": len(self.data)}]}
        text = json.dumps(document, allow_nan=False, separators=(",", ":")).encode("ascii")
        text += b" " * (-len(text) % 4)
        data = bytes(self.data) + b"\0" * (-len(self.data) % 4)
        total = 12 + 8 + len(text) + 8 + len(data)
        path.write_bytes(
            struct.pack("<III", _MAGIC, _VERSION, total)
            + struct.pack("<II", len(text), _JSON) + text
            + struct.pack("<II", len(data), _BIN) + data
        )  # fmt: skip
