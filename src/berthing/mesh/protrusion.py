"""How far points stand out of a solid: for pictures and tables, not for proofs."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from berthing.geometry.arrays import Array
from berthing.mesh.boxes_tree import Indices
from berthing.mesh.solid import Surface
from berthing.mesh.tessellate import cut_triangles

# The surface is sampled this finely, in parts of its size, to find which triangles are near.
SAMPLING = 0.02
# Triangles that are looked at for each point.
NEAREST = 12
# Of the size: distances that differ by less belong to one edge or corner.
TIE = 1e-9


def protrusion(surface: Surface, points: Array) -> Array:
    """Distances (k,) in metres of points (k, 3) outside the solid; 0 for those inside."""
    corners, owner = cut_triangles(surface.corners, SAMPLING * surface.size)
    tree = cKDTree(corners.mean(axis=1))
    found = np.atleast_2d(tree.query(points, k=min(NEAREST, len(corners)))[1])
    near = owner[found.reshape(len(points), -1)]
    offset = np.stack([_offset(surface, near[:, i], points) for i in range(near.shape[1])], axis=1)
    distance = np.linalg.norm(offset, axis=2)
    least = distance.min(axis=1, keepdims=True)
    # Of the triangles that share the nearest point, the one seen most squarely tells the side.
    above = np.einsum("ijk,ijk->ij", offset, _normals(surface)[near])
    squarely = np.where(distance <= least + TIE * surface.size, np.abs(above), -1.0)
    side = np.take_along_axis(above, np.argmax(squarely, axis=1)[:, None], axis=1)
    return np.asarray(np.where(side > 0.0, least, 0.0)[:, 0])


def _normals(surface: Surface) -> Array:
    a, b, c = np.moveaxis(surface.corners, 1, 0)
    normal = np.cross(b - a, c - a)
    return np.asarray(normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300))


def _offset(surface: Surface, triangles: Indices, points: Array) -> Array:
    """Points less the nearest points of one triangle each (k, 3).

    Ericson, *Real-Time Collision Detection*, section 5.1.5, as a projection onto the face and
    onto the three edges, of which the nearest counts.
    """
    corners = surface.corners[triangles]
    candidates = [_to_segment(corners[:, i], corners[:, (i + 1) % 3], points) for i in range(3)]
    a, b, c = np.moveaxis(corners, 1, 0)
    normal = np.cross(b - a, c - a)
    square = np.maximum(_dot(normal, normal), 1e-300)
    foot = points - (_dot(points - a, normal) / square)[:, None] * normal
    inside = np.ones(len(points), dtype=np.bool_)
    for one, other in ((a, b), (b, c), (c, a)):
        inside &= _dot(np.cross(other - one, foot - one), normal) >= 0.0
    on_face = np.where(inside[:, None], points - foot, np.inf)
    every = np.stack([*candidates, on_face])
    best = np.argmin(np.einsum("nij,nij->ni", every, every), axis=0)
    return np.asarray(every[best, np.arange(len(points))])


def _to_segment(start: Array, end: Array, points: Array) -> Array:
    along = end - start
    share = _dot(points - start, along) / np.maximum(_dot(along, along), 1e-300)
    return np.asarray(points - start - np.clip(share, 0.0, 1.0)[:, None] * along)


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.einsum("ij,ij->i", a, b))
