"""Poses that break distance algorithms: touching, parallel, crossed, concentric, far, thin."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from berthing.clearance.plane import plane_bound
from berthing.clearance.separation import PairQuery
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capability import level
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere

# coal enlarges boxes by 1e-10 of their size, and its EPA ends at 1e-6 of it.
TOLERANCE_M = 5e-6

CUBE, PLATE = Box([1.0, 1.0, 1.0]), Box([10.0, 10.0, 1e-3])
BALL, POINT = Sphere(1.0), Sphere(0.0)
ROD, TALL, COIN = Cylinder(1.0, 2.0), Cylinder(1.0, 2.0, "y"), Cylinder(1.0, 0.25)
EGG = Ellipsoid([1.0, 2.0, 0.5])
CORNER = Polytope.from_vertices([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
SQUARE, DISC, DOT = Box([1.0, 1.0]), Sphere(1.0, dim=2), Sphere(0.0, dim=2)
OVAL, GABLE = Ellipsoid([1.0, 2.0]), Polytope.from_vertices([[0, 0], [1, 0], [0, 1]])
EIGHTH_Y = quaternion.from_axis_angle(np.array([0.0, 1.0, 0.0]), np.pi / 4)
EIGHTH_Z = quaternion.from_axis_angle(np.array([0.0, 0.0, 1.0]), np.pi / 4)


@dataclass(frozen=True)
class Contact:
    """B placed in A's frame, and the distance known."""

    name: str
    a: ConvexSet
    b: ConvexSet
    position: tuple[float, ...]
    distance: float
    q: Array | None = None

    @property
    def pose(self) -> Pose:
        position = np.array(self.position)
        if self.q is None:
            return Pose(position, np.eye(len(position)))
        return Pose.from_quaternion(position, self.q)


CROSSED = quaternion.multiply(quaternion.conjugate(EIGHTH_Z), EIGHTH_Y)
EDGE = np.sqrt(2.0)
CONTACTS = [
    Contact("faces touch", CUBE, CUBE, (2, 0, 0), 0),
    Contact("faces touch, shifted", CUBE, CUBE, (2, 0.3, 0.2), 0),
    Contact("parallel faces apart", CUBE, CUBE, (3, 0.3, 0.2), 1),
    Contact("parallel faces overlap", CUBE, CUBE, (1.5, 0.3, 0.2), -0.5),
    Contact("parallel edges touch", CUBE, CUBE, (2, 2, 0), 0),
    Contact("parallel edges apart", CUBE, CUBE, (3, 3, 0), EDGE),
    Contact("vertices touch", CUBE, CUBE, (2, 2, 2), 0),
    Contact("vertices apart", CUBE, CUBE, (3, 3, 3), np.sqrt(3.0)),
    Contact("edge on face", CUBE, CUBE, (1 + EDGE, 0, 0), 0, EIGHTH_Z),
    Contact("vertex on face", CUBE, CORNER, (1, 0, 0), 0),
    Contact("edges cross, touching", CUBE, CUBE, (2, -2, 0), 0, CROSSED),
    Contact("edges cross, apart", CUBE, CUBE, (2.1, -2.1, 0), 0.1 * EDGE, CROSSED),
    Contact("cubes concentric", CUBE, CUBE, (0, 0, 0), -2),
    Contact("cube inside", Box([0.1, 0.1, 0.1]), CUBE, (-0.3, -0.2, -0.1), -0.8),
    Contact("balls touch", BALL, BALL, (0, 2, 0), 0),
    Contact("balls concentric", BALL, Sphere(2.0), (0, 0, 0), -3),
    Contact("ball inside", Sphere(0.5), BALL, (0, 0, 0.3), -1.2),
    Contact("points at one place", POINT, POINT, (0, 0, 0), 0),
    Contact("points apart", POINT, POINT, (0, 3, 4), 5),
    Contact("point on face", POINT, CUBE, (1, 0, 0), 0),
    Contact("point on vertex", POINT, CUBE, (1, 1, 1), 0),
    Contact("point amid a cube", POINT, CUBE, (0, 0, 0), -1),
    Contact("point amid a rod", POINT, ROD, (0, 0, 0), -1),
    Contact("point near a rod's end, inside", POINT, ROD, (1.9, 0, 0), -0.1),
    Contact("point amid an egg", POINT, EGG, (0, 0, 0), -0.5),
    Contact("ball amid a rod", Sphere(0.5), ROD, (0, 0, 0), -1.5),
    Contact("rods concentric", ROD, ROD, (0, 0, 0), -2),
    Contact("coins concentric", Cylinder(1.0, 0.5), COIN, (0, 0, 0), -0.75),
    Contact("rods crossed at one centre", ROD, TALL, (0, 0, 0), -2),
    Contact("rods end to end", ROD, ROD, (4, 0, 0), 0),
    Contact("rods side by side", ROD, ROD, (0, 2, 0), 0),
    Contact("rods parallel, apart", ROD, ROD, (0.5, 2.5, 0), 0.5),
    Contact("rims touch", ROD, ROD, (4, 2, 0), 0),
    Contact("rods crossed, touching", ROD, TALL, (0, 0, 2), 0),
    Contact("rod about a cube", CUBE, ROD, (0, 0, 0), -2),
    Contact("eggs concentric", EGG, EGG, (0, 0, 0), -1),
    Contact("eggs touch", EGG, EGG, (0, 4, 0), 0),
    Contact("egg and ball concentric", EGG, BALL, (0, 0, 0), -1.5),
    Contact("far away", CUBE, CUBE, (1e6, 0, 0), 1e6 - 2),
    Contact("cube over a thin plate", PLATE, CUBE, (0, 0, 1.002), 0.001),
    Contact("thin plates touch", PLATE, PLATE, (0, 0, 0.002), 0),
    Contact("grain beside a plate", PLATE, Box([1e-3, 1e-3, 1e-3]), (0, 0, 0.003), 0.001),
    Contact("squares touch", SQUARE, SQUARE, (2, 0.5), 0),
    Contact("corners of squares touch", SQUARE, SQUARE, (2, 2), 0),
    Contact("squares concentric", SQUARE, SQUARE, (0, 0), -2),
    Contact("square deep in a long one", Box([100.0, 100.0]), SQUARE, (3, 0), -98),
    Contact("gable and square", SQUARE, GABLE, (1, 0), 0),
    Contact("discs concentric", DISC, DISC, (0, 0), -2),
    Contact("discs touch", DISC, DISC, (0, 2), 0),
    Contact("dots at one place", DOT, DOT, (0, 0), 0),
    Contact("dot amid a square", DOT, SQUARE, (0, 0), -1),
    Contact("ovals concentric", OVAL, OVAL, (0, 0), -2),
    Contact("ovals touch", OVAL, OVAL, (2, 0), 0),
    Contact("oval and disc concentric", OVAL, DISC, (0, 0), -2),
    Contact("dot amid an oval", DOT, OVAL, (0, 0), -1),
]


