"""Errors that a user can act on: what is wrong, where, and what would be right."""

from __future__ import annotations


class BerthingError(Exception):
    """Base of every error that this package raises on purpose."""


class InputError(BerthingError):
    """A value that the caller gave cannot be used.

    Args:
        where: the place of the value: a file and key path, an argument, a shape.
        what: what is wrong with it, with the number found.
        expected: what would be right; empty where ``what`` says it already.
    """

    def __init__(self, where: str, what: str, expected: str = "") -> None:
        self.where = where
        self.what = what
        self.expected = expected
        tail = f" (expected {expected})" if expected else ""
        super().__init__(f"{where}: {what}{tail}")


class CapabilityError(BerthingError):
    """A shape, model or formulation was asked for something it does not have."""
