"""The package's sets as objects of the collision library ``coal``.

Planar sets are lifted to solids that are symmetric in z. Two such solids that are apart have a
pair of closest points at z = 0 (the mean of any pair and its mirror image is one), so their
distance is the planar one. Where they overlap, the shortest way out could be along z; the solids
are made so tall that for prisms it never is.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import product
from typing import Any

import coal
import numpy as np

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capsule import Capsule
from berthing.geometry.cone import Cone
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.mesh import hull_mesh
from berthing.geometry.polytope import Polytope
from berthing.geometry.sphere import Sphere

# coal's cylinder lies along z. These cyclic permutations turn z to the axis named.
_FROM_Z: Mapping[str, Array] = {
    "x": np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
    "y": np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]),
    "z": np.eye(3),
}

# Height of the second prism of a planar pair in terms of the first's.
UNEVEN = 1.5


@dataclass(frozen=True, eq=False)
class CoalShape:
    """A geometry of coal, and the rotation (3, 3) of its frame in the set's own."""

    geometry: Any
    turn: Array


@lru_cache(maxsize=4096)
def coal_shape(shape: ConvexSet, scale: float, half_thickness: float) -> CoalShape:
    """The set for coal, enlarged by ``scale``; a planar set reaches ``half_thickness`` in ±z.

    Raises:
        CapabilityError: a set that coal has no counterpart of.
    """
    try:
        build = _BUILDERS[type(shape)]
    except KeyError:
        able = ", ".join(sorted(kind.__name__ for kind in _BUILDERS))
        raise CapabilityError(
            f"{type(shape).__name__} has no distance query; those that have one: {able}"
        ) from None
    return build(shape, scale, half_thickness)


def has_coal_shape(shape: ConvexSet) -> bool:
    """Whether coal has a counterpart of the set."""
    return type(shape) in _BUILDERS


def coal_pair(a: ConvexSet, b: ConvexSet, scale: float) -> tuple[CoalShape, CoalShape]:
    """Two sets of the same dimension for coal, both enlarged by ``scale``.

    Raises:
        CapabilityError: a set that coal has no counterpart of.
    """
    thickness = scale * (a.bounding_radius + b.bounding_radius)
    # Ends of two prisms at the same height, four faces in two planes, mislead coal's EPA.
    pair = coal_shape(a, scale, thickness), coal_shape(b, scale, UNEVEN * thickness)
    if {type(a), type(b)} != {Sphere, Cylinder}:
        return pair
    # coal's own routine for a ball and a cylinder errs in depth once the ball's centre is inside
    # (3.0.3: 18 to 76% of such queries). A capsule of length 0 goes the general way.
    first, second = (
        CoalShape(coal.Capsule(scale * s.radius, 0.0), p.turn) if isinstance(s, Sphere) else p
        for s, p in zip((a, b), pair, strict=True)
    )
    return first, second


def _box(shape: Box, scale: float, half_thickness: float) -> CoalShape:
    x, y, z = 2.0 * np.append(scale * shape.half_extents, half_thickness)[:3]
    return CoalShape(coal.Box(x, y, z), _FROM_Z["z"])


def _sphere(shape: Sphere, scale: float, half_thickness: float) -> CoalShape:
    """A disc is lifted to a ball: coal handles a ball as a point, exactly."""
    return CoalShape(coal.Sphere(scale * shape.radius), _FROM_Z["z"])


def _ellipsoid(shape: Ellipsoid, scale: float, half_thickness: float) -> CoalShape:
    """coal has no elliptic cylinder; the ellipsoid has the ellipse as its section at z = 0."""
    x, y, z = np.append(scale * shape.semi_axes, half_thickness)[:3]
    return CoalShape(coal.Ellipsoid(x, y, z), _FROM_Z["z"])


def _cylinder(shape: Cylinder, scale: float, half_thickness: float) -> CoalShape:
    radius, length = scale * shape.radius, 2.0 * scale * shape.half_length
    return CoalShape(coal.Cylinder(radius, length), _FROM_Z[shape.axis])


def _capsule(shape: Capsule, scale: float, half_thickness: float) -> CoalShape:
    """A planar one is lifted to one in space, as a disc is to a ball."""
    radius, length = scale * shape.radius, 2.0 * scale * shape.half_length
    return CoalShape(coal.Capsule(radius, length), _FROM_Z[shape.axis])


def _cone(shape: Cone, scale: float, half_thickness: float) -> CoalShape:
    radius, length = scale * shape.radius, 2.0 * scale * shape.half_length
    return CoalShape(coal.Cone(radius, length), _FROM_Z[shape.axis])


def _polytope(shape: Polytope, scale: float, half_thickness: float) -> CoalShape:
    corners = scale * shape.corners
    if shape.dim == 2:
        ends = product(corners, (-half_thickness, half_thickness))
        corners = np.array([np.append(corner, z) for corner, z in ends])
    points, triangles = coal.StdVec_Vec3s(), coal.StdVec_Triangle()
    for point in corners:
        points.append(point)
    for i, j, k in hull_mesh(corners).triangles.tolist():
        triangles.append(coal.Triangle(i, j, k))
    return CoalShape(coal.Convex(points, triangles), _FROM_Z["z"])


_BUILDERS: Mapping[type[ConvexSet], Callable[[Any, float, float], CoalShape]] = {
    Box: _box,
    Sphere: _sphere,
    Ellipsoid: _ellipsoid,
    Cylinder: _cylinder,
    Capsule: _capsule,
    Cone: _cone,
    Polytope: _polytope,
}