def check(contact: Contact, distance: float, at: Pose) -> None:
    a, b, beyond = contact.a, contact.b, at.compose(contact.pose)
    found = PairQuery(a, b).query(at, beyond)
    assert found.distance == pytest.approx(distance, abs=TOLERANCE_M)
    assert found.lower_bound == pytest.approx(distance, abs=TOLERANCE_M)
    bound = plane_bound(a, at, b, beyond, found.normal)
    assert found.lower_bound == pytest.approx(float(bound), abs=1e-14 * (1e3 + abs(distance)))
    assert np.linalg.norm(found.normal) == pytest.approx(1.0, abs=1e-14)
    assert level(a, at.inverse().apply(found.point_a)) < TOLERANCE_M
    assert level(b, beyond.inverse().apply(found.point_b)) < TOLERANCE_M
    np.testing.assert_allclose(
        found.point_b - found.point_a, found.distance * found.normal, atol=TOLERANCE_M
    )


@pytest.mark.parametrize("contact", CONTACTS, ids=lambda contact: contact.name)
def test_contact(contact: Contact) -> None:
    check(contact, contact.distance, Pose.identity(contact.a.dim))


@pytest.mark.parametrize("contact", CONTACTS, ids=lambda contact: contact.name)
def test_contact_elsewhere(contact: Contact) -> None:
    """The same away from the origin and turned, so that rounding disturbs the symmetry."""
    if contact.a.dim == 2:
        at = Pose.planar(np.array([3.0, -7.0]), 0.4)
    else:
        at = Pose.from_quaternion(np.array([3.0, -7.0, 2.0]), np.array([0.3, -0.2, 0.8, 0.5]))
    check(contact, contact.distance, at)


def test_the_check_notices_a_wrong_distance() -> None:
    with pytest.raises(AssertionError):
        check(CONTACTS[0], 1e-5, Pose.identity())
