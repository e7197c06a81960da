"""Triangles cut into smaller ones."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.mesh.boxes_tree import Indices


def cut_triangles(corners: Array, longest: float) -> tuple[Array, Indices]:
    """Triangles (n, 3, 3) halved across their longest edges until none is longer.

    Returns:
        The small triangles (k, 3, 3), turned as the large ones, and which of those each is of.
    """
    done, owners = [np.empty((0, 3, 3))], [np.empty(0, dtype=np.int64)]
    owner = np.arange(len(corners), dtype=np.int64)
    while len(corners):
        edges = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
        small = edges.max(axis=1) <= longest
        done.append(corners[small])
        owners.append(owner[small])
        corners, owner, edges = corners[~small], owner[~small], edges[~small]
        # Turn each so that its longest edge is the first.
        turn = (np.argmax(edges, axis=1)[:, None] + np.arange(3)) % 3
        a, b, c = np.moveaxis(np.take_along_axis(corners, turn[:, :, None], axis=1), 1, 0)
        middle = 0.5 * (a + b)
        halves = [np.stack([a, middle, c], axis=1), np.stack([middle, b, c], axis=1)]
        corners, owner = np.concatenate(halves), np.tile(owner, 2)
    return np.concatenate(done), np.concatenate(owners)
