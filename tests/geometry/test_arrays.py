"""Coercions at the borders, and small vector helpers."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry.arrays import as_array, skew
from berthing.geometry.convex_set import norm, unit


def test_as_array_reads_copies_and_freezes() -> None:
    source = np.ones((2, 3))
    found = as_array(source, (None, 3), "here")
    source[0, 0] = 5.0
    assert found[0, 0] == 1.0
    assert not found.flags.writeable


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ([1.0, 2.0], "here: has the shape 2 .expected 3"),
        ([[1.0, 2.0, 3.0]], "here: has the shape 1×3"),
        ([1.0, 2.0, np.nan], "here: contains NaN"),
        (["a", "b", "c"], "here: is not an array of numbers"),
        ([1.0, [2.0], 3.0], "here: is not an array of numbers"),
    ],
)
def test_as_array_refuses(value: object, message: str) -> None:
    with pytest.raises(InputError, match=message):
        as_array(value, (3,), "here")


def test_skew_is_the_cross_product() -> None:
    v, w = np.random.default_rng(0).normal(size=(2, 5, 3))
    np.testing.assert_allclose(np.einsum("kij,kj->ki", skew(v), w), np.cross(v, w))


@pytest.mark.parametrize("size", [1e-300, 1.0, 1e300])
def test_unit_works_at_any_size(size: float) -> None:
    np.testing.assert_allclose(unit(size * np.array([3.0, 0.0, -4.0])), [0.6, 0.0, -0.8])


def test_unit_keeps_zero() -> None:
    np.testing.assert_array_equal(unit(np.zeros((2, 3))), np.zeros((2, 3)))
    np.testing.assert_allclose(norm(np.array([[3.0, 4.0], [0.0, 0.0]])), [5.0, 0.0])
