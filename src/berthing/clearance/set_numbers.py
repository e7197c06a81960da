"""Convex sets as the numbers that the compiled distance takes; ``native/shape.h`` lists them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from math import log
from typing import Any

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capsule import Capsule
from berthing.geometry.cone import Cone
from berthing.geometry.convex_set import ConvexSet, norm
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.frustum import Frustum
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.intersection import Intersection
from berthing.geometry.offset import Offset
from berthing.geometry.polytope import Polytope
from berthing.geometry.revolution import AXES
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.sphere import Sphere
from berthing.geometry.superellipsoid import Superellipsoid
from berthing.geometry.truncated_cone import TruncatedCone

# As in native/shape.h.
POINT, SEGMENT, BOX, ELLIPSOID, CYLINDER, FRUSTUM, POLYTOPE = map(float, range(7))
SUPERELLIPSOID, LOG_SUM_EXP, HALF_SPACE, SMOOTHED_BOX, CONIC = 7.0, 8.0, 9.0, 10.0, 11.0
# Of exponent times half size: the kernel's formulas for boxes square exp of it.
STEEPEST = 300.0
# As in native/conic.h: variables, and rows of half-lines and cones.
MOST_COLUMNS, MOST_CONE_ROWS = 24, 256
# Rows beyond this many are not approached by way of rounder sets: see native/support.h.
MOST_ROWS = 256

Core = tuple[float, float, list[float]]


@lru_cache(maxsize=4096)
def set_numbers(shape: ConvexSet) -> Array | None:
    """Kind, pad, size and sizes of the core as one array; None for a set that is not known."""
    pad, core = 0.0, shape
    while isinstance(core, Offset):
        pad, core = pad + core.radius, core.base
    if isinstance(core, Sphere | Capsule):
        pad += core.radius
    build = _BUILDERS.get(type(core))
    if build is None:
        return None
    found = build(core)
    if found is None:
        return None
    kind, size, numbers = found
    if kind == ELLIPSOID and len(set(numbers[: shape.dim])) == 1:
        # A ball, whatever it is called.
        kind, pad, size, numbers = POINT, pad + numbers[0], 0.0, []
    return np.array([kind, pad, size, *numbers], dtype=np.float64)


def _point(shape: Sphere) -> Core:
    return POINT, 0.0, []


def _segment(shape: Capsule) -> Core:
    return SEGMENT, 2.0 * shape.half_length, [AXES.index(shape.axis), shape.half_length]


def _box(shape: Box) -> Core:
    return BOX, 2.0 * shape.bounding_radius, _solid(shape.half_extents)


def _ellipsoid(shape: Ellipsoid) -> Core:
    return ELLIPSOID, 2.0 * shape.bounding_radius, _solid(shape.semi_axes)


def _cylinder(shape: Cylinder) -> Core:
    sizes = [float(shape.axis_index), shape.radius, shape.half_length]
    return CYLINDER, 2.0 * shape.bounding_radius, sizes


def _cone(shape: Cone | TruncatedCone) -> Core:
    f: Frustum = shape.frustum
    return FRUSTUM, 2.0 * f.bounding_radius, [float(f.axis), f.first, f.second, f.half_length]


def _polytope(shape: Polytope) -> Core:
    corners = _in_space(shape.corners)
    return POLYTOPE, _width(corners), [float(len(corners)), *corners.ravel()]


def _superellipsoid(shape: Superellipsoid) -> Core:
    if np.all(shape.exponents == 2):
        return ELLIPSOID, 2.0 * shape.bounding_radius, _solid(shape.reaches)
    exponents = np.full(3, 2.0)
    exponents[: shape.dim] = shape.exponents
    return SUPERELLIPSOID, 2.0 * shape.bounding_radius, [*_solid(shape.reaches), *exponents]


def _log_sum_exp(shape: SmoothedPolytope) -> Core:
    natural = log(shape.base) * shape.exponents
    box = _smoothed_box(shape.A, shape.b, natural)
    if box is not None:
        return SMOOTHED_BOX, shape.hill.size, box
    rows, centre = _in_space(natural[:, None] * shape.A), _in_space(shape.centre[None])[0]
    numbers = [float(len(rows)), *centre, *rows.ravel(), *(natural * shape.b)]
    return LOG_SUM_EXP, shape.hill.size, numbers


def _smoothed_box(A: Array, b: Array, natural: Array) -> list[float] | None:
    """For two rows an axis, one each way, of the same exponent; None for other polytopes."""
    dim, axes = A.shape[1], np.argmax(np.abs(A), axis=1)
    order = np.lexsort((-A[np.arange(len(A)), axes], axes))
    pairs = np.stack([np.eye(dim), -np.eye(dim)], axis=1).reshape(-1, dim)
    if len(A) != 2 * dim or not np.array_equal(A[order], pairs):
        return None
    (up, down), (q, also) = b[order].reshape(dim, 2).T, natural[order].reshape(dim, 2).T
    reach = 0.5 * (up + down)
    if not np.array_equal(q, also) or np.max(q * reach) > STEEPEST:
        return None
    return [x for row in (0.5 * (up - down), q, np.exp(-q * reach), reach) for x in _solid(row)]


def _half_space(shape: HalfSpace) -> Core:
    return HALF_SPACE, 0.0, [*_in_space(shape.normal[None])[0], shape.offset]


def _conic(shape: Intersection) -> Core | None:
    problem = shape.problem
    cones, rows, size = problem.cone_G.shape
    lines = len(problem.line_h)
    if size > MOST_COLUMNS or lines + cones * rows > MOST_CONE_ROWS:
        return None
    arrays = problem.line_G, problem.cone_G, problem.line_h, problem.cone_h
    numbers = [size, lines, cones, rows, problem.unit, problem.reach]
    return (
        CONIC,
        2.0 * shape.bounding_radius,
        [*map(float, numbers), *np.concatenate([array.ravel() for array in arrays])],
    )


def _solid(sizes: Array) -> list[float]:
    """Three sizes, the third 0 in the plane."""
    return [float(size) for size in np.append(sizes, 0.0)[:3]]


def _in_space(points: Array) -> Array:
    """Points (k, 3), in z = 0 where they were planar."""
    solid = np.zeros((len(points), 3))
    solid[:, : points.shape[1]] = points
    return solid


def _width(corners: Array) -> float:
    """No two corners are farther apart."""
    return 2.0 * float(np.max(norm(corners - np.mean(corners, axis=0))))


_BUILDERS: Mapping[type[ConvexSet], Callable[[Any], Core | None]] = {
    Sphere: _point,
    Capsule: _segment,
    Box: _box,
    Ellipsoid: _ellipsoid,
    Cylinder: _cylinder,
    Cone: _cone,
    TruncatedCone: _cone,
    Polytope: _polytope,
    Superellipsoid: _superellipsoid,
    SmoothedPolytope: _log_sum_exp,
    HalfSpace: _half_space,
    Intersection: _conic,
}
