"""Where a surface crosses itself."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array
from berthing.mesh.boxes_tree import BoxTree, Indices
from berthing.mesh.solid import Surface

# A segment that passes a plane by less than this part of its length touches it.
TOUCHING = 1e-9
# A segment whose sine against a plane is below this lies along it: contact, not a crossing.
ALONG = 1e-12


def first_crossing(surface: Surface) -> tuple[int, Array] | None:
    """How many pairs of triangles cross, and a point (3,) where the first does; None if none do.

    An edge of one passes through the inside or the rim of the other. Triangles that only touch
    do not cross.
    """
    corners = surface.corners
    tree = BoxTree.of(corners.min(axis=1), corners.max(axis=1))
    count, first = 0, None
    for a, b in tree.overlapping():
        crossed, points = _cross(surface.triangles, corners, a, b)
        count += int(np.sum(crossed))
        if first is None and np.any(crossed):
            first = points[crossed][0]
    return None if first is None else (count, first)


def _cross(
    triangles: npt.NDArray[np.int64], corners: Array, a: Indices, b: Indices
) -> tuple[npt.NDArray[np.bool_], Array]:
    """Which pairs (k,) cross, and where (k, 3)."""
    crossed = np.zeros(len(a), dtype=np.bool_)
    points = np.zeros((len(a), 3))
    for one, other in ((a, b), (b, a)):
        for i, j in ((0, 1), (1, 2), (2, 0)):
            # An edge with an end on the other triangle's corner meets it there and nowhere else.
            ends = triangles[one][:, [i, j]]
            joined = np.any(ends[:, :, None] == triangles[other][:, None, :], axis=(1, 2))
            test = np.flatnonzero(~joined & ~crossed)
            hit, at = _pierced(corners[one[test], i], corners[one[test], j], corners[other[test]])
            crossed[test[hit]] = True
            points[test[hit]] = at[hit]
    return crossed, points


def _pierced(start: Array, end: Array, corners: Array) -> tuple[npt.NDArray[np.bool_], Array]:
    """Which segments (k, 3) pass through their triangle (k, 3, 3), and where (k, 3).

    Möller and Trumbore, *Fast, minimum storage ray/triangle intersection*, 1997.
    """
    along, e1, e2 = end - start, corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    p = np.cross(along, e2)
    det = _dot(e1, p)
    steep = np.abs(det) > ALONG * np.sqrt(_dot(along, along) * _dot(e1, e1) * _dot(e2, e2))
    inverse = 1.0 / np.where(steep, det, 1.0)
    s = start - corners[:, 0]
    q = np.cross(s, e1)
    u, v, t = _dot(s, p) * inverse, _dot(along, q) * inverse, _dot(e2, q) * inverse
    inside = (u >= 0.0) & (v >= 0.0) & (u + v <= 1.0)
    through = (t > TOUCHING) & (t < 1.0 - TOUCHING)
    return steep & inside & through, start + t[:, None] * along


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.einsum("ij,ij->i", a, b))
