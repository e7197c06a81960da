"""Neighbouring parts joined where their common hull is hardly larger."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from berthing.geometry.arrays import Array
from berthing.mesh.hull import hull_volume

# Two parts are not joined where that adds more than this part of their volume.
LARGEST_GROWTH = 0.08


def joined(parts: Sequence[Array], spare_m3: float) -> list[Array]:
    """Parts, points (k, 3) each, with the cheapest pairs joined until the spare volume is used.

    Args:
        spare_m3: by how much the sum of the hulls may grow.
    """
    clouds = {i: np.asarray(points) for i, points in enumerate(parts)}
    volumes = {i: hull_volume(points) for i, points in clouds.items()}
    growth = {(i, j): _growth(i, j, clouds, volumes) for i in clouds for j in clouds if i < j}
    while growth:
        (i, j), least = min(growth.items(), key=lambda item: (item[1], item[0]))
        if least > spare_m3:
            break
        spare_m3 -= max(least, 0.0)
        new = max(clouds) + 1
        clouds[new] = np.concatenate([clouds.pop(i), clouds.pop(j)])
        volumes[new] = hull_volume(clouds[new])
        growth = {pair: g for pair, g in growth.items() if not {i, j} & set(pair)}
        growth |= {(k, new): _growth(k, new, clouds, volumes) for k in clouds if k != new}
    return list(clouds.values())


def _growth(i: int, j: int, clouds: dict[int, Array], volumes: dict[int, float]) -> float:
    """What joining adds; infinite where it is too much, or where the parts do not touch."""
    a, b = clouds[i], clouds[j]
    room = 1e-3 * float(np.linalg.norm(np.ptp(a, axis=0)))
    if np.any(a.min(axis=0) > b.max(axis=0) + room) or np.any(b.min(axis=0) > a.max(axis=0) + room):
        return np.inf
    apart = volumes[i] + volumes[j]
    added = hull_volume(np.concatenate([a, b])) - apart
    return added if added <= LARGEST_GROWTH * apart else np.inf
