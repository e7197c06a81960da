"""Level, half-spaces and support function describe one set."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.capability import HasHalfspaces, HasVertices, level
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.sphere import Sphere
from support.shapes import level_rounding, rounding, size

Draw = Callable[[int, int], Array]
# Of difference quotients of levels in closed form; of solved ones, in terms of their rounding.
STEP_M, ROUNDINGS = 1e-6, 1e5
# To a hundredth of the step from 4 radii.
BISECTIONS = 30


def boundary(shape: ConvexSet, towards: Array) -> Array:
    """Where the rays from a point inside leave the zero sub-level set."""
    axes = np.concatenate([np.eye(shape.dim), -np.eye(shape.dim)])
    centre = shape.support(axes)[1].mean(axis=0)
    low = np.zeros(len(towards))
    high = np.full(len(towards), 4.0 * shape.bounding_radius + 1.0)
    rays = towards / np.linalg.norm(towards, axis=1, keepdims=True)
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        inside = level(shape, centre + middle[:, None] * rays) <= 0.0
        low, high = np.where(inside, middle, low), np.where(inside, high, middle)
    return np.asarray(centre + low[:, None] * rays)


def gradient(shape: ConvexSet, x: Array, step_m: float) -> Array:
    steps = step_m * np.eye(shape.dim)
    columns = [level(shape, x + s) - level(shape, x - s) for s in steps]
    return np.stack(columns, axis=-1) / (2.0 * step_m)


def check_level_meets_support(shape: ConvexSet, towards: Array) -> None:
    """The tangent plane of the level set at its boundary is a supporting plane.

    Near edges the difference quotient mixes two faces; the normal is then still one of the
    edge's, to the step.
    """
    x = boundary(shape, towards)
    step_m = max(STEP_M, ROUNDINGS * level_rounding(shape))
    n = gradient(shape, x, step_m)
    n = n / np.linalg.norm(n, axis=1, keepdims=True)
    gap = shape.support(n)[0] - np.sum(n * x, axis=1)
    assert np.max(np.abs(gap)) < 10.0 * step_m


def test_tangent_planes_support(bounded: ConvexSet, rng: np.random.Generator) -> None:
    if bounded.bounding_radius > 0.0:  # a point has a tip, not a tangent plane
        check_level_meets_support(bounded, rng.normal(size=(20, bounded.dim)))


def test_zero_at_support_points_and_positive_beyond(shape: ConvexSet, directions: Draw) -> None:
    n = directions(200, shape.dim)
    n = n / np.linalg.norm(n, axis=1, keepdims=True)
    value, point = shape.support(n)
    n, point = n[np.isfinite(value)], point[np.isfinite(value)]
    assert len(n)
    within = 10.0 * max(rounding(shape), level_rounding(shape))
    np.testing.assert_allclose(level(shape, point), 0.0, atol=within)
    assert np.all(level(shape, point + 1e-6 * n) > 0.0)


def test_is_convex(shape: ConvexSet, rng: np.random.Generator) -> None:
    x, y = rng.uniform(-3, 3, size=(2, 200, shape.dim))
    s = rng.uniform(size=(200, 1))
    chord = s[:, 0] * level(shape, x) + (1 - s[:, 0]) * level(shape, y)
    within = level_rounding(shape) * (1.0 + np.abs(chord))
    assert np.all(level(shape, s * x + (1 - s) * y) <= chord + within)


def test_halfspaces_agree(shape: ConvexSet, rng: np.random.Generator) -> None:
    if not isinstance(shape, HasHalfspaces):
        return
    A, b = shape.halfspaces()
    np.testing.assert_allclose(np.linalg.norm(A, axis=1), 1.0, atol=1e-14)
    np.testing.assert_allclose(shape.support(A)[0], b, atol=1e-12)
    x = rng.uniform(-2, 2, size=(500, shape.dim)) * size(shape)
    np.testing.assert_array_equal(np.all(x @ A.T <= b, axis=1), level(shape, x) <= 0.0)


def test_vertices_agree(shape: ConvexSet, directions: Draw) -> None:
    if not isinstance(shape, HasVertices):
        return
    n = directions(100, shape.dim)
    highest = np.max(n @ shape.vertices().T, axis=1)
    np.testing.assert_allclose(shape.support(n)[0], highest, rtol=1e-12, atol=1e-12)


def test_another_dimension_is_refused(shape: ConvexSet) -> None:
    with pytest.raises(InputError, match=type(shape).__name__):
        level(shape, np.ones(5 - shape.dim))


@dataclass(frozen=True, eq=False)
class _Shrunk(ConvexSet):
    """A ball whose level is that of a smaller ball."""

    dim: int = 3
    bounding_radius: float = 1.0

    def support(self, n: Array) -> tuple[Array, Array]:
        return Sphere(1.0).support(n)

    def level(self, x: Array) -> Array:
        return Sphere(0.999).level(x)


def test_the_check_notices_a_smaller_level_set(rng: np.random.Generator) -> None:
    with pytest.raises(AssertionError):
        check_level_meets_support(_Shrunk(), rng.normal(size=(20, 3)))
