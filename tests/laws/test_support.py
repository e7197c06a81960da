"""The support function bounds the set, is attained in it, and is sublinear."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capability import level
from berthing.geometry.convex_set import ConvexSet
from support.shapes import level_rounding, rounding, size

Draw = Callable[[int, int], Array]
Members = Callable[[ConvexSet], Array]


def check_bounds_members(shape: ConvexSet, n: Array, x: Array) -> None:
    slack = shape.support(n)[0][:, None] - n @ x.T
    assert np.all(slack >= -1e-12 * np.linalg.norm(n, axis=1)[:, None])


def check_attained(shape: ConvexSet, n: Array) -> None:
    """Where the value is finite; where it is not, the point is still a member."""
    value, point = shape.support(n)
    length = np.linalg.norm(n, axis=-1)
    attained = np.sum(n * point, axis=-1)
    within = rounding(shape) * max(size(shape), 1.0) * length
    assert np.all(np.abs(attained - value)[np.isfinite(value)] <= within[np.isfinite(value)])
    assert np.all(level(shape, point) <= level_rounding(shape))


def test_bounds_every_member(shape: ConvexSet, directions: Draw, members: Members) -> None:
    check_bounds_members(shape, directions(200, shape.dim), members(shape))


def test_is_attained_by_a_member(shape: ConvexSet, directions: Draw) -> None:
    check_attained(shape, directions(200, shape.dim))


def test_zero_gives_zero_and_a_member(shape: ConvexSet) -> None:
    check_attained(shape, np.zeros((1, shape.dim)))
    assert shape.support(np.zeros(shape.dim))[0] == 0.0


def test_is_sublinear(shape: ConvexSet, directions: Draw) -> None:
    n, m = directions(200, shape.dim), directions(200, shape.dim)[::-1]

    def h(v: Array) -> Array:
        return shape.support(v)[0]

    within = 10.0 * rounding(shape) * size(shape)
    lengths = np.linalg.norm(n, axis=1) + np.linalg.norm(m, axis=1)
    assert np.all(h(n + m) <= h(n) + h(m) + (within + 1e-12) * lengths)
    np.testing.assert_allclose(h(7.5 * n), 7.5 * h(n), rtol=rounding(shape), atol=1e-12)


def test_batches_keep_their_shape(shape: ConvexSet, directions: Draw) -> None:
    n = directions(24, shape.dim)[:24].reshape(2, 3, -1, shape.dim)
    value, point = shape.support(n)
    assert value.shape == n.shape[:-1]
    assert point.shape == n.shape
    one_value, one_point = shape.support(n[1, 2, 0])
    assert one_value.shape == ()
    np.testing.assert_allclose(one_value, value[1, 2, 0], atol=1e-9)
    np.testing.assert_allclose(one_point, point[1, 2, 0], atol=1e-6)


def test_tiny_directions_still_point(shape: ConvexSet, directions: Draw) -> None:
    n = directions(20, shape.dim)
    np.testing.assert_allclose(shape.support(1e-200 * n)[1], shape.support(n)[1], atol=1e-6)


def test_another_dimension_is_refused(shape: ConvexSet) -> None:
    with pytest.raises(InputError, match=type(shape).__name__):
        shape.support(np.ones(5 - shape.dim))


@dataclass(frozen=True, eq=False)
class _Wrong(ConvexSet):
    """A box whose support is too small, or whose point lies beyond the set."""

    value_factor: float = 1.0
    point_factor: float = 1.0
    dim: int = 3
    bounding_radius: float = 2.0

    def support(self, n: Array) -> tuple[Array, Array]:
        value, point = Box([1.0, 1.0, 1.0]).support(n)
        return self.value_factor * value, self.point_factor * point

    def level(self, x: Array) -> Array:
        return Box([1.0, 1.0, 1.0]).level(x)


def test_the_checks_notice_a_wrong_support(directions: Draw, members: Members) -> None:
    n = directions(50, 3)
    check_bounds_members(_Wrong(), n, members(_Wrong()))
    with pytest.raises(AssertionError):
        check_bounds_members(_Wrong(value_factor=0.99), n, members(_Wrong()))
    with pytest.raises(AssertionError):
        check_attained(_Wrong(value_factor=1.01), n)
    with pytest.raises(AssertionError):
        check_attained(_Wrong(1.01, 1.01), n)
