"""The signed distance from support functions alone: slow, and it does not fail.

It answers where the collision library does not: smooth bodies about one centre, planar ellipses
that overlap, queries that did not converge.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.capability import HasHalfspaces
from berthing.geometry.convex_set import ConvexSet, unit

# Directions tried first: neighbours are about 0.08 rad apart in space and 0.009 rad in the plane.
SAMPLES = {2: 720, 3: 2000}
SPACING_RAD = {2: 2.0 * np.pi / SAMPLES[2], 3: np.sqrt(4.0 * np.pi / SAMPLES[3])}
# Best samples refined; overlapping sets have several local maxima, most often in ± pairs.
STARTS = 6
# Directions tried about each of them, at the whole and at half the step.
RING = 12
SHRINK = 0.6
# Of the direction in rad; the bound is then off by 1e-10 of the size at a kink, far less elsewhere.
DIRECTION_TOLERANCE_RAD = 1e-10
# Gains below this fraction of the bound's size are rounding, and do not keep a step from shrinking.
GAIN_TOLERANCE = 1e-15
MAX_ROUNDS = 300
GOLDEN_ANGLE_RAD = np.pi * (3.0 - np.sqrt(5.0))


def best_normal(
    a: ConvexSet,
    b: ConvexSet,
    rotation: Array,
    position: Array,
    tolerance_rad: float = DIRECTION_TOLERANCE_RAD,
) -> Array:
    """A unit normal (d,) that maximises the plane bound of A and B, in A's frame.

    Args:
        a, b: sets of the same dimension d.
        rotation, position: pose of B in A's frame, (d, d) and (d,).
        tolerance_rad: of the direction.

    For sets apart the bound is concave in n where it is positive, so the maximum found is the
    distance. For sets that overlap it is the best of ``STARTS`` local maxima: the plane bound
    there still holds, but may overstate the depth.
    """

    def bound(n: Array) -> Array:
        return np.asarray(n @ position - a.support(n)[0] - b.support(-(n @ rotation))[0])

    tried = np.concatenate(
        [sphere_samples(SAMPLES[a.dim], a.dim), _candidates(a, b, rotation, position)]
    )
    values = bound(tried)
    starts = tried[np.argsort(-values)[:STARTS]]
    found = np.concatenate([starts, _refined(bound, starts, SPACING_RAD[a.dim], tolerance_rad)])
    return np.asarray(found[np.argmax(bound(found))])


def _candidates(a: ConvexSet, b: ConvexSet, rotation: Array, position: Array) -> Array:
    """Directions at which the bound often has a kink: axes, faces, and from centre to centre."""
    own = np.eye(a.dim)
    rows = [own, rotation.T]
    if isinstance(a, HasHalfspaces):
        rows.append(a.halfspaces()[0])
    if isinstance(b, HasHalfspaces):
        rows.append(b.halfspaces()[0] @ rotation.T)
    directions = np.concatenate(rows)
    centre = unit(position)
    return np.concatenate([directions, -directions, [centre] if centre.any() else own[:1]])


def _refined(
    bound: Callable[[Array], Array], starts: Array, spread: float, tolerance: float
) -> Array:
    """Local maxima of the bound from ``starts`` (m, d), all in step.

    Pattern search, for the bound has kinks: each round tries a ring of directions about each
    point, turned by the golden angle from round to round so that no cone of ascent is missed for
    long, and a point that gains nothing halves its ring, nearly.
    """
    n, value = starts.copy(), bound(starts)
    tangent = np.array([np.linalg.svd(start[None, :])[2][1:] for start in starts])
    step = np.full(len(starts), spread)
    for turn in range(MAX_ROUNDS):
        offsets = step[:, None, None] * (_ring(starts.shape[1], turn) @ tangent)
        tried = unit(n[:, None] + offsets)
        values = bound(tried)
        best = np.argmax(values, axis=1)[:, None]
        reached = np.take_along_axis(values, best, axis=1)[:, 0]
        better = reached > value + GAIN_TOLERANCE * np.abs(value)
        n[better] = np.take_along_axis(tried, best[..., None], axis=1)[better, 0]
        value[better] = reached[better]
        step[~better] *= SHRINK
        if np.all(step < tolerance):
            break
    return n


def _ring(dim: int, turn: int) -> Array:
    """Offsets (p, dim − 1) in the tangent space, of length 1 and ½."""
    if dim == 2:
        return np.array([[1.0], [-1.0], [0.5], [-0.5]])
    angle = np.arange(RING) * (2.0 * np.pi / RING) + turn * GOLDEN_ANGLE_RAD
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    return np.concatenate([ring, 0.5 * ring])


@cache
def sphere_samples(count: int, dim: int) -> Array:
    """``count`` unit vectors (count, dim) spread evenly over the circle or the sphere."""
    index = np.arange(count)
    if dim == 2:
        angle = index * (2.0 * np.pi / count)
        return np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    # Fibonacci lattice: equal areas, successive points turned by the golden angle.
    z = 1.0 - (2.0 * index + 1.0) / count
    angle = index * GOLDEN_ANGLE_RAD
    ring = np.sqrt(1.0 - z * z)
    return np.stack([ring * np.cos(angle), ring * np.sin(angle), z], axis=-1)
