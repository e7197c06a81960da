"""Barycentric Lagrange interpolation (Berrut and Trefethen, 10.1137/S0036144502417715)."""

from __future__ import annotations

import math

import numpy as np
from numpy.polynomial import chebyshev

from berthing.geometry.arrays import Array

COINCIDENT = 1e-14
"""Local coordinates nearer than this to a point are that point: the formula divides by the gap."""


def barycentric_weights(points: Array) -> Array:
    """Weights (n,) of the points (n,), scaled so that they neither over- nor underflow."""
    gaps = points[:, None] - points[None, :]
    np.fill_diagonal(gaps, 1.0)
    # The factor 2 is the reciprocal capacity of [-1, 1]: products stay near one for any n.
    weights = 1.0 / np.prod(2.0 * gaps, axis=1)
    return np.asarray(weights / np.max(np.abs(weights)))


def differentiation_matrix(points: Array) -> Array:
    """D (n, n): values at the points → derivatives there, exact for degree n - 1."""
    w = barycentric_weights(points)
    gaps = points[:, None] - points[None, :]
    np.fill_diagonal(gaps, 1.0)
    D = (w[None, :] / w[:, None]) / gaps
    np.fill_diagonal(D, 0.0)
    # Rows sum to zero, a constant having no slope: more accurate than the closed form.
    np.fill_diagonal(D, -D.sum(axis=1))
    return np.asarray(D)


def interpolation_matrix(points: Array, targets: Array) -> Array:
    """(m, n): values at the points (n,) → values at the targets (m,)."""
    w = barycentric_weights(points)
    gaps = targets[:, None] - points[None, :]
    hit = np.abs(gaps) < COINCIDENT
    terms = w[None, :] / np.where(hit, 1.0, gaps)
    matrix = terms / terms.sum(axis=1, keepdims=True)
    exact = hit.any(axis=1)
    matrix[exact] = hit[exact].astype(np.float64)
    return np.asarray(matrix)


def to_chebyshev(points: Array) -> Array:
    """(n, n): values at the points → Chebyshev coefficients of the interpolant on [-1, 1]."""
    return np.asarray(np.linalg.inv(chebyshev.chebvander(points, len(points) - 1)))


def to_bernstein(points: Array) -> Array:
    """(n, n): values at the points → Bernstein coefficients of the interpolant on [-1, 1].

    The coefficients bound the polynomial on the whole interval, so that limits put on them hold
    between the nodes too. Meant for the low degrees of a segment; the map loses digits as 2^n.
    """
    degree = len(points) - 1
    s = 0.5 * (points + 1.0)
    k = np.arange(degree + 1)
    binomial = np.array([float(math.comb(degree, i)) for i in range(degree + 1)])
    basis = binomial * s[:, None] ** k * (1.0 - s[:, None]) ** (degree - k)
    return np.asarray(np.linalg.inv(basis))
