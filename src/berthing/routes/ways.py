"""Whether two routes go the same way.

Two are one way if straight rungs between them, clear of everything, lead from the one to the other
all along: the diagram of L. Jaillet and T. Siméon, Path Deformation Roadmaps
(10.1177/0278364908098411). Each can then be swept into the other; routes that cannot be so may
still be homotopic by a detour, so that this tells more ways apart than homotopy does, never fewer.
"""

from __future__ import annotations

import numpy as np

from berthing.clearance.signed_distance import Flags
from berthing.geometry.arrays import Array
from berthing.routes.checker import Checker
from berthing.routes.space import along, moved, stride

# States along each route that rungs join, and samples along a rung.
STATES, SAMPLES = 24, 16


def same_way(checker: Checker, one: Array, other: Array) -> bool:
    """Whether the routes (n + 1, V, 7) and (m + 1, V, 7), of the same ends, are one way."""
    shares = np.linspace(0.0, 1.0, STATES)
    a, b = (along(checker.space, path, shares) for path in (one, other))
    return _joined(_rungs(checker, a, b))


def _rungs(checker: Checker, a: Array, b: Array) -> Flags:
    """Which straight legs from states of the one to states of the other are clear at samples."""
    start = np.broadcast_to(a[:, None], (len(a), len(b), *a.shape[1:]))
    way = stride(start, np.broadcast_to(b[None], start.shape))
    clear = np.ones((len(a), len(b)), dtype=np.bool_)
    for fraction in np.linspace(0.0, 1.0, SAMPLES):
        rows, columns = np.nonzero(clear)
        states = moved(start[rows, columns], fraction * way[rows, columns])
        clear[rows, columns] = checker.valid_states(states)
    return clear


def _joined(clear: Flags) -> bool:
    """Whether steps ahead along one or both routes lead from the first rung to the last."""
    reached = np.zeros_like(clear)
    for i in range(len(clear)):
        for j in range(clear.shape[1]):
            before = i == j == 0 or np.any(reached[max(i - 1, 0) : i + 1, max(j - 1, 0) : j + 1])
            reached[i, j] = clear[i, j] and before
    return bool(reached[-1, -1])
