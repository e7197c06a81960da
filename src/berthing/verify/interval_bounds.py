"""Lower bounds on clearance over whole intervals.

Let g(t) = n(t)·(y − p(t) − Q(t) x), y a fixed point of B's part and x one of A's part about its
centre p, ‖n‖ ≤ 1, all in B's frame. The clearance is at least φ(t) = min over x, y of g: the
plane bound. With ‖x‖ ≤ ρ, rate w of Q and n″ = 0,

    g′ = n′·(…) − n·(p′ + w × Qx),
    g″ = −2 n′·(p′ + w × Qx) − n·(p″ + w′ × Qx + w × (w × Qx)).

Derivatives away from the middle follow from those there and from a bound on the next one.
"""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.pair_motion import RelativeMotion, cross, norm


def first_order(
    value: Array,
    normal: Array,
    motion: RelativeMotion,
    half: Array,
    radius: Array,
    inflation: float,
) -> Array:
    """From the plane bound at the middle, less the motion possible in half the interval.

    n is constant, so that g(t) ≥ g(m) − |g′(m)| h − (h²/2) sup(−g″).

    Args:
        value: φ at the middle (k,); normal: n there (k, 3), unit.
        half: h (k,). radius: ρ (k,).
        inflation: factor, a little above 1, for the rounding of the motion's bounds.
    """
    along = np.einsum("ki,ki->k", normal, motion.velocity)
    drop = np.abs(along) + radius * norm(cross(normal, motion.rate))
    bend = np.einsum("ki,ki->k", normal, motion.acceleration) + motion.jerk * half / 3.0
    # −n·(p(t) − p(m)) ≥ −|n·p′| h − (n·p″)₊ h²/2 − P‴ h³/6, and the turn likewise.
    turn = radius * (motion.rate_dot_ceiling + motion.rate_ceiling**2)
    spent = half * drop + 0.5 * half**2 * (np.maximum(bend, 0.0) + turn)
    return np.asarray(value - inflation * spent)


def second_order(
    values: tuple[Array, Array],
    normals: tuple[Array, Array],
    motion: RelativeMotion,
    half: Array,
    radius: Array,
    inflation: float,
) -> Array:
    """From the plane bounds at both ends, n linear in time between its unit values there.

    φ is a minimum of functions with g″ ≤ K, so φ(t) ≥ chord(t) − (K/2)(t − t₀)(t₁ − t).

    Args:
        values: φ at the ends (k,), (k,); normals: n there (k, 3), (k, 3), unit.
        half, radius, inflation: as in ``first_order``.
    """
    slope = (normals[1] - normals[0]) / (2.0 * half)[:, None]
    steep = norm(slope)
    # p′ strays from its value at the middle by no more than this, p″ by jerk · h.
    stray = half * (norm(motion.acceleration) + 0.5 * half * motion.jerk)
    translation = -2.0 * np.einsum("ki,ki->k", slope, motion.velocity) + 2.0 * steep * stray
    # n(t) lies between its ends, so n·p″ is no less than at one of them.
    pull = np.minimum(*(np.einsum("ki,ki->k", n, motion.acceleration) for n in normals))
    turn = 2.0 * steep * motion.rate_ceiling + motion.rate_dot_ceiling + motion.rate_ceiling**2
    K = inflation * np.maximum(translation - pull + motion.jerk * half + radius * turn, 0.0)
    return _lowest_of_chord(values, K, half)


def _lowest_of_chord(values: tuple[Array, Array], K: Array, half: Array) -> Array:
    """Minimum over [t₀, t₁] of chord(t) − (K/2)(t − t₀)(t₁ − t).

    Let H = 2h, δ = |φ₁ − φ₀| and c = K H²/2. Where δ ≥ c the lower end is the minimum; elsewhere
    it is the mean − c/4 − δ²/(4c).
    """
    low, high = np.minimum(*values), np.maximum(*values)
    c, difference = 2.0 * K * half**2, high - low
    inner = difference < c
    safe = np.where(inner, c, 1.0)
    sagged = 0.5 * (low + high) - 0.25 * safe - 0.25 * difference**2 / safe
    return np.asarray(np.where(inner, np.minimum(sagged, low), low))
