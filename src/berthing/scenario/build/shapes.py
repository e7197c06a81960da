"""Shapes from their blocks. Files have full sizes, the sets half ones."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from berthing.errors import InputError
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
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.sphere import Sphere
from berthing.geometry.superellipsoid import Superellipsoid
from berthing.geometry.truncated_cone import TruncatedCone
from berthing.scenario.build.poses import build_pose
from berthing.scenario.schema.fields import Block
from berthing.scenario.schema.shapes import (
    BoxShape,
    CapsuleShape,
    ConeShape,
    CylinderShape,
    EllipsoidShape,
    HalfSpaceShape,
    IntersectionShape,
    OffsetShape,
    PointShape,
    PolytopeShape,
    SmoothedPolytopeShape,
    SphereShape,
    SuperellipsoidShape,
    TruncatedConeShape,
)
from berthing.scenario.source import Path, Source


def build_shape(block: Block, dim: int, source: Source, path: Path) -> ConvexSet:
    """The set that a block of the file describes, at this key path.

    Raises:
        InputError: a shape that is none, or one of another dimension.
    """
    if isinstance(block, OffsetShape):
        base = build_shape(block.shape, dim, source, (*path, "shape"))
        with source.at(*path):
            return Offset(base, block.radius_m)
    if isinstance(block, IntersectionShape):
        return _intersection(block, dim, source, path)
    with source.at(*path):
        shape = _SHAPES[type(block)](block, dim)
    if shape.dim != dim:
        raise source.error(path, f"has {shape.dim} dimensions in a scenario of {dim}")
    return shape


def rows_of(rows: Sequence[Sequence[float]], dim: int, where: str) -> Array:
    """Rows (k, dim); InputError at the first of another length."""
    for i, row in enumerate(rows):
        if len(row) != dim:
            raise InputError(where, f"row {i} has {len(row)} components", f"{dim}")
    return np.array(rows, dtype=np.float64).reshape(-1, dim)


def _intersection(block: IntersectionShape, dim: int, source: Source, path: Path) -> ConvexSet:
    sets, poses = [], []
    for i, member in enumerate(block.sets):
        inner = (*path, "sets", i)
        sets.append(build_shape(member.shape, dim, source, (*inner, "shape")))
        poses.append(build_pose(member, dim, source, inner))
    with source.at(*path):
        return Intersection(sets, poses)


def _polytope(block: PolytopeShape, dim: int) -> ConvexSet:
    if block.vertices_m is not None:
        return Polytope.from_vertices(rows_of(block.vertices_m, dim, "vertices_m"))
    normals = rows_of(block.normals or [], dim, "normals")
    return Polytope.from_halfspaces(normals, np.array(block.offsets_m))


def _smoothed_polytope(block: SmoothedPolytopeShape, dim: int) -> ConvexSet:
    return SmoothedPolytope(
        rows_of(block.normals, dim, "normals"),
        np.array(block.offsets_m),
        np.array(block.exponents),
        block.level_exponent,
        block.base,
    )


def _superellipsoid(block: SuperellipsoidShape, dim: int) -> ConvexSet:
    return Superellipsoid(
        np.array(block.semi_axes_m), np.array(block.exponents), block.size, block.size_exponent
    )


_SHAPES: dict[type[Block], Callable[[Any, int], ConvexSet]] = {
    BoxShape: lambda b, dim: Box(0.5 * np.array(b.size_m)),
    SphereShape: lambda b, dim: Sphere(b.radius_m, dim),
    PointShape: lambda b, dim: Sphere(0.0, dim),
    EllipsoidShape: lambda b, dim: Ellipsoid(np.array(b.semi_axes_m)),
    CylinderShape: lambda b, dim: Cylinder(b.radius_m, 0.5 * b.length_m, b.axis),
    PolytopeShape: _polytope,
    SuperellipsoidShape: _superellipsoid,
    SmoothedPolytopeShape: _smoothed_polytope,
    CapsuleShape: lambda b, dim: Capsule(b.radius_m, 0.5 * b.length_m, b.axis, dim),
    ConeShape: lambda b, dim: Cone(b.radius_m, 0.5 * b.length_m, b.axis),
    TruncatedConeShape: lambda b, dim: TruncatedCone(
        b.base_radius_m, b.top_radius_m, 0.5 * b.length_m, b.axis
    ),
    HalfSpaceShape: lambda b, dim: HalfSpace(np.array(b.normal), b.offset_m),
}
