"""Rigorous bounds on vector polynomials from their Chebyshev coefficients.

Coefficients are arrays (n, degree + 1, c): n polynomials of c components, each on its own
[-1, 1]. Since |T_k| ≤ 1 there, ‖f‖ ≤ Σ_k ‖c_k‖, and ‖f‖ ≥ u·f ≥ u·c_0 − Σ_{k≥1} ‖c_k‖ for any
unit u.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
import numpy.typing as npt
from numpy.polynomial import chebyshev

from berthing.geometry.arrays import Array

# Entries of a basis matrix that are made at a time.
BLOCK = 2_000_000


def basis(s: Array, count: int) -> Array:
    """T_0 … T_{count−1} at s (k,) → (k, count)."""
    columns = np.empty((count, len(s)))
    columns[0] = 1.0
    if count > 1:
        columns[1] = s
    for i in range(2, count):
        np.multiply(2.0 * s, columns[i - 1], out=columns[i])
        columns[i] -= columns[i - 2]
    return columns.T


def at_start(coefficients: Array) -> Array:
    """The value (c,) at −1 of one polynomial (degree + 1, c): T_k(−1) = (−1)^k."""
    return np.asarray((-1.0) ** np.arange(len(coefficients)) @ coefficients)


def at_end(coefficients: Array) -> Array:
    """The value (c,) at 1: T_k(1) = 1."""
    return np.asarray(coefficients.sum(axis=0))


def padded(pieces: Sequence[Array]) -> Array:
    """Polynomials (degree_i + 1, c) of several degrees as one array (n, degree + 1, c)."""
    out = np.zeros((len(pieces), max(map(len, pieces)), pieces[0].shape[1]))
    for row, piece in zip(out, pieces, strict=True):
        row[: len(piece)] = piece
    return out


def derivative(coefficients: Array, span_s: Array) -> Array:
    """Coefficients (n, degree + 1, c) of the time derivative, polynomial i lasting span_s[i]."""
    out = np.zeros_like(coefficients)
    if coefficients.shape[1] > 1:
        out[:, :-1] = chebyshev.chebder(coefficients, axis=1)
        out *= (2.0 / span_s)[:, None, None]
    return out


def restrict(coefficients: Array, low: Array, high: Array) -> Array:
    """Each polynomial i on [low_i, high_i] of its own [-1, 1], as coefficients again."""
    count = coefficients.shape[1]
    nodes, inverse = _interpolation(count)
    out, step = np.empty_like(coefficients), max(1, BLOCK // count**2)
    for start in range(0, len(coefficients), step):
        some = slice(start, start + step)
        s = 0.5 * ((low[some] + high[some])[:, None] + (high[some] - low[some])[:, None] * nodes)
        values = basis(s.ravel(), count).reshape(*s.shape, count) @ coefficients[some]
        out[some] = inverse @ values
    return out


def nodes(count: int) -> Array:
    """The Chebyshev nodes of the first kind (count,) in (−1, 1)."""
    return _interpolation(count)[0]


def fitted(values: Array) -> Array:
    """Coefficients (…, k, c) of the polynomials with these values (…, k, c) at ``nodes(k)``."""
    return np.asarray(_interpolation(values.shape[-2])[1] @ values)


def split(
    t0_s: Array, t1_s: Array, coefficients: Array, parts: npt.NDArray[np.intp]
) -> tuple[Array, Array, Array]:
    """Each polynomial i, lasting from t0_s[i] to t1_s[i], cut into parts[i] equal pieces.

    A piece ends exactly where the next one begins.
    """
    index = np.repeat(np.arange(len(t0_s)), parts)
    step = np.arange(len(index)) - np.repeat(np.cumsum(parts) - parts, parts)
    low, high = step / parts[index], (step + 1) / parts[index]
    start, span = t0_s[index], (t1_s - t0_s)[index]
    end = np.where(step + 1 == parts[index], t1_s[index], start + high * span)
    pieces = restrict(coefficients[index], 2.0 * low - 1.0, 2.0 * high - 1.0)
    return start + low * span, end, pieces


def norm_ceiling(coefficients: Array) -> Array:
    """Upper bounds (n,) on ‖f‖ over [-1, 1]."""
    return np.asarray(np.sqrt((coefficients**2).sum(axis=2)).sum(axis=1))


def norm_floor(coefficients: Array) -> Array:
    """Lower bounds (n,) on ‖f‖ over [-1, 1]; they may be negative, and then say nothing."""
    norms = np.sqrt((coefficients**2).sum(axis=2))
    return np.asarray(norms[:, 0] - norms[:, 1:].sum(axis=1))


@lru_cache(maxsize=64)
def _interpolation(count: int) -> tuple[Array, Array]:
    """Chebyshev nodes (count,) and the matrix from values there to coefficients."""
    nodes = np.cos(np.pi * (np.arange(count) + 0.5) / count)
    inverse = basis(nodes, count).T * (2.0 / count)
    inverse[0] *= 0.5
    return nodes, inverse
