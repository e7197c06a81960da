"""What shapes without closed forms stand on: cones, climbs, covers and the largest ball."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.geometry import conic_solver, direction_cover
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capability import conic_form
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.conic_solver import minimise
from berthing.geometry.conic_standard import standard
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.inscribed import inscribed_ball
from berthing.geometry.nearest import distance_to
from berthing.geometry.polytope import Polytope
from berthing.geometry.second_order_cone import Scaling, product, quotient, root_determinant
from berthing.geometry.sphere import Sphere
from berthing.geometry.superellipsoid import Superellipsoid


def inside_the_cone(count: int, seed: int) -> Array:
    tail = np.random.default_rng(seed).normal(size=(count, 3))
    head = np.linalg.norm(tail, axis=1, keepdims=True) * 1.1 + 0.01
    return np.concatenate([head, tail], axis=1)


def test_cone_algebra() -> None:
    s, z = inside_the_cone(50, 0), inside_the_cone(50, 1)
    np.testing.assert_allclose(product(s, quotient(s, z)), z, atol=1e-10)
    mirrored = s * [1.0, -1.0, -1.0, -1.0]
    np.testing.assert_allclose(root_determinant(s) ** 2, np.sum(s * mirrored, axis=1), rtol=1e-9)
    scaling = Scaling.of(s, z)
    np.testing.assert_allclose(scaling.apply(z), scaling.unapply(s), rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(scaling.unapply(scaling.apply(s)), s, rtol=1e-9)


@pytest.mark.parametrize("tilt", [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 0.0])
def test_cone_solver_next_to_flat_faces(tilt: float) -> None:
    """Directions almost normal to a face: the optimum is a far corner for next to no gain."""
    shape = Box([2.0, 1.0, 0.01])
    n = np.array([[tilt, 0.7 * tilt, 1.0], [1.0, tilt, tilt], [-1.0, 0.0, tilt]])
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    best = minimise(standard(shape.conic_form(), shape.bounding_radius), -n)
    known = shape.support(n)[0]
    np.testing.assert_allclose(-best.dual, known, atol=1e-9)
    assert np.all(-best.dual >= known - 1e-14)
    np.testing.assert_allclose(np.sum(n * best.point, axis=1), known, atol=1e-9)


def test_cone_solver_proves_what_it_says() -> None:
    """The dual bound holds even where the answer is spoilt: here by stopping early."""
    shape = Cylinder(1.0, 2.0)
    n = np.random.default_rng(1).normal(size=(40, 3))
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(conic_solver, "MAX_ITERATIONS", 3)
        early = minimise(standard(shape.conic_form(), shape.bounding_radius), -n)
    late = minimise(standard(shape.conic_form(), shape.bounding_radius), -n)
    assert np.all(-early.dual >= shape.support(n)[0] - 1e-12)
    assert np.max(-early.dual - shape.support(n)[0]) > 1e-3
    np.testing.assert_allclose(-late.dual, shape.support(n)[0], atol=1e-10)


BALLS = [
    (conic_form(Box([2.0, 1.0, 0.5])), [0.0, 0.0, 0.0], 0.5),
    (conic_form(Sphere(1.5)), [0.0, 0.0, 0.0], 1.5),
    (conic_form(Polytope.from_vertices([[0, 0], [3, 0], [0, 4]])), [1.0, 1.0], 1.0),
    (conic_form(Ellipsoid([1.0, 2.0])), [0.0, 0.0], 1.0),
]


@pytest.mark.parametrize(("form", "centre", "radius"), BALLS)
def test_inscribed_ball(form: ConicForm, centre: list[float], radius: float) -> None:
    found, size = inscribed_ball(form, 3.0)
    assert size == pytest.approx(radius, abs=1e-9)
    if radius != 0.5:  # in the box it may lie anywhere along the two longer axes
        np.testing.assert_allclose(found, centre, atol=1e-6)


def test_distance_from_a_box_is_that_of_its_clipped_point() -> None:
    shape = Box([1.0, 0.5, 2.0])
    x = 3.0 * np.random.default_rng(2).normal(size=(300, 3))
    known = np.linalg.norm(np.maximum(np.abs(x) - shape.half_extents, 0.0), axis=1)
    np.testing.assert_allclose(distance_to(shape, x), known, atol=1e-9)


def test_distance_from_a_smooth_set_is_along_its_normal() -> None:
    shape = Superellipsoid([1.0, 0.5, 2.0], [6, 4, 2])
    n = np.random.default_rng(3).normal(size=(100, 3))
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    gap = np.random.default_rng(4).uniform(0.0, 5.0, size=100)
    x = shape.support(n)[1] + gap[:, None] * n
    np.testing.assert_allclose(distance_to(shape, x), gap, atol=1e-9)
    assert distance_to(shape, np.zeros((1, 3)))[0] == 0.0


@pytest.mark.parametrize("shape", [Box([1.0, 2.0, 2.0]), Box([3.0, 4.0]), Sphere(2.0)])
def test_cover_bounds_the_largest_support_value(shape: Box | Sphere) -> None:
    cones = direction_cover.orthants(shape.dim)
    proven = direction_cover.largest(lambda u: shape.support(u)[0], cones)
    assert shape.bounding_radius <= proven <= shape.bounding_radius * 1.0011


def test_cover_of_one_cone_only() -> None:
    """A needle along x is short in the cone about −y."""
    shape = Ellipsoid([10.0, 1.0, 1.0])
    cone = np.array([[[0.1, -1.0, 0.0], [-0.05, -1.0, 0.1], [-0.05, -1.0, -0.1]]])
    proven = direction_cover.largest(lambda u: shape.support(u)[0], cone)
    best = float(np.max(shape.support(cone[0] / np.linalg.norm(cone[0], axis=1)[:, None])[0]))
    assert best <= proven <= 1.0011 * best


def test_cover_of_something_never_positive_is_zero() -> None:
    assert direction_cover.largest(lambda u: -np.ones(len(u)), direction_cover.orthants(3)) == 0.0
