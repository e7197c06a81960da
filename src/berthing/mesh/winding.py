"""How often a closed surface goes around a point: 1 inside a solid, 0 outside."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.mesh.solid import Surface

# Points times triangles at once.
CHUNK = 1 << 21


def winding_number(surface: Surface, points: Array) -> Array:
    """Winding numbers (k,) of the surface about points (k, 3) off it: whole but for rounding.

    Sum of the solid angles of the triangles over 4π, each by van Oosterom and Strackee,
    *The solid angle of a plane triangle*, 1983:
    tan(Ω/2) = det[a, b, c] / (|a||b||c| + (a·b)|c| + (b·c)|a| + (c·a)|b|).
    """
    step = max(1, CHUNK // len(surface.triangles))
    corners = np.moveaxis(surface.corners, 1, 0)
    parts = [_solid_angles(corners, points[i : i + step]) for i in range(0, len(points), step)]
    return np.concatenate([np.empty(0), *parts]) / (4.0 * np.pi)


def _solid_angles(corners: Array, points: Array) -> Array:
    a, b, c = (corner[None] - points[:, None] for corner in corners)
    la, lb, lc = (np.sqrt(_dot(v, v)) for v in (a, b, c))
    det = _dot(a, np.cross(b, c))
    flat = la * lb * lc + _dot(a, b) * lc + _dot(b, c) * la + _dot(c, a) * lb
    return np.asarray(2.0 * np.arctan2(det, flat).sum(axis=1))


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.einsum("...i,...i->...", a, b))
