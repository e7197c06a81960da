"""Which of the cases that ship must come out certified."""

from __future__ import annotations

from berthing.scenario.files import load
from berthing.scenario.library import library


def to_be_certified() -> list[str]:
    """All but those that are planned by models inside their shapes, to show what comes of it."""
    return [name for name in library() if not planned_smaller(name)]


def planned_smaller(name: str) -> bool:
    """Whether a part of the case is planned smaller than it is."""
    scenario = load(name)
    pairs = [pair for phase in scenario.phases for pair in scenario.pairs(phase)]
    return any(part.planned_smaller for pair in pairs for part in (pair.part_a, pair.part_b))
