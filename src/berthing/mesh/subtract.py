"""Flat convex polygons less convex polytopes: what remains, with a proof of what went.

A polygon is cut by the half-spaces of a polytope one by one; the parts outside remain. Planes are
put inside the polytope by a slack, and a part counts as within a half-space only where its corners
are inside by half that slack. So nothing is dropped for being small: each part that goes lies in
the polytope by a distance that is a million times the rounding of the cuts, and the rounding of
the corners where two parts meet cannot open a gap between what is covered.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from berthing.geometry.arrays import Array

# Slack of the planes, of the size of the scene. Corners are rounded by about 1e-16 of it.
SLACK = 1e-9


def remainder(
    polygon: Array, polytopes: Iterable[tuple[Array, Array]], slack_m: float
) -> list[Array]:
    """Parts (k, 3) of a polygon (n, 3) that no polytope {A x ≤ b} provably covers.

    Args:
        polygon: corners in order, in one plane, convex; flat to a line or point too.
        polytopes: A (m, 3) of unit rows, b (m,) in metres.
        slack_m: positive; parts that reach no deeper into every polytope than this may remain.
    """
    left = [polygon]
    for A, b in polytopes:
        left = [part for whole in left for part in _less(whole, A, b, slack_m)]
        if not left:
            break
    return left


def _less(polygon: Array, A: Array, b: Array, slack: float) -> Sequence[Array]:
    height = polygon @ A.T - b
    if np.any(np.min(height, axis=0) > -slack):
        return [polygon]
    outside: list[Array] = []
    for row in np.flatnonzero(np.max(height, axis=0) > -0.5 * slack):
        above = polygon @ A[row] - b[row]
        if np.max(above) <= -0.5 * slack:
            continue
        if np.min(above) > -slack:
            outside.append(polygon)
            return outside
        polygon, cut_off = split(polygon, above + 0.75 * slack)
        outside.append(cut_off)
    return outside


def split(polygon: Array, height: Array) -> tuple[Array, Array]:
    """The parts of a convex polygon at height ≤ 0 and ≥ 0; neither may be empty."""
    following, next_height = np.roll(polygon, -1, axis=0), np.roll(height, -1)
    below: list[Array] = []
    above: list[Array] = []
    for p, h, q, g in zip(polygon, height, following, next_height, strict=True):
        if h <= 0.0:
            below.append(p)
        if h >= 0.0:
            above.append(p)
        if h * g < 0.0:
            crossing = p + (q - p) * (h / (h - g))
            below.append(crossing)
            above.append(crossing)
    return np.array(below), np.array(above)


def area(polygon: Array) -> float:
    """Of a flat convex polygon (n, 3), in m²."""
    spokes = polygon[1:] - polygon[0]
    return float(0.5 * np.linalg.norm(np.cross(spokes[:-1], spokes[1:]), axis=1).sum())
