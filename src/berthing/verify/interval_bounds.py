"""A lower bound on clearance over a whole interval.

Let g(t) = n(t)·(y − z(t) − Q(t) x), y a fixed point of B's part and x one of A's part about its
centre z, ‖n‖ ≤ 1, all in B's frame. The clearance is at least φ(t) = min over x, y of g: the
plane bound. With ‖x‖ ≤ ρ and n″ = 0,

    g″ = −2 n′·(z′ + Q′x) − n·(z″ + Q″x).

φ is a minimum of functions with g″ ≤ K, so that φ(t) ≥ chord(t) − (K/2)(t − t₀)(t₁ − t), where
the chord joins φ(t₀) and φ(t₁).
"""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.pair_motion import RelativeMotion, norm


def chord_bound(
    values: Array,
    normals: Array,
    motion: RelativeMotion,
    half: Array,
    radius: Array,
    inflation: float,
) -> Array:
    """From the plane bounds at both ends, n linear in time between its values there.

    Args:
        values: φ at the ends (k, 2).
        normals: n there (k, 2, 3), ‖n‖ ≤ 1.
        half: h, half the length (k,). radius: ρ (k,).
        inflation: factor, a little above 1, for the rounding of the motion's bounds.
    """
    slope = (normals[:, 1] - normals[:, 0]) / (2.0 * half)[:, None]
    steep = norm(slope)
    # z′ strays from its value at the middle by no more than this, z″ by jerk · h.
    stray = half * (norm(motion.acceleration) + 0.5 * half * motion.jerk)
    translation = -2.0 * np.einsum("ki,ki->k", slope, motion.velocity) + 2.0 * steep * stray
    # n(t) lies between its ends, so n·z″ is no less than at one of them.
    pull = np.min(np.einsum("kei,ki->ke", normals, motion.acceleration), axis=1)
    turn = 2.0 * steep * motion.turn_rate + motion.turn_bend
    K = inflation * np.maximum(translation - pull + motion.jerk * half + radius * turn, 0.0)
    return _lowest_of_chord(values, K, half)


def _lowest_of_chord(values: Array, K: Array, half: Array) -> Array:
    """Minimum over [t₀, t₁] of chord(t) − (K/2)(t − t₀)(t₁ − t).

    Let H = 2h, δ = |φ₁ − φ₀| and c = K H²/2. Where δ ≥ c the lower end is the minimum; elsewhere
    it is the mean − c/4 − δ²/(4c).
    """
    low, high = values.min(axis=1), values.max(axis=1)
    c, difference = 2.0 * K * half**2, high - low
    inner = difference < c
    safe = np.where(inner, c, 1.0)
    sagged = 0.5 * (low + high) - 0.25 * safe - 0.25 * difference**2 / safe
    return np.asarray(np.where(inner, np.minimum(sagged, low), low))
