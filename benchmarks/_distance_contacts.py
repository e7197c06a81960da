"""Poses that break distance algorithms: touching, parallel, crossed, concentric, far, thin.

Each with the distance known by hand; the tests ask them too.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks._distance_poses import random_poses
from benchmarks._distance_sets import PAIRS
from berthing.clearance.placed_distance import distance
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
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
from berthing.geometry.superellipsoid import Superellipsoid

CUBE, PLATE = Box([1.0, 1.0, 1.0]), Box([10.0, 10.0, 1e-3])
BALL, POINT = Sphere(1.0), Sphere(0.0)
ROD, TALL, COIN = Cylinder(1.0, 2.0), Cylinder(1.0, 2.0, "y"), Cylinder(1.0, 0.25)
EGG = Ellipsoid([1.0, 2.0, 0.5])
CORNER = Polytope.from_vertices([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
SQUARE, DISC, DOT = Box([1.0, 1.0]), Sphere(1.0, dim=2), Sphere(0.0, dim=2)
OVAL, GABLE = Ellipsoid([1.0, 2.0]), Polytope.from_vertices([[0, 0], [1, 0], [0, 1]])
EIGHTH_Y = quaternion.from_axis_angle(np.array([0.0, 1.0, 0.0]), np.pi / 4)
EIGHTH_Z = quaternion.from_axis_angle(np.array([0.0, 0.0, 1.0]), np.pi / 4)
HALF_Z = quaternion.from_axis_angle(np.array([0.0, 0.0, 1.0]), np.pi)


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

    @property
    def elsewhere(self) -> Pose:
        """Of A, so that rounding disturbs the symmetry."""
        if self.a.dim == 2:
            return Pose.planar(np.array([3.0, -7.0]), 0.4)
        return Pose.from_quaternion(np.array([3.0, -7.0, 2.0]), np.array([0.3, -0.2, 0.8, 0.5]))


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
# Of those that the collision library does not take, all with the face x = 1, or nearly.
STICK, HAT = Capsule(0.25, 0.75), Cone(1.0, 1.0, "x")
PILLOW, BARREL = Superellipsoid([1.0] * 3, [8] * 3), Superellipsoid([2.0, 1.0, 1.0], [8, 2, 2])
CLIPPED = Intersection([CUBE, Sphere(1.5)])
ROUNDED = Offset(Box([0.8, 0.8, 0.8]), 0.2)
SOFT = SmoothedPolytope.inner(CUBE, 20.0)
# Where its sum along an axis is 1: 2 cosh(20 x) + 4 = exp(20).
SOFT_REACH = float(np.arccosh(0.5 * (np.exp(20.0) - 4.0)) / 20.0)
SMOOTH_CONTACTS = [
    Contact("pillows touch", PILLOW, PILLOW, (2, 0, 0), 0),
    Contact("pillows apart", PILLOW, PILLOW, (2.5, 0, 0), 0.5),
    Contact("pillows concentric", PILLOW, PILLOW, (0, 0, 0), -2),
    Contact("pillow on a cube", CUBE, PILLOW, (2, 0.1, 0.2), 0),
    Contact("barrels concentric", BARREL, BARREL, (0, 0, 0), -2),
    Contact("barrels side by side", BARREL, BARREL, (0, 2, 0), 0),
    Contact("point amid a barrel", POINT, BARREL, (0, 0, 0), -1),
    Contact("barrel and ball concentric", BARREL, BALL, (0, 0, 0), -2),
    Contact("soft cubes touch", SOFT, SOFT, (2 * SOFT_REACH, 0, 0), 0),
    Contact("soft cubes apart", SOFT, SOFT, (2 * SOFT_REACH + 1, 0, 0), 1),
    Contact("soft cubes concentric", SOFT, SOFT, (0, 0, 0), -2 * SOFT_REACH),
    Contact("soft cube on a cube", CUBE, SOFT, (1 + SOFT_REACH, 0.1, 0.1), 0),
    Contact("soft cube about a point", SOFT, POINT, (0, 0, 0), -SOFT_REACH),
    Contact("clipped cubes touch", CLIPPED, CLIPPED, (2, 0.1, 0), 0),
    Contact("clipped cubes apart", CLIPPED, CLIPPED, (3, 0, 0), 1),
    Contact("clipped cubes concentric", CLIPPED, CLIPPED, (0, 0, 0), -2),
    Contact("clipped cube on a cube", CUBE, CLIPPED, (2, 0.2, 0.1), 0),
    Contact("sticks cross at one centre", STICK, STICK, (0, 0, 0), -0.5, EIGHTH_Z),
    Contact("sticks in one line touch", STICK, STICK, (2, 0, 0), 0),
    Contact("hats base to base", HAT, HAT, (2, 0, 0), 0, HALF_Z),
    Contact("hat tip on a cube", CUBE, HAT, (2, 0.3, 0.2), 0, HALF_Z),
    Contact("rounded cubes touch", ROUNDED, ROUNDED, (2, 0.3, 0.2), 0),
    Contact("rounded cubes concentric", ROUNDED, ROUNDED, (0, 0, 0), -2),
    Contact("cube on a wall", CUBE, HalfSpace([1.0, 0.0, 0.0], -1.0), (0, 0, 0), 0),
]
ALL_CONTACTS = [*CONTACTS, *SMOOTH_CONTACTS]


def contacts() -> dict[str, Any]:
    """Of ``berthing.distance`` at every contact, in a plain frame and in one far from round."""
    errors, apart, deep = [], [], []
    for contact in ALL_CONTACTS:
        for at in (Pose.identity(contact.a.dim), contact.elsewhere):
            found = distance(contact.a, contact.b, (at, at.compose(contact.pose)))
            errors.append(abs(float(found.distance) - contact.distance))
            width = float(found.upper_bound - found.lower_bound)
            (apart if contact.distance > 0.0 else deep).append(width)
    return {
        "contacts": len(ALL_CONTACTS),
        "largest_error_m": float(np.max(errors)),
        "apart_widest_m": float(np.max(apart)),
        "touching_or_overlapping_widest_m": float(np.max(deep)),
    }


def touching(total: int, seed: int = 6) -> dict[str, Any]:
    """Random poses of all pairs, B then moved along the normal found until they just touch, and
    until 1 µm is between them; and with both origins at one place."""
    rng, each = np.random.default_rng(seed), -(-total // (3 * len(PAIRS)))
    errors, apart, deep, wrong = [], [], [], 0
    for _, a, _, b in PAIRS:
        pose_a, pose_b = random_poses(rng, a, b, each)
        first = distance(a, b, (pose_a, pose_b))
        for gap in (0.0, 1e-6, None):
            moved = pose_a.position
            if gap is not None:
                moved = pose_b.position - (first.distance - gap)[:, None] * first.normal
            found = distance(a, b, (pose_a, Pose(moved, pose_b.rotation)))
            width = found.upper_bound - found.lower_bound
            outside = found.lower_bound > 0.0
            apart.append(width[outside])
            deep.append(width[~outside])
            wrong += int(np.sum(~np.isfinite(found.distance)))
            if gap is not None:
                errors.append(np.abs(found.distance - gap))
    return {
        "poses": 3 * each * len(PAIRS),
        "pairs": len(PAIRS),
        "largest_error_where_touching_m": float(np.max(np.concatenate(errors))),
        "apart_widest_m": float(np.max(np.concatenate(apart))),
        "touching_or_overlapping_widest_m": float(np.max(np.concatenate(deep))),
        "not_finite": wrong,
    }
