"""Sizes that make no shape are refused, and the message names what is wrong."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry.box import Box
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.polytope import Polytope
from berthing.geometry.sphere import Sphere

SQUARE = np.array([[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]])
BAD: list[tuple[Callable[[], ConvexSet], str]] = [
    (lambda: Box([1.0, 0.0, 1.0]), r"Box.half_extents\[1\]: is 0"),
    (lambda: Box([1.0, -2.0]), r"Box.half_extents\[1\]: is -2"),
    (lambda: Box([1.0, np.nan, 1.0]), r"Box.half_extents\[1\]: is nan"),
    (lambda: Box([1.0]), r"Box.half_extents: has the shape \(1,\)"),
    (lambda: Box([[1.0, 2.0]]), r"Box.half_extents: has the shape \(1, 2\)"),
    (lambda: Box(["wide", 1.0]), "Box.half_extents: is not an array of numbers"),
    (lambda: Ellipsoid([1.0, np.inf]), r"Ellipsoid.semi_axes\[1\]: is inf"),
    (lambda: Ellipsoid([1.0, 1.0, 1.0, 1.0]), "Ellipsoid.semi_axes"),
    (lambda: Sphere(-0.1), "Sphere.radius: is -0.1"),
    (lambda: Sphere(float("nan")), "Sphere.radius: is nan"),
    (lambda: Sphere("big"), "Sphere.radius: is 'big'"),
    (lambda: Sphere(1.0, dim=4), "Sphere.dim: is 4"),
    (lambda: Cylinder(0.0, 1.0), "Cylinder.radius: is 0"),
    (lambda: Cylinder(1.0, -1.0), "Cylinder.half_length: is -1"),
    (lambda: Cylinder(1.0, np.inf), "Cylinder.half_length: is inf"),
    (lambda: Cylinder(1.0, 1.0, "w"), "Cylinder.axis: is 'w'"),
    (lambda: Polytope(SQUARE, [1.0, 1.0, 1.0]), "Polytope.b: has the shape 3"),
    (lambda: Polytope(SQUARE, [1.0, 1.0, 1.0, np.nan]), "Polytope.b: contains NaN"),
    (lambda: Polytope(SQUARE[:3], np.ones(3)), "Polytope: is unbounded"),
    (lambda: Polytope(SQUARE[:2], np.ones(2)), "Polytope: is unbounded"),
    (lambda: Polytope(SQUARE[[0, 2]], np.ones(2)), "Polytope: is unbounded"),
    (lambda: Polytope(np.eye(3), np.ones(3)), "Polytope: is unbounded"),
    (lambda: Polytope(SQUARE, [1.0, 1.0, -2.0, 1.0]), "Polytope: is empty"),
    (lambda: Polytope(SQUARE, [1.0, 1.0, -1.0, 1.0]), "Polytope: is flat"),
    (lambda: Polytope([[0.0, 0.0], *SQUARE], np.ones(5)), "Polytope: row 0 is zero"),
    (lambda: Polytope(np.eye(4), np.ones(4)), "Polytope: has 4 columns"),
    (lambda: Polytope.from_vertices(np.eye(3)), "Polytope.vertices: has 3 vertices"),
    (lambda: Polytope.from_vertices([[0, 0], [1, 1], [2, 2]]), "Polytope.vertices: is flat"),
    (
        lambda: Polytope.from_vertices([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]),
        "Polytope.vertices: is flat",
    ),
    (lambda: Polytope.from_vertices([[0, 0], [1, np.inf], [2, 2]]), "Polytope.vertices: contains"),
    (lambda: Polytope.from_vertices(np.ones(3)), "Polytope.vertices: has the shape 3"),
    (lambda: Polytope.from_vertices(np.ones((9, 4))), "Polytope.vertices: has 4 columns"),
    (lambda: Polytope.from_vertices(np.ones((9, 3))), "Polytope.vertices: is flat"),
]


@pytest.mark.parametrize(("make", "message"), BAD)
def test_is_refused(make: Callable[[], ConvexSet], message: str) -> None:
    with pytest.raises(InputError, match=message):
        make()


def test_a_box_as_half_spaces_is_accepted() -> None:
    assert Polytope(SQUARE, np.ones(4)).bounding_radius == pytest.approx(np.sqrt(2.0))
