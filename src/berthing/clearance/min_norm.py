"""The point of a hull that is nearest to the origin, by Wolfe's method."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array

# Weights below this are none.
NO_WEIGHT = 1e-14


def nearest_weights(points: Array, weights: Array) -> Array:
    """Weights (k,), ≥ 0 and of sum 1, of the hull's point nearest to the origin.

    Wolfe, *Finding the nearest point in a polytope*, Math. Programming 11 (1976): go towards the
    nearest point of the affine hull until a weight is zero, drop that point, and repeat.

    Args:
        points: (k, d).
        weights: (k,) to start from, ≥ 0 and of sum 1.
    """
    weights = weights.copy()
    active = np.ones(len(points), dtype=bool)
    while True:
        target = np.zeros(len(points))
        target[active] = _affine(points[active])
        if np.all(target[active] > NO_WEIGHT):
            return target
        falling = active & (target <= NO_WEIGHT)
        share = np.min(weights[falling] / np.maximum(weights - target, NO_WEIGHT)[falling])
        weights = weights + np.clip(share, 0.0, 1.0) * (target - weights)
        leaving = falling & (weights <= NO_WEIGHT)
        # One must leave, whatever rounding makes of it.
        leaving[np.flatnonzero(falling)[np.argmin(weights[falling])]] = True
        active &= ~leaving
        weights = np.where(active, weights, 0.0)
        weights /= np.sum(weights)


def _affine(points: Array) -> Array:
    """Weights of sum 1, of any sign, of the nearest point of the affine hull."""
    base = points[-1]
    spokes = points[:-1] - base
    others = np.linalg.lstsq(spokes.T, -base, rcond=None)[0]
    return np.append(others, 1.0 - np.sum(others))
