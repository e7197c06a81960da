"""Hulls of points of space, and what of them a piece needs: volume, faces, fewer faces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import ConvexHull, HalfspaceIntersection, QhullError

from berthing.geometry.arrays import Array

# Of unit normals: faces that a cut meant to be one plane differ by rounding, about 1e-7.
SAME_PLANE_DEG = 1e-3


@dataclass(frozen=True, eq=False)
class HalfSpaces:
    """{x : A x ≤ b}, bounded.

    Attributes:
        A: unit rows (m, 3).
        b: (m,) in metres.
        volume: in m³.
        spike: the most by which a corner is above a face of the hull that was simplified, in
            metres: how far it stands out.
    """

    A: Array
    b: Array
    volume: float
    spike: float


def hull_volume(points: Array) -> float:
    """Of the hull of points (n, 3), in m³; 0 where they lie in one plane."""
    try:
        return float(ConvexHull(points).volume)
    except QhullError:
        return 0.0


def outer_bound(points: Array, angle_deg: float) -> HalfSpaces | None:
    """A polytope with few faces that contains points (n, 3): hull faces, joined.

    The largest face left takes with it all those whose normals are within the angle of its own;
    the offset is the support value of the points, so every point satisfies every row, whichever
    normals are kept. None where the faces kept do not enclose a bounded set, or where the points
    lie in one plane.
    """
    try:
        hull = ConvexHull(points)
    except QhullError:
        return None
    A = _kept_normals(hull, np.cos(np.radians(max(angle_deg, SAME_PLANE_DEG))))
    b = np.max(A @ points.T, axis=1)
    try:
        with np.errstate(divide="ignore", invalid="ignore"):  # corners at infinity
            found = HalfspaceIntersection(np.column_stack([A, -b]), points.mean(axis=0))
        # The polar set of a bounded one has the origin, which stands for the mean, inside it.
        if not np.all(found.dual_equations[:, -1] < 0.0):
            return None
        volume = float(ConvexHull(found.intersections).volume)
    except QhullError:
        return None
    kept = np.unique(np.concatenate([np.asarray(f) for f in found.dual_facets]))
    above = found.intersections @ hull.equations[:, :3].T + hull.equations[:, 3]
    return HalfSpaces(A[kept], b[kept], volume, float(np.max(above)))


def _kept_normals(hull: ConvexHull, cosine: float) -> Array:
    """Normals (m, 3) of the faces that stand for the others."""
    normals = hull.equations[:, :3]
    a, b, c = np.moveaxis(hull.points[hull.simplices], 1, 0)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    left = np.ones(len(normals), dtype=np.bool_)
    kept = []
    for i in np.argsort(-areas, kind="stable"):
        if left[i]:
            kept.append(normals[i])
            left &= normals @ normals[i] < cosine
    rows = np.array(kept)
    return np.asarray(rows / np.linalg.norm(rows, axis=1, keepdims=True))
