"""From a path that is clear at samples to one whose every leg is certified."""

from __future__ import annotations

from berthing.geometry.arrays import Array
from berthing.routes.checker import Checker
from berthing.routes.legs import Legs
from berthing.routes.mended import ROUNDS, refined
from berthing.routes.sliding import Slider


def proven(checker: Checker, slides: Slider, path: Array) -> tuple[Array, Legs]:
    """The path (n + 1, V, 7), and what is proven of it; certified if that could be had.

    Where a leg comes too near something, the state there is pushed out and the leg goes through
    it, a few times over.
    """
    legs = checker.legs(path)
    for _ in range(ROUNDS):
        if legs.certified:
            break
        worst: dict[int, float] = {}
        for at in legs.trouble:
            leg = min(int(at), len(path) - 2)
            worst.setdefault(leg, at - leg)
        more = refined(slides, path, worst)
        if more is None:
            break
        path, legs = more, checker.legs(more)
    return path, legs
