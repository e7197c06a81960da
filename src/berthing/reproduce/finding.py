"""A claim of the paper, and what was found of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

HOLDS, PARTLY, FAILS = "holds", "in part", "does not hold"
MEASURED = "measured"
"""Of what depends on the machine."""


@dataclass(frozen=True)
class Finding:
    """One claim.

    Attributes:
        where: in the paper.
        claim: what is said there, in other words.
        found: in words and numbers.
        verdict: ``HOLDS``, ``PARTLY`` or ``FAILS``, which follows from the values; or
            ``MEASURED``.
        values: the numbers, units in their names.
    """

    where: str
    claim: str
    found: str
    verdict: str
    values: Mapping[str, float]


def verdict(good: bool) -> str:
    """``HOLDS`` or ``FAILS``."""
    return HOLDS if good else FAILS
