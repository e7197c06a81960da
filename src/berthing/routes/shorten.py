"""Fewer and shorter legs."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.routes.sliding import Slider
from berthing.routes.space import Space, between, stride

TRIES = 150

# A shortcut saves at least this share of the way that it replaces, or it is not worth a new leg.
WORTH = 1e-3


def shortened(
    space: Space, slider: Slider, path: Array, rng: np.random.Generator, tries: int = TRIES
) -> Array:
    """The path (n + 1, V, 7) with straight shortcuts that are clear, pad included, at samples."""
    path = _halved(slider, path)
    lengths = space.length(stride(path[:-1], path[1:]))
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
        length = float(space.length(stride(a, b)))
        if length > (1.0 - WORTH) * (second - first):
            continue
        # Legs of the path may come nearer than its states.
        if slider.keeps(np.stack([a, b])) and slider.blocked(a, b) is None:
            path = np.concatenate([path[: i + 1], [a, b], path[j + 1 :]])
            lengths = space.length(stride(path[:-1], path[1:]))
            keep = np.append(lengths > 0.0, True)
            path, lengths = path[keep], lengths[keep[:-1]]
    return _halved(slider, path)


def _halved(slider: Slider, path: Array) -> Array:
    """Straight from first to last where that is clear; else the same of both halves."""
    if len(path) < 3 or slider.blocked(path[0], path[-1]) is None:
        return path[[0, -1]]
    middle = len(path) // 2
    halves = path[: middle + 1], path[middle:]
    first, second = (_halved(slider, half) for half in halves)
    return np.concatenate([first[:-1], second])


def _at(path: Array, lengths: Array, along: Array, leg: int, where: float) -> Array:
    fraction = (where - along[leg]) / lengths[leg]
    return np.asarray(between(path[leg], path[leg + 1], np.array([fraction]))[0])
