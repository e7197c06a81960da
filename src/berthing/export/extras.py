"""Packages that only some formats need."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from berthing.errors import InputError


def extra(package: str) -> Any:
    """The module of the package, which ships no types that matter here.

    Raises:
        InputError: it is not installed; says how to get it.
    """
    try:
        return import_module(package)
    except ModuleNotFoundError as error:
        if error.name != package:
            raise
        how = f"pip install {package}, or berthing with its extra: pip install 'berthing[export]'"
        raise InputError(package, "is not installed, and this format needs it", how) from None
