"""A smooth level function's derivatives are those of its values, and its gradient is the normal."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capability import HasSmoothLevel, level, level_gradient, level_hessian
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.superellipsoid import Superellipsoid
from support.shapes import SHAPES

SMOOTH = {name: shape for name, shape in SHAPES.items() if isinstance(shape, HasSmoothLevel)}
STEP_M = 1e-5
# Of a central difference, relative to the size of what is differentiated.
DIFFERENCE = 1e-6


@pytest.fixture(params=SMOOTH.values(), ids=SMOOTH.keys())
def smooth(request: pytest.FixtureRequest) -> ConvexSet:
    return request.param


def check_derivative(f: Callable[[Array], Array], derivative: Array, x: Array) -> None:
    """Of f (k, ...) at x (k, dim), the last axis of ``derivative`` being that of x."""
    for axis, step in enumerate(STEP_M * np.eye(x.shape[1])):
        slope = (f(x + step) - f(x - step)) / (2.0 * STEP_M)
        within = DIFFERENCE * (1.0 + np.max(np.abs(slope)))
        np.testing.assert_allclose(derivative[..., axis], slope, atol=within)


def points(shape: ConvexSet, rng: np.random.Generator) -> Array:
    """On the boundary and some way in and out of it."""
    on = shape.support(rng.normal(size=(40, shape.dim)))[1]
    return np.concatenate([on, 1.3 * on, 0.5 * on])


def test_gradient(smooth: ConvexSet, rng: np.random.Generator) -> None:
    x = points(smooth, rng)
    check_derivative(lambda x: level(smooth, x), level_gradient(smooth, x), x)


def test_hessian(smooth: ConvexSet, rng: np.random.Generator) -> None:
    x = points(smooth, rng)
    hessian = level_hessian(smooth, x)
    check_derivative(lambda x: level_gradient(smooth, x), hessian, x)
    np.testing.assert_allclose(hessian, np.swapaxes(hessian, -1, -2), atol=1e-12)
    size = np.max(np.abs(hessian), axis=(-1, -2))
    assert np.all(np.linalg.eigvalsh(hessian)[..., 0] >= -1e-12 * (1.0 + size))


def test_gradient_at_support_points_is_the_direction(
    smooth: ConvexSet, directions: Callable[[int, int], Array]
) -> None:
    n = directions(100, smooth.dim)
    n = n / np.linalg.norm(n, axis=1, keepdims=True)
    slope = level_gradient(smooth, smooth.support(n)[1])
    slope = slope / np.linalg.norm(slope, axis=1, keepdims=True)
    np.testing.assert_allclose(slope, n, atol=1e-9)


def test_one_point_and_many_agree(smooth: ConvexSet, rng: np.random.Generator) -> None:
    x = rng.uniform(-1, 1, size=(2, 3, smooth.dim))
    assert level_gradient(smooth, x).shape == x.shape
    assert level_hessian(smooth, x).shape == (*x.shape, smooth.dim)
    np.testing.assert_allclose(level_gradient(smooth, x[1, 2]), level_gradient(smooth, x)[1, 2])
    np.testing.assert_allclose(level_hessian(smooth, x[1, 2]), level_hessian(smooth, x)[1, 2])


@pytest.mark.parametrize("ask", [level_gradient, level_hessian])
def test_a_box_has_none(ask: Callable[[ConvexSet, Array], Array]) -> None:
    with pytest.raises(CapabilityError, match=r"Box has no smooth level function.*Superellipsoid"):
        ask(Box([1.0, 1.0]), np.zeros(2))


@dataclass(frozen=True, eq=False)
class _Flipped(ConvexSet):
    dim: int = 2
    bounding_radius: float = 1.0

    def support(self, n: Array) -> tuple[Array, Array]:
        return DISC.support(n)

    def level(self, x: Array) -> Array:
        return DISC.level(x)

    def level_gradient(self, x: Array) -> Array:
        return -DISC.level_gradient(x)

    def level_hessian(self, x: Array) -> Array:
        return 1.01 * DISC.level_hessian(x)


DISC = Superellipsoid([1.0, 1.0], [2])


def test_the_checks_notice_wrong_derivatives(rng: np.random.Generator) -> None:
    with pytest.raises(AssertionError):
        test_gradient(_Flipped(), rng)
    with pytest.raises(AssertionError):
        test_hessian(_Flipped(), rng)
