"""A proven maximum over all directions of a function that is convex and homogeneous.

On the cone of unit vectors u_i, any unit vector is u = Σ α_i u_i with α ≥ 0 and Σ α_i at most
1/d, d being the distance from the origin to the plane (in the plane: line) through the u_i. For g
sublinear there, g(u) ≤ Σ α_i g(u_i) ≤ max_i g(u_i)⁺ / d. Halving the edges brings d to 1.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

import numpy as np

from berthing.geometry.arrays import Array

# What is proven may exceed the truth by this fraction.
RELATIVE_TOLERANCE = 1e-3
# Times that edges are halved at most: from 90° to 0.4°, when 1/d is 1 + 6e-6. A cone almost as
# wide as a half-space takes a few more to get to 90°.
MAX_HALVINGS = 12

Homogeneous = Callable[[Array], Array]


def orthants(dim: int) -> Array:
    """Cones (2^dim, dim, dim) that cover all directions, one unit vector a row."""
    signs = np.array(list(product((-1.0, 1.0), repeat=dim)))
    return signs[:, :, None] * np.eye(dim)


def largest(g: Homogeneous, cones: Array) -> float:
    """An upper bound, at most 0.1% above, on the maximum of g over unit vectors, and on 0.

    Args:
        g: of unit vectors (k, d), values (k,); sublinear on each of the cones.
        cones: (n, d, d), d linearly independent vectors of any length each.
    """
    cones = cones / np.linalg.norm(cones, axis=-1, keepdims=True)
    values = _at_corners(g, cones)
    best, settled = 0.0, 0.0
    for _ in range(MAX_HALVINGS):
        best = max(best, float(np.max(values)))
        bounds = _bounds(cones, values)
        open_ = bounds > (1.0 + RELATIVE_TOLERANCE) * best
        settled = max(settled, float(np.max(bounds[~open_], initial=0.0)))
        if not open_.any():
            return settled
        cones = _halved(cones[open_])
        values = _at_corners(g, cones)
    return max(settled, float(np.max(_bounds(cones, values))))


def _bounds(cones: Array, values: Array) -> Array:
    ones = np.ones((*cones.shape[:-1], 1))
    stretch = np.linalg.norm(np.linalg.solve(cones, ones)[..., 0], axis=-1)
    return np.asarray(np.maximum(np.max(values, axis=-1), 0.0) * stretch)


def _halved(cones: Array) -> Array:
    """Each cone of two vectors cut in two, each of three in four."""

    def middle(i: int, j: int) -> Array:
        between = cones[:, i] + cones[:, j]
        return np.asarray(between / np.linalg.norm(between, axis=-1, keepdims=True))

    if cones.shape[-1] == 2:
        a, b, m = cones[:, 0], cones[:, 1], middle(0, 1)
        parts = [(a, m), (m, b)]
        return np.concatenate([np.stack(part, axis=1) for part in parts])
    a, b, c = cones[:, 0], cones[:, 1], cones[:, 2]
    ab, bc, ca = middle(0, 1), middle(1, 2), middle(2, 0)
    quarters = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return np.concatenate([np.stack(quarter, axis=1) for quarter in quarters])


def _at_corners(g: Homogeneous, cones: Array) -> Array:
    """g at every corner (n, d); corners that coincide are asked for once."""
    corners = cones.reshape(-1, cones.shape[-1])
    once, where = np.unique(corners, axis=0, return_inverse=True)
    return np.asarray(g(once)[where.reshape(-1)].reshape(cones.shape[:-1]))
