"""The faces of a polytope as polygons."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array
from berthing.geometry.polytope import Polytope
from berthing.mesh.subtract import split

Rows = npt.NDArray[np.int64]

# Of the polytope's size: corners this near to a plane count as on it when neighbours are sought.
# A row that is missed leaves a face larger, one too many changes nothing.
ON_PLANE = 1e-6
# Of the polytope's size: faces are cut this much outside, so that rounding never cuts one short.
ROOM = 1e-12


def faces(core: Polytope) -> list[Array]:
    """For each row of the polytope a polygon (k, 3), corners in order, no smaller than its face."""
    size = core.bounding_radius
    on = np.abs(core.corners @ core.A.T - core.b) <= ON_PLANE * size
    touching = on.T.astype(np.int64) @ on.astype(np.int64)
    return [
        _face(core, i, core.corners[on[:, i]], np.flatnonzero(touching[i] >= 2), ROOM * size)
        for i in range(len(core.b))
        if np.any(on[:, i])
    ]


def _face(core: Polytope, i: int, corners: Array, neighbours: Rows, room: float) -> Array:
    """A square in the plane of row i, cut by its neighbours."""
    middle = corners.mean(axis=0)
    reach = 2.0 * float(np.max(np.linalg.norm(corners - middle, axis=1))) + room
    first = np.cross(core.A[i], np.eye(3)[np.argmin(np.abs(core.A[i]))])
    first *= reach / np.linalg.norm(first)
    second = np.cross(core.A[i], first)
    polygon: Array = middle + np.array([first, second, -first, -second])
    for j in neighbours:
        height = polygon @ core.A[j] - core.b[j] - room
        if j != i and np.max(height) > 0.0 >= np.min(height):
            polygon = split(polygon, height)[0]
    return polygon
