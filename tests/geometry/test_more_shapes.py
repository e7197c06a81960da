"""Capsules, cones, half-spaces, padded sets and intersections: values known in closed form."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import CapabilityError, InputError
from berthing.geometry.box import Box
from berthing.geometry.capability import conic_form, halfspaces, level, mesh, vertices
from berthing.geometry.capsule import Capsule
from berthing.geometry.cone import Cone
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.intersection import Intersection
from berthing.geometry.offset import Offset
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.sphere import Sphere
from berthing.geometry.truncated_cone import TruncatedCone

SUPPORTS = [
    (Capsule(0.5, 2.0), [3, 0, 4], 6 + 2.5, [2.3, 0, 0.4]),
    (Capsule(0.5, 2.0, "y", dim=2), [3, -4], 8 + 2.5, [0.3, -2.4]),
    (Cone(1.0, 2.0, "z"), [0, 0, 1], 2.0, [0, 0, 2]),
    (Cone(1.0, 2.0, "z"), [3, 4, 0], 5.0, [0.6, 0.8, -2]),
    (Cone(1.0, 2.0, "x"), [-1, 0, 5], 7.0, [-2, 0, 1]),
    (TruncatedCone(1.0, 3.0, 2.0, "z"), [0, 2, -0.5], 5.0, [0, 3, 2]),
    (TruncatedCone(3.0, 1.0, 2.0, "z"), [0, 2, 0], 6.0, [0, 3, -2]),
    (HalfSpace([0.0, 3.0, 4.0], 10.0), [0, 6, 8], 20.0, [0, 1.2, 1.6]),
    (Offset(Box([2.0, 1.0, 0.5]), 0.5), [3, 0, 4], 6 + 2 + 2.5, [2.3, 0, 0.9]),
]


@pytest.mark.parametrize(("shape", "n", "value", "point"), SUPPORTS)
def test_support(shape: ConvexSet, n: list[float], value: float, point: list[float]) -> None:
    found = shape.support(np.array(n, dtype=float))
    assert found[0] == pytest.approx(value)
    np.testing.assert_allclose(found[1], point, atol=1e-12)


LEVELS = [
    (Capsule(0.5, 2.0), [3.0, 0.0, 0.0], 0.5),
    (Capsule(0.5, 2.0), [0.0, 0.3, 0.4], 0.0),
    (Cone(1.0, 2.0, "z"), [0.0, 0.0, -2.5], 0.5),
    (Cone(1.0, 2.0, "z"), [0.5, 0.0, 0.0], 0.0),
    (TruncatedCone(1.0, 1.0, 2.0, "z"), [1.5, 0.0, 0.0], 0.5),
    (HalfSpace([0.0, 2.0], 1.0), [7.0, 2.0], 1.5),
    (Offset(Box([1.0, 1.0]), 0.5), [4.0, 5.0], 4.5),
    (Offset(Box([1.0, 1.0]), 0.5), [0.2, 0.3], -0.5),
]


@pytest.mark.parametrize(("shape", "x", "value"), LEVELS)
def test_level(shape: ConvexSet, x: list[float], value: float) -> None:
    assert level(shape, np.array(x)) == pytest.approx(value, abs=1e-9)


RADII = [
    (Capsule(1.0, 2.0), 3.0),
    (Cone(3.0, 4.0), 5.0),
    (TruncatedCone(1.0, 3.0, 4.0), 5.0),
    (HalfSpace([1.0, 0.0], 1.0), np.inf),
    (Offset(Box([3.0, 4.0]), 2.0), 7.0),
]


@pytest.mark.parametrize(("shape", "radius"), RADII)
def test_bounding_radius(shape: ConvexSet, radius: float) -> None:
    assert shape.bounding_radius == pytest.approx(radius)


def test_a_half_space_is_bounded_along_its_normal_only() -> None:
    wall = HalfSpace([0.0, 0.6, 0.8], 2.0)
    aside = np.array([[0.0, 0.6, 0.8 + 1e-9], [0.0, -0.6, -0.8], [1.0, 0.0, 0.0]])
    assert np.all(np.isinf(wall.support(aside)[0]))
    # Turned to another frame and back, the normal is still the normal.
    turn = Pose.from_quaternion(np.zeros(3), np.array([0.3, 0.7, -0.2, 0.6]))
    back = turn.unrotate(turn.rotate(wall.normal))
    assert wall.support(back)[0] == pytest.approx(2.0)
    np.testing.assert_allclose(wall.normal, halfspaces(wall)[0][0])


def test_a_truncated_cone_with_equal_ends_is_a_cylinder() -> None:
    n = np.random.default_rng(0).normal(size=(200, 3))
    straight, known = TruncatedCone(1.0, 1.0, 2.0, "y"), Cylinder(1.0, 2.0, "y")
    np.testing.assert_allclose(straight.support(n)[0], known.support(n)[0], atol=1e-12)


def test_padding_twice_is_padding_once() -> None:
    n = np.random.default_rng(0).normal(size=(50, 2))
    twice = Offset(Offset(Box([1.0, 2.0]), 0.3), 0.2)
    np.testing.assert_allclose(twice.support(n)[0], Offset(Box([1.0, 2.0]), 0.5).support(n)[0])
    assert conic_form(twice).lift == 4
    far = 5.0 * np.random.default_rng(1).normal(size=(20, 2))
    # In the set that is padded the level is as low as it goes.
    known = np.maximum(level(Offset(Box([1.0, 2.0]), 0.5), far), -0.2)
    np.testing.assert_allclose(level(twice, far), known, atol=1e-9)


def test_padding_a_smooth_set() -> None:
    base = SmoothedPolytope.inner(Box([1.0, 1.0, 1.0]), 8.0)
    padded = Offset(base, 0.2)
    n = np.random.default_rng(2).normal(size=(50, 3))
    np.testing.assert_allclose(level(padded, padded.support(n)[1]), 0.0, atol=1e-9)
    with pytest.raises(CapabilityError, match="SmoothedPolytope has no conic form"):
        conic_form(padded)


def test_an_intersection_of_boxes_is_the_smaller_box() -> None:
    n = np.random.default_rng(3).normal(size=(100, 3))
    common = Intersection([Box([1.0, 2.0, 3.0]), Box([3.0, 1.0, 2.0])])
    known = Box([1.0, 1.0, 2.0])
    np.testing.assert_allclose(common.support(n)[0], known.support(n)[0], atol=1e-10)
    assert common.bounding_radius == pytest.approx(known.bounding_radius, rel=1e-3)


def test_a_lens_of_two_discs() -> None:
    apart = [Pose(np.array([x, 0.0]), np.eye(2)) for x in (0.6, -0.6)]
    lens = Intersection([Sphere(1.0, dim=2)] * 2, apart)
    value, point = lens.support(np.array([[1.0, 0.0], [0.0, -2.0]]))
    np.testing.assert_allclose(value, [0.4, 1.6], atol=1e-10)
    np.testing.assert_allclose(point, [[0.4, 0.0], [0.0, -0.8]], atol=1e-6)


def test_half_spaces_alone_make_a_polytope() -> None:
    rows = np.array([[1.0, 0.0], [-1.0, 0.5], [0.0, 1.0], [0.2, -1.0]])
    common = Intersection([HalfSpace(row, 1.0) for row in rows])
    known = Polytope(rows, np.ones(4))
    n = np.random.default_rng(4).normal(size=(50, 2))
    np.testing.assert_allclose(common.support(n)[0], known.support(n)[0], atol=1e-10)


def test_parts_that_are_moved_and_lifted() -> None:
    """A cone, a capsule and a padded box, each elsewhere: support points are members of all."""
    poses = [
        Pose.from_quaternion(np.array(r), np.array(q))
        for r, q in (
            ([0.1, 0.0, 0.2], [1.0, 0.2, 0.0, 0.1]),
            ([0.0, 0.2, 0.0], [0.5, 0.5, 0.5, 0.5]),
            ([-0.1, 0.0, 0.0], [1.0, 0.0, 0.3, 0.0]),
        )
    ]
    sets = [Cone(1.0, 1.0, "z"), Capsule(0.6, 0.8), Offset(Box([0.5, 0.3, 0.4]), 0.2)]
    common = Intersection(sets, poses)
    n = np.random.default_rng(5).normal(size=(60, 3))
    value, point = common.support(n)
    np.testing.assert_allclose(np.sum(n * point, axis=1), value, atol=1e-8)
    np.testing.assert_allclose(level(common, point), 0.0, atol=1e-8)
    members = common.centre + np.random.default_rng(6).uniform(-1, 1, size=(500, 3))
    members = members[level(common, members) <= 0.0]
    assert len(members) > 20
    assert np.all(n @ members.T <= value[:, None] + 1e-12)


BALL, BEYOND = Sphere(1.0), HalfSpace([1.0, 0.0, 0.0], -1.2)
BAD = [
    (lambda: Capsule(0.0, 1.0), "Capsule.radius: is 0"),
    (lambda: Capsule(1.0, np.nan), "Capsule.half_length: is nan"),
    (lambda: Capsule(1.0, 1.0, "z", dim=2), r"Capsule.axis: is 'z' \(expected x or y\)"),
    (lambda: Capsule(1.0, 1.0, dim=4), "Capsule.dim: is 4"),
    (lambda: Cone(-1.0, 1.0), "Cone.radius: is -1"),
    (lambda: Cone(1.0, 1.0, "w"), "Cone.axis: is 'w'"),
    (lambda: TruncatedCone(1.0, 0.0, 1.0), "TruncatedCone.top_radius: is 0"),
    (lambda: TruncatedCone(1.0, 1.0, np.inf), "TruncatedCone.half_length: is inf"),
    (lambda: HalfSpace([0.0, 0.0], 1.0), "HalfSpace.normal: is zero"),
    (lambda: HalfSpace([1.0], 1.0), "HalfSpace.normal: has 1 components"),
    (lambda: HalfSpace([1.0, np.nan], 1.0), "HalfSpace.normal: contains NaN"),
    (lambda: HalfSpace([1.0, 0.0], np.inf), "HalfSpace.offset: is inf"),
    (lambda: Offset(BALL, 0.0), "Offset.radius: is 0"),
    (lambda: Offset(BEYOND, 1.0), "Offset.base: is a HalfSpace, without bounds"),
    (lambda: Intersection([BALL]), "Intersection: has 1 sets"),
    (lambda: Intersection([BALL, Sphere(1.0, dim=2)]), "mixes two and three dimensions"),
    (lambda: Intersection([BALL, BALL], [Pose.identity()]), "has 1 placements of 2 sets"),
    (
        lambda: Intersection([BALL, BALL], [Pose(np.zeros((2, 3)), np.eye(3)), Pose.identity()]),
        "has a batch of placements",
    ),
    (lambda: Intersection([BALL, BEYOND]), "Intersection: is empty"),
    (lambda: Intersection([BALL, HalfSpace([1.0, 0.0, 0.0], -1.0)]), "Intersection: is flat"),
    (lambda: Intersection([BALL, Sphere(0.0)]), "Intersection: is flat"),
    (lambda: Intersection([BEYOND, BEYOND]), "Intersection: is unbounded"),
    (
        lambda: Intersection([BALL, SmoothedPolytope.inner(Box([1.0, 1.0, 1.0]), 8.0)]),
        "Intersection.sets: SmoothedPolytope has no conic form",
    ),
]


@pytest.mark.parametrize(("make", "message"), BAD)
def test_bad_sizes_are_refused(make, message: str) -> None:
    with pytest.raises(InputError, match=message):
        make()


def test_curved_shapes_have_no_corners() -> None:
    for shape in (Capsule(1.0, 1.0), Cone(1.0, 1.0), BEYOND, Offset(Box([1.0, 1.0]), 0.1)):
        with pytest.raises(CapabilityError):
            vertices(shape)


def test_a_cone_is_drawn_with_its_tip() -> None:
    drawn = mesh(Cone(1.0, 2.0, "y")).vertices
    assert np.sum(np.all(drawn == [0.0, 2.0, 0.0], axis=1)) == 1
    assert np.isclose(np.linalg.norm(drawn[:, [0, 2]], axis=1), 1.0).sum() == len(drawn) - 1


def test_an_ellipsoid_cut_in_half() -> None:
    half = Intersection([Ellipsoid([1.0, 2.0, 0.5]), HalfSpace([0.0, 1.0, 0.0], 0.0)])
    np.testing.assert_allclose(half.support(np.array([0.0, 1.0, 0.0]))[0], 0.0, atol=1e-10)
    np.testing.assert_allclose(half.support(np.array([0.0, -1.0, 0.0]))[0], 2.0, atol=1e-10)
