"""Fewer and shorter legs."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.routes.checker import Checker
from berthing.routes.region import Region
from berthing.routes.space import between, stride

TRIES = 150

# Samples of a shortcut, to a step of the search. What they miss the certificate finds.
SAMPLES_A_STEP = 2.0

# A shortcut saves at least this share of the way that it replaces, or it is not worth a new leg.
WORTH = 1e-3


def shortened(
    checker: Checker, path: Array, pad_m: float, region: Region, rng: np.random.Generator,
    tries: int = TRIES,
) -> Array:  # fmt: skip
    """The path (n + 1, V, 7) with straight shortcuts that are clear, pad included, at samples."""
    path = _halved(checker, path, pad_m, region)
    lengths = checker.space.length(stride(path[:-1], path[1:]))
    for _ in range(tries):
        if len(path) < 3:
            break
        along = np.concatenate([[0.0], np.cumsum(lengths)])
        first, second = np.sort(rng.uniform(0.0, along[-1], 2))
        i, j = (int(np.searchsorted(along, at, side="right")) - 1 for at in (first, second))
        j = min(j, len(lengths) - 1)
        if i >= j:
            continue
        a = _at(path, lengths, along, i, first)
        b = _at(path, lengths, along, j, second)
        length = float(checker.space.length(stride(a, b)))
        if length > (1.0 - WORTH) * (second - first):
            continue
        # Legs of the path may come nearer than its states.
        if np.all(checker.valid_states(np.stack([a, b]), pad_m)) and clear(
            checker, a, b, pad_m, region
        ):
            path = np.concatenate([path[: i + 1], [a, b], path[j + 1 :]])
            lengths = checker.space.length(stride(path[:-1], path[1:]))
            keep = np.append(lengths > 0.0, True)
            path, lengths = path[keep], lengths[keep[:-1]]
    return _halved(checker, path, pad_m, region)


def _halved(checker: Checker, path: Array, pad_m: float, region: Region) -> Array:
    """Straight from first to last where that is clear; else the same of both halves."""
    if len(path) < 3 or clear(checker, path[0], path[-1], pad_m, region):
        return path[[0, -1]]
    middle = len(path) // 2
    halves = path[: middle + 1], path[middle:]
    first, second = (_halved(checker, half, pad_m, region) for half in halves)
    return np.concatenate([first[:-1], second])


def clear(checker: Checker, a: Array, b: Array, pad_m: float, region: Region) -> bool:
    """Whether samples of the leg from a to b keep margins and pad."""
    length = float(checker.space.length(stride(a, b)))
    count = 2 + int(SAMPLES_A_STEP * length / region.step_m)
    middle = between(a, b, np.linspace(0.0, 1.0, count)[1:-1])
    return bool(np.all(checker.valid_states(middle, pad_m))) if len(middle) else True


def _at(path: Array, lengths: Array, along: Array, leg: int, where: float) -> Array:
    fraction = (where - along[leg]) / lengths[leg]
    return np.asarray(between(path[leg], path[leg + 1], np.array([fraction]))[0])
