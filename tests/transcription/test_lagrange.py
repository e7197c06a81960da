"""Interpolation, differentiation and the bases that bound a polynomial."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.polynomial import Polynomial, chebyshev

from berthing.transcription.lagrange import (
    barycentric_weights,
    differentiation_matrix,
    interpolation_matrix,
    to_bernstein,
    to_chebyshev,
)
from berthing.transcription.lgr import radau, with_end

FINE = np.linspace(-1.0, 1.0, 401)


def points_of(n: int) -> np.ndarray:
    """n + 1 support points."""
    return with_end(radau(n)[0])


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(20240617)


@pytest.mark.parametrize("n", [1, 2, 4, 8, 16])
def test_differentiation_is_exact_for_the_degree_of_the_points(n, rng) -> None:
    points = points_of(n)
    D = differentiation_matrix(points)
    poly = Polynomial(rng.normal(size=n + 1))
    np.testing.assert_allclose(D @ poly(points), poly.deriv()(points), atol=1e-11 * n**2)
    beyond = Polynomial([0.0] * (n + 1) + [1.0])
    assert np.max(np.abs(D @ beyond(points) - beyond.deriv()(points))) > 1e-3


@pytest.mark.parametrize("n", [1, 2, 4, 8, 16])
def test_interpolation_is_exact_for_the_degree_of_the_points(n, rng) -> None:
    points = points_of(n)
    matrix = interpolation_matrix(points, FINE)
    poly = Polynomial(rng.normal(size=n + 1))
    np.testing.assert_allclose(matrix @ poly(points), poly(FINE), atol=1e-12)
    beyond = Polynomial([0.0] * (n + 1) + [1.0])
    assert np.max(np.abs(matrix @ beyond(points) - beyond(FINE))) > 1e-6


def test_interpolation_at_a_point_is_its_value() -> None:
    points = points_of(6)
    np.testing.assert_array_equal(interpolation_matrix(points, points), np.eye(7))
    # Nearer than rounding: dividing by the gap would give anything.
    shifted = interpolation_matrix(points, np.array([points[3] + 1e-16, points[3] + 1e-12]))
    np.testing.assert_allclose(shifted, np.eye(7)[[3, 3]], atol=1e-10)


def test_weights_neither_overflow_nor_vanish_for_many_points() -> None:
    weights = barycentric_weights(points_of(200))
    assert np.max(np.abs(weights)) == 1.0
    assert np.min(np.abs(weights)) > 1e-6
    values = interpolation_matrix(points_of(200), FINE) @ np.sin(5.0 * points_of(200))
    np.testing.assert_allclose(values, np.sin(5.0 * FINE), atol=1e-12)


@pytest.mark.parametrize("n", [1, 3, 6, 12])
def test_chebyshev_coefficients_are_of_the_same_polynomial(n, rng) -> None:
    points, values = points_of(n), rng.normal(size=n + 1)
    coefficients = to_chebyshev(points) @ values
    expected = interpolation_matrix(points, FINE) @ values
    np.testing.assert_allclose(chebyshev.chebval(FINE, coefficients), expected, atol=1e-11)


@pytest.mark.parametrize("n", [1, 2, 4, 7])
def test_a_polynomial_stays_in_the_hull_of_its_bernstein_coefficients(n, rng) -> None:
    points = points_of(n)
    outside = 0
    for values in rng.normal(size=(50, n + 1)):
        coefficients = to_bernstein(points) @ values
        inside = interpolation_matrix(points, FINE) @ values
        assert np.min(coefficients) - 1e-12 <= np.min(inside)
        assert np.max(inside) <= np.max(coefficients) + 1e-12
        # The ends are the polynomial's own.
        np.testing.assert_allclose(coefficients[[0, -1]], values[[0, -1]], atol=1e-12)
        outside += bool(np.max(inside) > np.max(values) + 1e-3)
    # The values at the points are no such bound.
    assert outside > 0 or n == 1


def test_bernstein_coefficients_of_a_line_lie_on_it() -> None:
    points = points_of(4)
    line = to_bernstein(points) @ (3.0 + 2.0 * points)
    np.testing.assert_allclose(line, 3.0 + 2.0 * np.linspace(-1, 1, 5), atol=1e-13)
