"""Small balls and ellipsoids that hold a set, and where they lie in its frame."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.capability import HasVertices
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere

EXCESS = 1e-6
"""The volume of the least ellipsoid is met to about this share times its dimension."""

MAX_STEPS = 100_000

GROWTH = 1e-9
"""Relative, so that rounding leaves no point outside."""


@dataclass(frozen=True)
class Enclosure:
    """A set with its place in the frame of what it holds."""

    shape: ConvexSet
    placement: Pose


def centred_ball(shape: ConvexSet) -> tuple[Array, float]:
    """Centre (d,) and radius in m of a ball that holds ``shape``; the least one for a box.

    The centre is the middle of the extents, not the shape's origin: a polytope may lie far from
    its origin. The radius of an unbounded set is infinite, its centre a point of its boundary.
    """
    if not np.isfinite(shape.bounding_radius):
        return shape.support(np.zeros(shape.dim))[1], np.inf
    middle, half = _extents(shape)
    if isinstance(shape, HasVertices):
        return middle, float(np.max(np.linalg.norm(shape.vertices() - middle, axis=1)))
    about_origin = shape.bounding_radius + float(np.linalg.norm(middle))
    return middle, min(float(np.linalg.norm(half)), about_origin)


def enclosing_ball(shape: ConvexSet) -> Enclosure:
    """The centred ball of a bounded ``shape``, grown against rounding."""
    middle, radius = centred_ball(shape)
    return Enclosure(Sphere(radius * (1.0 + GROWTH), shape.dim), Pose(middle, np.eye(shape.dim)))


def enclosing_ellipsoid(shape: ConvexSet) -> Enclosure:
    """The ellipsoid of least volume for boxes, cylinders, polytopes; else that of its extents."""
    closed = _CLOSED.get(type(shape))
    if closed is not None:
        return Enclosure(closed(shape), Pose.identity(shape.dim))
    if isinstance(shape, HasVertices):
        return _least_ellipsoid(shape.vertices())
    middle, half = _extents(shape)
    # A box lies in the ellipsoid of √d times its half-sizes.
    grown = np.sqrt(shape.dim) * half * (1.0 + GROWTH)
    return Enclosure(Ellipsoid(grown), Pose(middle, np.eye(shape.dim)))


def extents(shape: ConvexSet, at: Pose) -> Array:
    """Least and largest coordinates (2, d) of a set placed at a single pose."""
    axes = np.eye(shape.dim)
    least, largest = (-shape.support(at.unrotate(-axes))[0], shape.support(at.unrotate(axes))[0])
    return np.stack([at.position + least, at.position + largest])


def _extents(shape: ConvexSet) -> tuple[Array, Array]:
    """Middle and half-sizes (d,) of the box along the shape's own axes."""
    lower, upper = extents(shape, Pose.identity(shape.dim))
    return np.asarray(0.5 * (upper + lower)), np.asarray(0.5 * (upper - lower))


def _of_cylinder(shape: Cylinder) -> Ellipsoid:
    # Of x²/a² + ρ²/b² with h²/a² + r²/b² = 1 the volume a b² is least at a² = 3 h², b² = 3 r²/2.
    axes = np.full(3, np.sqrt(1.5) * shape.radius)
    axes["xyz".index(shape.axis)] = np.sqrt(3.0) * shape.half_length
    return Ellipsoid(axes * (1.0 + GROWTH))


def _of_ball(shape: Sphere) -> ConvexSet:
    return shape


_CLOSED: dict[type[ConvexSet], Callable[..., ConvexSet]] = {
    Cylinder: _of_cylinder,
    Sphere: _of_ball,
    Ellipsoid: lambda shape: shape,
}


def _least_ellipsoid(points: Array) -> Enclosure:
    """Khachiyan's ascent on the weights of the points (k, d), then grown to hold them all.

    L. G. Khachiyan, 10.1287/moor.21.2.307; the step is that of M. J. Todd and E. A. Yıldırım,
    10.1016/j.dam.2007.02.013, without its steps away.
    """
    count, d = points.shape
    lifted = np.hstack([points, np.ones((count, 1))])
    weights = np.full(count, 1.0 / count)
    for _ in range(MAX_STEPS):
        moment = lifted.T @ (weights[:, None] * lifted)
        reach = np.einsum("ki,ij,kj->k", lifted, np.linalg.inv(moment), lifted)
        far = int(np.argmax(reach))
        excess = float(reach[far]) / (d + 1.0) - 1.0
        if excess <= EXCESS:
            break
        step = (reach[far] - d - 1.0) / ((d + 1.0) * (reach[far] - 1.0))
        weights *= 1.0 - step
        weights[far] += step
    centre = weights @ points
    spread = (points - centre).T @ (weights[:, None] * (points - centre))
    # {x : (x − c)ᵀ spread⁻¹ (x − c) ≤ d}, scaled to its farthest point.
    sizes, axes = np.linalg.eigh(spread)
    if np.linalg.det(axes) < 0.0:
        axes[:, 0] *= -1.0
    local = (points - centre) @ axes / np.sqrt(sizes)
    scale = float(np.max(np.linalg.norm(local, axis=1))) * (1.0 + GROWTH)
    return Enclosure(Ellipsoid(scale * np.sqrt(sizes)), Pose(centre, axes))
