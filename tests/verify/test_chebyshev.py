"""Bounds from coefficients hold, and restriction changes nothing."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import chebyshev

from berthing.verify.chebyshev import (
    at_end,
    at_start,
    basis,
    derivative,
    norm_ceiling,
    norm_floor,
    padded,
    restrict,
)

GRID = np.linspace(-1.0, 1.0, 501)


def polynomials(seed: int, degree: int, components: int = 3) -> np.ndarray:
    return np.random.default_rng(seed).normal(size=(4, degree + 1, components))


def values(coefficients: np.ndarray) -> np.ndarray:
    return basis(GRID, coefficients.shape[1]) @ coefficients


@given(st.integers(0, 1000), st.integers(0, 9))
def test_ceiling_and_floor_hold_everywhere(seed: int, degree: int) -> None:
    c = polynomials(seed, degree)
    c[:, 0] *= 5.0
    norms = np.linalg.norm(values(c), axis=2)
    assert np.all(norms.max(axis=1) <= norm_ceiling(c) * (1 + 1e-14))
    assert np.all(norms.min(axis=1) >= norm_floor(c) - 1e-13)


@given(st.integers(0, 1000), st.integers(0, 12), st.floats(-1, 0.9), st.floats(0.01, 0.1))
def test_a_restriction_is_the_same_polynomial(
    seed: int, degree: int, low: float, width: float
) -> None:
    c = polynomials(seed, degree)
    part = restrict(c, np.full(4, low), np.full(4, low + width))
    for whole, cut in zip(c, part, strict=True):
        s = low + 0.5 * width * (GRID + 1.0)
        np.testing.assert_allclose(
            chebyshev.chebval(GRID, cut), chebyshev.chebval(s, whole), atol=1e-12
        )


def test_a_restriction_bounds_more_tightly() -> None:
    c = polynomials(1, 6)
    whole, part = norm_ceiling(c), norm_ceiling(restrict(c, np.full(4, 0.0), np.full(4, 0.01)))
    largest = np.linalg.norm(values(c), axis=2).max(axis=1)
    assert np.all(part < whole)
    assert np.all(part <= largest * 1.01)


def test_derivative_in_time() -> None:
    c, span = polynomials(2, 5), np.array([1.0, 2.0, 5.0, 0.1])
    for i in range(4):
        expected = chebyshev.chebval(GRID, chebyshev.chebder(c[i])) * 2.0 / span[i]
        np.testing.assert_allclose(
            chebyshev.chebval(GRID, derivative(c, span)[i]), expected, atol=1e-12 / span[i]
        )
    assert not np.any(derivative(polynomials(3, 0), span))


def test_ends_and_padding() -> None:
    c = polynomials(4, 5)[0]
    np.testing.assert_allclose(at_start(c), chebyshev.chebval(-1.0, c), atol=1e-14)
    np.testing.assert_allclose(at_end(c), chebyshev.chebval(1.0, c), atol=1e-14)
    together = padded([c, c[:2]])
    assert together.shape == (2, 6, 3)
    assert not np.any(together[1, 2:])


@pytest.mark.parametrize("count", [1, 2, 5])
def test_basis_is_chebyshevs(count: int) -> None:
    np.testing.assert_allclose(basis(GRID, count), chebyshev.chebvander(GRID, count - 1))
