"""Libraries of the extra ``mesh``, loaded when they are needed."""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from typing import Any

from berthing.errors import InputError


def optional(library: str) -> Any:
    """The library as a module.

    Raises:
        InputError: it is not installed; names the extra that brings it.
    """
    require(library)
    return import_module(library)


def require(library: str) -> None:
    """Raise InputError, naming the extra, unless the library is installed; it is not loaded."""
    if find_spec(library) is None:
        what = f"is not installed, and meshes need {library}"
        raise InputError(library, what, "pip install 'berthing[mesh]'")
