"""Attitude in casadi expressions against the numeric quaternions."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.dynamics.rotation import (
    attitude_error,
    quaternion_product,
    quaternion_rate,
    rotation_matrix,
)
from berthing.geometry import quaternion

TURN = quaternion.from_axis_angle(np.array([1.0, 2.0, -0.5]), 0.7)
OTHER = quaternion.from_axis_angle(np.array([-0.3, 0.4, 1.0]), 2.1)


def test_rotation_matrix_is_the_numeric_one_at_any_norm(rng, number) -> None:
    for q in rng.normal(size=(10, 4)):
        expected = quaternion.rotation_matrix(q)
        np.testing.assert_allclose(number(rotation_matrix(q)), expected, atol=1e-14)
        np.testing.assert_allclose(number(rotation_matrix(-3.0 * q)), expected, atol=1e-14)


def test_scalar_last_would_be_seen() -> None:
    rolled = quaternion.rotation_matrix(np.roll(TURN, -1))
    assert np.max(np.abs(rolled - quaternion.rotation_matrix(TURN))) > 0.1


def test_product_is_the_numeric_one(number) -> None:
    product = number(quaternion_product(TURN, OTHER))
    np.testing.assert_allclose(product, quaternion.multiply(TURN, OTHER), atol=1e-15)
    assert np.max(np.abs(product - quaternion.multiply(OTHER, TURN))) > 0.1


def test_rate_is_half_the_product_with_the_rate(number) -> None:
    w = np.array([0.3, -0.2, 0.5])
    expected = 0.5 * quaternion.multiply(TURN, np.array([0.0, *w]))
    np.testing.assert_allclose(number(quaternion_rate(TURN, w)), expected, atol=1e-15)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_attitude_error_vanishes_at_the_attitude_whatever_the_sign(sign, number) -> None:
    assert np.max(np.abs(number(attitude_error(TURN, sign * TURN)))) < 1e-15


@pytest.mark.parametrize("angle", [1e-3, 0.5, 2.0, np.pi])
def test_attitude_error_is_the_sine_of_half_the_angle(angle, number) -> None:
    axis = np.array([0.6, 0.0, 0.8])
    turned = quaternion.multiply(TURN, quaternion.from_axis_angle(axis, angle))
    error = number(attitude_error(TURN, turned))
    np.testing.assert_allclose(error, np.sin(0.5 * angle) * axis, atol=1e-14)
