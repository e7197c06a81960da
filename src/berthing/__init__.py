"""Plan collision-free, optimal motion for full-shape rigid bodies in tight spaces.

>>> import berthing as bt
>>> bt.load("free-space").name
'free-space'
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from berthing.planner import plan
    from berthing.scenario.files import from_document, load
    from berthing.verify.folder import verify_folder

__all__ = ["from_document", "load", "plan", "verify_folder"]

# Loaded when first asked for, so that `berthing.verify` never brings the solver along.
_HOMES = {
    "plan": "berthing.planner",
    "load": "berthing.scenario.files",
    "from_document": "berthing.scenario.files",
    "verify_folder": "berthing.verify.folder",
}


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        return getattr(import_module(_HOMES[name]), name)
    raise AttributeError(f"module 'berthing' has no attribute {name!r}")
