"""Values known in closed form; the laws over all shapes are in tests/laws."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.geometry.box import Box
from berthing.geometry.capability import conic_form, halfspaces, level, mesh, vertices
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.sphere import Sphere

SUPPORTS = [
    (Box([2.0, 1.0, 0.5]), [1, -2, 4], 2 + 2 + 2, [2, -1, 0.5]),
    (Box([2.0, 1.0]), [-3, 0.5], 6.5, [-2, 1]),
    (Sphere(2.0), [3, 0, 4], 10.0, [1.2, 0, 1.6]),
    (Sphere(2.0, dim=2), [3, 4], 10.0, [1.2, 1.6]),
    (Ellipsoid([1.0, 2.0, 3.0]), [0, 0, -2], 6.0, [0, 0, -3]),
    (Ellipsoid([3.0, 2.0]), [1, 2], 5.0, [9 / 5, 8 / 5]),
    (Cylinder(1.0, 2.0), [1, 3, 4], 7.0, [2, 0.6, 0.8]),
    (Cylinder(1.0, 2.0, "y"), [3, 1, 4], 7.0, [0.6, 2, 0.8]),
    (Cylinder(1.0, 2.0, "z"), [3, 4, -1], 7.0, [0.6, 0.8, -2]),
]


@pytest.mark.parametrize(("shape", "n", "value", "point"), SUPPORTS)
def test_support(shape: ConvexSet, n: list[float], value: float, point: list[float]) -> None:
    found = shape.support(np.array(n, dtype=float))
    assert found[0] == pytest.approx(value)
    np.testing.assert_allclose(found[1], point)


LEVELS = [
    (Box([2.0, 1.0, 0.5]), [1.0, 0.0, 0.6], 0.1),
    (Sphere(2.0), [0.0, 3.0, 0.0], 1.0),
    (Ellipsoid([1.0, 2.0, 3.0]), [0.0, 1.0, 0.0], -0.5),
    (Cylinder(1.0, 2.0), [2.5, 0.0, 0.0], 0.5),
    (Cylinder(1.0, 2.0), [0.0, 0.9, 1.2], 0.5),
]


@pytest.mark.parametrize(("shape", "x", "value"), LEVELS)
def test_level(shape: ConvexSet, x: list[float], value: float) -> None:
    assert level(shape, np.array(x)) == pytest.approx(value)


RADII = [
    (Box([2.0, 3.0, 6.0]), 7.0),
    (Sphere(0.0), 0.0),
    (Ellipsoid([1.0, 4.0, 3.0]), 4.0),
    (Cylinder(3.0, 4.0), 5.0),
]


@pytest.mark.parametrize(("shape", "radius"), RADII)
def test_bounding_radius(shape: ConvexSet, radius: float) -> None:
    assert shape.bounding_radius == pytest.approx(radius)


def test_box_has_its_corners_and_faces() -> None:
    corners = vertices(Box([2.0, 1.0, 0.5]))
    assert len(np.unique(corners, axis=0)) == 8
    np.testing.assert_array_equal(np.abs(corners), np.tile([2.0, 1.0, 0.5], (8, 1)))
    A, b = halfspaces(Box([2.0, 1.0]))
    assert sorted(zip(A.tolist(), b.tolist(), strict=True)) == [
        ([-1.0, 0.0], 2.0),
        ([0.0, -1.0], 1.0),
        ([0.0, 1.0], 1.0),
        ([1.0, 0.0], 2.0),
    ]


def test_conic_forms_have_the_blocks_agreed() -> None:
    sizes = {
        Box([1.0, 2.0, 3.0]): [1, 1, 1],
        Sphere(1.0): [3],
        Ellipsoid([1.0, 2.0, 3.0]): [3],
        Cylinder(1.0, 2.0): [1, 2],
    }
    for shape, rows in sizes.items():
        assert [len(block.b) for block in conic_form(shape).blocks] == rows
        assert len(conic_form(shape).linear_b) == 0


def test_shapes_do_not_change() -> None:
    sizes = np.array([1.0, 2.0])
    box = Box(sizes)
    sizes[0] = 5.0
    assert box.half_extents[0] == 1.0
    with pytest.raises(ValueError, match="read-only"):
        box.half_extents[0] = 5.0


def test_sphere_mesh_is_shared_but_scaled() -> None:
    assert np.linalg.norm(mesh(Sphere(2.0)).vertices, axis=1) == pytest.approx(2.0)
    assert np.linalg.norm(mesh(Sphere(1.0)).vertices, axis=1) == pytest.approx(1.0)
