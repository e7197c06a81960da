"""Decompositions that were made before, by the hash of all that they depend on."""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path
from typing import Any

from berthing.errors import InputError
from berthing.mesh.decomposition import Decomposition
from berthing.whole_file import write_whole

# Raise it where the same input gives other pieces: what was cached before is not used any more.
ALGORITHM = 2
FOLDER_VARIABLE = "BERTHING_CACHE"


def key(**inputs: Any) -> str:
    """SHA-256, in hex, of what a decomposition depends on."""
    text = json.dumps({"algorithm": ALGORITHM, **inputs}, sort_keys=True)
    return hashlib.sha256(text.encode("ascii")).hexdigest()


def recalled(name: str) -> Decomposition | None:
    """What was kept under that key; None where there is nothing, or nothing that is whole."""
    path = _path(name)
    try:
        return Decomposition.from_json(json.loads(path.read_bytes()), str(path))
    except (OSError, ValueError, InputError):
        return None


def keep(name: str, made: Decomposition) -> None:
    """Keep it for next time, if this user has a place for that."""
    path = _path(name)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        write_whole(path, json.dumps(made.to_json()))
    except OSError:
        # A cache is a convenience: without one the work is done again.
        return


def _path(name: str) -> Path:
    own = os.environ.get(FOLDER_VARIABLE)
    around = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    folder = Path(own) if own else Path(around, "berthing")
    return folder / "pieces" / f"{name}.json"
