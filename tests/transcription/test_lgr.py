"""Radau points and weights."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.transcription.lgr import radau, with_end

DEGREES = [1, 2, 3, 4, 7, 12, 30]


def integral(power: int) -> float:
    return 2.0 / (power + 1) if power % 2 == 0 else 0.0


@pytest.mark.parametrize("n", DEGREES)
def test_quadrature_is_exact_up_to_degree_2n_minus_2(n) -> None:
    points, weights = radau(n)
    for power in range(2 * n - 1):
        assert weights @ points**power == pytest.approx(integral(power), abs=1e-13)


@pytest.mark.parametrize("n", [1, 2, 3, 4, 7])
def test_quadrature_is_not_exact_beyond(n) -> None:
    points, weights = radau(n)
    # P_{n-1} (P_{n-1} + P_n) vanishes at the points, but its integral is 2/(2n - 1).
    power = 2 * n - 1
    assert abs(weights @ points**power - integral(power)) > 1e-5


@pytest.mark.parametrize("n", DEGREES)
def test_points_rise_from_the_beginning_and_leave_out_the_end(n) -> None:
    points, weights = radau(n)
    assert points[0] == -1.0
    assert np.all(np.diff(points) > 0.0)
    assert points[-1] < 1.0
    assert np.all(weights > 0.0)
    assert with_end(points)[-1] == 1.0


def test_the_first_few_are_those_of_the_books() -> None:
    points, weights = radau(2)
    np.testing.assert_allclose(points, [-1.0, 1.0 / 3.0], atol=1e-15)
    np.testing.assert_allclose(weights, [0.5, 1.5], atol=1e-15)
    points, weights = radau(3)
    root = np.sqrt(6.0)
    np.testing.assert_allclose(points, [-1.0, (1 - root) / 5, (1 + root) / 5], atol=1e-15)
    np.testing.assert_allclose(weights, [2 / 9, (16 + root) / 18, (16 - root) / 18], atol=1e-15)


def test_none_at_all_is_refused() -> None:
    with pytest.raises(InputError, match="at least one"):
        radau(0)
