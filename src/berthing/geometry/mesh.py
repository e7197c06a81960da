"""Triangle meshes for drawing; nothing is decided with them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
import numpy.typing as npt
from scipy.spatial import ConvexHull

from berthing.geometry.arrays import Array

Triangles = npt.NDArray[np.int64]

# Segments of a drawn circle: the chord lies 0.5% of the radius inside the arc.
CIRCLE_SEGMENTS = 32
# Directions in which a planar set is sampled that has no outline in closed form.
OUTLINE_DIRECTIONS = 128
# Samples nearer to each other than this fraction of the set's size are drawn as one.
MERGED = 1e-6
# Times that each triangle of the icosahedron is cut in four: 642 vertices, 1280 triangles.
SPHERE_SUBDIVISIONS = 3


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles, their corners counter-clockwise seen from outside.

    A three-dimensional shape gives a closed surface with vertices on the shape's boundary, hence
    inside the shape. A planar shape gives a polygon at z = 0 that faces +z.

    Attributes:
        vertices: (k, 3) in metres.
        triangles: (m, 3) indices into ``vertices``.
    """

    vertices: Array
    triangles: Triangles


def circle(radius: float, segments: int = CIRCLE_SEGMENTS) -> Array:
    """Points (segments, 2) of a circle about the origin, counter-clockwise."""
    angle = np.arange(segments) * (2.0 * np.pi / segments)
    return radius * np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def polygon_mesh(corners: Array) -> Mesh:
    """A convex polygon (k, 2), counter-clockwise, as a fan at z = 0."""
    count = len(corners)
    lifted = np.concatenate([corners, np.zeros((count, 1))], axis=1)
    second = np.arange(1, count - 1)
    return Mesh(lifted, np.stack([np.zeros_like(second), second, second + 1], axis=-1))


def hull_mesh(points: Array) -> Mesh:
    """The surface of the hull of points (k, 3), all of them extreme."""
    hull = ConvexHull(points)
    triangles = np.array(hull.simplices, dtype=np.int64)
    corners = points[triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inward = np.einsum("ij,ij->i", normal, hull.equations[:, :3]) < 0.0
    triangles[inward] = triangles[inward][:, ::-1]
    return Mesh(points, triangles)


def support_mesh(support: Callable[[Array], tuple[Array, Array]], dim: int) -> Mesh:
    """The hull of support points in directions spread evenly, for sets without a closed form."""
    directions = circle(1.0, OUTLINE_DIRECTIONS) if dim == 2 else unit_sphere().vertices
    points = support(directions)[1]
    points = points[_apart(points, MERGED * float(np.max(np.ptp(points, axis=0))))]
    hull = ConvexHull(points)
    if dim == 2:
        return polygon_mesh(points[hull.vertices])
    return hull_mesh(points[np.sort(hull.vertices)])


def _apart(points: Array, distance: float) -> npt.NDArray[np.int64]:
    """Indices of points of which no two share a cell of that size, give or take a cell's edge."""
    cells = np.round(points / distance)
    return np.asarray(np.sort(np.unique(cells, axis=0, return_index=True)[1]))


@cache
def unit_sphere() -> Mesh:
    """The unit sphere as a subdivided icosahedron."""
    golden = (1.0 + np.sqrt(5.0)) / 2.0
    base = [(0.0, s, t * golden) for s in (-1.0, 1.0) for t in (-1.0, 1.0)]
    points = np.array([p[i:] + p[:i] for p in base for i in range(3)])
    surface = hull_mesh(points / np.linalg.norm(points, axis=1, keepdims=True))
    for _ in range(SPHERE_SUBDIVISIONS):
        surface = _quartered(surface)
    return surface


def _quartered(surface: Mesh) -> Mesh:
    """Cut every triangle in four, the new vertices pushed out to the unit sphere."""
    t = surface.triangles
    edges = np.sort(np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]), axis=1)
    unique, where = np.unique(edges, axis=0, return_inverse=True)
    middle = surface.vertices[unique].mean(axis=1)
    middle /= np.linalg.norm(middle, axis=1, keepdims=True)
    m01, m12, m20 = np.split(where.reshape(-1) + len(surface.vertices), 3)
    quarters = [
        np.stack(corner, axis=-1)
        for corner in (
            (t[:, 0], m01, m20), (t[:, 1], m12, m01), (t[:, 2], m20, m12), (m01, m12, m20)
        )
    ]  # fmt: skip
    return Mesh(np.concatenate([surface.vertices, middle]), np.concatenate(quarters))
