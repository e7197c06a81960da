"""Shapes with fewer triangles where a body has more than a screen shows and a browser draws."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from scipy.spatial import ConvexHull, QhullError

from berthing.geometry.arrays import Array
from berthing.geometry.mesh import Mesh, hull_mesh

# Triangles of one body beyond which its parts are simplified: what a computer without a graphics
# card still draws in motion.
MOST_TRIANGLES = 10_000
# A part keeps this many, with which a ball still looks round.
LEAST_TRIANGLES = 100
# Products of a vertex and a direction worked out at once.
BLOCK = 4_000_000
GOLDEN_ANGLE = np.pi * (3.0 - np.sqrt(5.0))


def coarsened(meshes: Sequence[Mesh]) -> tuple[list[Mesh], float]:
    """The surfaces of a body's parts, simplified where they have too many triangles together.

    Args:
        meshes: of convex parts.

    Returns:
        The meshes, each inside the one that it stands for, and by how many metres at most.
    """
    cap = _cap([len(found.triangles) for found in meshes])
    pairs = [_simplified(found, cap) for found in meshes]
    return [found for found, _ in pairs], max((off for _, off in pairs), default=0.0)


def _cap(counts: Sequence[int]) -> int:
    """The most triangles of a part with which the body keeps to its own most."""
    left, cap = float(MOST_TRIANGLES), float(max(counts, default=0))
    for rank, count in enumerate(sorted(counts)):
        share = left / (len(counts) - rank)
        if count > share:
            cap = share
            break
        left -= count
    return max(int(cap), LEAST_TRIANGLES)


def _simplified(found: Mesh, cap: int) -> tuple[Mesh, float]:
    if len(found.triangles) <= cap:
        return found, 0.0
    # A closed surface with k corners has 2 k − 4 triangles.
    points = found.vertices[_extremes(found.vertices, cap // 2 + 2)]
    try:
        hull = ConvexHull(points)
    except QhullError:
        # Flat: a polygon, and its triangles cost little.
        return found, 0.0
    off = max(
        float(np.max(block @ hull.equations[:, :3].T + hull.equations[:, 3]))
        for block in np.array_split(found.vertices, _blocks(len(found.vertices), cap))
    )
    return hull_mesh(points[np.sort(hull.vertices)]), max(off, 0.0)


def _extremes(points: Array, count: int) -> npt.NDArray[np.int64]:
    """Which points (k, 3) lie farthest in one of ``count`` directions, spread evenly."""
    step = np.arange(count) + 0.5
    height, turn = 1.0 - 2.0 * step / count, GOLDEN_ANGLE * step
    around = np.sqrt(1.0 - height**2)
    directions = np.stack([around * np.cos(turn), around * np.sin(turn), height], axis=1)
    blocks = np.array_split(directions, _blocks(len(points), count))
    farthest = [np.argmax(block @ points.T, axis=1) for block in blocks]
    return np.asarray(np.unique(np.concatenate(farthest)))


def _blocks(rows: int, columns: int) -> int:
    return 1 + rows * columns // BLOCK
