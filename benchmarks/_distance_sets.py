"""Sets that distances are measured with, some of them the tests' too, and the public pose law."""

from __future__ import annotations

from itertools import product

import numpy as np

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
from berthing.geometry.truncated_cone import TruncatedCone

WEDGE = Polytope.from_vertices([[1, 0, 0], [3, 0, 0], [1, 2, 0], [1, 0, 1], [3, 0, 0.5], [1, 2, 1]])
TRIANGLE = Polytope.from_vertices([[0.5, 0.0], [2.0, 0.3], [1.0, 1.5]])
TILTED = Pose.from_quaternion(np.array([0.3, -0.1, 0.2]), np.array([0.9, 0.1, -0.3, 0.2]))
BESIDE = (Pose.planar(np.array([0.5, 0.0]), 0.3), Pose.planar(np.array([-0.5, 0.1]), 0.0))
SPACE: dict[str, ConvexSet] = {
    "box": Box([2.0, 1.0, 0.5]),
    "plate": Box([2.0, 2.0, 0.01]),
    "ball": Sphere(0.8),
    "point": Sphere(0.0),
    "ellipsoid": Ellipsoid([1.0, 2.0, 0.5]),
    "needle": Ellipsoid([3.0, 0.1, 0.1]),
    "cylinder": Cylinder(1.0, 2.0),
    "disc": Cylinder(1.5, 0.05, "z"),
    "wedge": WEDGE,
    "capsule": Capsule(0.4, 1.0, "z"),
    "cone": Cone(0.8, 1.0, "y"),
    "lampshade": TruncatedCone(0.5, 1.0, 0.4, "z"),
    "padded box": Offset(Box([1.0, 0.5, 0.2]), 0.3),
    "superellipsoid 8-2-2": Superellipsoid([2.0, 1.0, 1.0], [8, 2, 2]),
    "superellipsoid 4-6-2": Superellipsoid([1.0, 0.6, 0.4], [4, 6, 2]),
    "smoothed box": SmoothedPolytope.inner(Box([2.0, 1.0, 1.0]), 8.0),
    "smoothed wedge": SmoothedPolytope.outer(WEDGE, 40.0),
    "cut cylinder": Intersection(
        [Cylinder(1.0, 1.5), Box([1.2, 0.9, 0.8]), HalfSpace([1.0, 1.0, 0.5], 1.0)],
        [Pose.identity(), TILTED, Pose.identity()],
    ),
}
PLANE: dict[str, ConvexSet] = {
    "rectangle": Box([2.0, 0.5]),
    "circle": Sphere(0.8, dim=2),
    "ellipse": Ellipsoid([1.0, 2.5]),
    "triangle": TRIANGLE,
    "stadium": Capsule(0.4, 1.0, "y", dim=2),
    "superellipse": Superellipsoid([1.5, 1.0], [6, 4]),
    "smoothed square": SmoothedPolytope.inner(Box([1.0, 1.0]), 8.0),
    "lens": Intersection([Sphere(1.0, dim=2), Ellipsoid([1.0, 1.5])], BESIDE),
}
PAIRS: list[tuple[str, ConvexSet, str, ConvexSet]] = [
    (first, group[first], second, group[second])
    for group in (SPACE, PLANE)
    for first, second in product(group, repeat=2)
] + [(name, shape, "wall", HalfSpace([0.0, 0.0, 1.0], 0.5)) for name, shape in SPACE.items()]

# The pose law of public_cases.md, section 5; cubes by their half size, as balls by their radius.
CUBE, SMALL_CUBE = Box([0.5] * 3), Box([0.35] * 3)
CAPSULE, CYLINDER = Capsule(0.3, 0.6, "z"), Cylinder(0.25, 0.45, "z")
CONE, ELLIPSOID = Cone(1.2 * np.tan(np.radians(22.0)), 0.6, "z"), Ellipsoid([0.6, 0.4, 0.5])
EXACT: dict[str, tuple[ConvexSet, ConvexSet]] = {
    "sphere 0.5 – sphere 0.3": (Sphere(0.5), Sphere(0.3)),
    "sphere 0.4 – capsule": (Sphere(0.4), CAPSULE),
    "capsule – cylinder": (CAPSULE, CYLINDER),
    "cylinder – cone": (CYLINDER, CONE),
    "cone – cube 0.5": (CONE, CUBE),
    "cube 0.5 – cube 0.35": (CUBE, SMALL_CUBE),
    "cube 0.5 – ellipsoid": (CUBE, ELLIPSOID),
}
POWER_CUBE, POWER_SMALL = Superellipsoid([0.5] * 3, [8] * 3), Superellipsoid([0.35] * 3, [8] * 3)
POWER_CYLINDER = Superellipsoid([0.25, 0.25, 0.45], [2, 2, 8])
LSE_CUBE, LSE_SMALL = SmoothedPolytope.inner(CUBE, 40.0), SmoothedPolytope.inner(SMALL_CUBE, 40.0)
SMOOTH: dict[str, tuple[ConvexSet, ConvexSet]] = {
    "sphere 0.5 – ellipsoid": (Sphere(0.5), ELLIPSOID),
    "ellipsoid – ellipsoid": (ELLIPSOID, Ellipsoid([0.45, 0.25, 0.25])),
    "superellipsoid cylinder – cube 0.5": (POWER_CYLINDER, POWER_CUBE),
    "superellipsoid cube 0.5 – cube 0.35": (POWER_CUBE, POWER_SMALL),
    "superellipsoid cube 0.5 – ellipsoid": (POWER_CUBE, ELLIPSOID),
    "LSE cube 0.5 – cube 0.35, exponent 40": (LSE_CUBE, LSE_SMALL),
    "LSE cube 0.5 – ellipsoid": (LSE_CUBE, ELLIPSOID),
}


def pose_law(count: int, r_min: float = 0.05, r_max: float = 2.0) -> Pose:
    """Of the second set in the first's frame, t from 0 to 100."""
    t = np.linspace(0.0, 100.0, count)
    wave = 2.0 * np.pi * t
    u = 0.5 * (1.0 + np.sin(wave * np.sqrt(2.0)))
    r = np.cbrt(r_min**3 + (r_max**3 - r_min**3) * u)
    theta, phi = 0.5 * np.pi * np.sin(wave * np.sqrt(3.0)), wave * np.sqrt(5.0)
    place = np.stack([np.cos(theta) * np.cos(phi), np.cos(theta) * np.sin(phi), np.sin(theta)], -1)
    q = np.stack(
        [
            np.sin(wave * np.sqrt(7.0)),
            np.cos(wave * np.sqrt(11.0)),
            np.sin(wave * np.sqrt(13.0)),
            np.cos(wave * np.sqrt(17.0)),
        ],
        axis=-1,
    )
    return Pose.from_quaternion(r[:, None] * place, q)
