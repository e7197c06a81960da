"""Shapes, placements and bodies."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.body import Body, Part
from berthing.geometry.box import Box
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.scenario.attitude import unit
from berthing.scenario.build.names import check_unique
from berthing.scenario.schema.fields import Block
from berthing.scenario.schema.meshes import AnyPart
from berthing.scenario.schema.shapes import (
    BoxShape,
    CylinderShape,
    EllipsoidShape,
    PartBlock,
    Placed,
    PointShape,
    PolytopeShape,
    SphereShape,
)
from berthing.scenario.source import Path, Source


def _polytope(block: PolytopeShape, dim: int) -> ConvexSet:
    if block.vertices_m is not None:
        return Polytope.from_vertices(rows_of(block.vertices_m, dim, "vertices_m"))
    normals = rows_of(block.normals or [], dim, "normals")
    return Polytope.from_halfspaces(normals, np.array(block.offsets_m))


def rows_of(rows: Sequence[Sequence[float]], dim: int, where: str) -> Array:
    """Rows (k, dim); InputError at the first of another length."""
    for i, row in enumerate(rows):
        if len(row) != dim:
            raise InputError(where, f"row {i} has {len(row)} components", f"{dim}")
    return np.array(rows, dtype=np.float64).reshape(-1, dim)


_SHAPES: dict[type[Block], Callable[[Any, int], ConvexSet]] = {
    BoxShape: lambda b, dim: Box(0.5 * np.array(b.size_m)),
    SphereShape: lambda b, dim: Sphere(b.radius_m, dim),
    PointShape: lambda b, dim: Sphere(0.0, dim),
    EllipsoidShape: lambda b, dim: Ellipsoid(np.array(b.semi_axes_m)),
    CylinderShape: lambda b, dim: Cylinder(b.radius_m, 0.5 * b.length_m, b.axis),
    PolytopeShape: _polytope,
}


def build_body(parts: Sequence[AnyPart], dim: int, source: Source, path: Path) -> Body:
    """A body of the scenario's dimension.

    Raises:
        InputError: a shape that is none, one of another dimension, or a name used twice.
    """
    check_unique([part.name for part in parts], source, path)
    found = [part for i, p in enumerate(parts) for part in _parts(p, dim, source, (*path, i))]
    return Body(tuple(found))


def build_pose(block: Placed, dim: int, source: Source, path: Path) -> Pose:
    """The pose that a block gives, the identity where it is silent.

    Raises:
        InputError: a position or turn of another dimension, or a quaternion that is not unit.
    """
    position = np.zeros(dim) if block.position_m is None else np.array(block.position_m)
    if len(position) != dim:
        what = f"has {len(position)} components in a scenario of {dim} dimensions"
        raise source.error((*path, "position_m"), what)
    if dim == 2:
        if block.attitude is not None:
            raise source.error((*path, "attitude"), "is a turn in space", "angle_rad, in the plane")
        return Pose.planar(position, block.angle_rad or 0.0)
    if block.angle_rad is not None:
        raise source.error((*path, "angle_rad"), "is a turn in the plane", "attitude, in space")
    if block.attitude is None:
        return Pose(position, np.eye(3))
    with source.at(*path):
        return Pose.from_quaternion(position, unit(np.array(block.attitude), 4, "attitude"))


def _parts(block: AnyPart, dim: int, source: Source, path: Path) -> list[Part]:
    """One part, or of a mesh its pieces: ``name.1``, ``name.2`` and so on, where it has several."""
    if isinstance(block, PartBlock):
        return [_part(block, dim, source, path)]
    outer = build_pose(block, dim, source, path)
    pieces = block.pieces or []
    found = []
    for i, piece in enumerate(pieces):
        name = f"{block.name}.{i + 1}" if len(pieces) > 1 else block.name
        inner = (*path, "pieces", i)
        with source.at(*inner, "shape"):
            shape = _SHAPES[type(piece.shape)](piece.shape, dim)
        found.append(Part(name, shape, outer.compose(build_pose(piece, dim, source, inner))))
    return found


def _part(block: PartBlock, dim: int, source: Source, path: Path) -> Part:
    with source.at(*path, "shape"):
        shape = _SHAPES[type(block.shape)](block.shape, dim)
    if shape.dim != dim:
        what = f"has {shape.dim} dimensions in a scenario of {dim}"
        raise source.error((*path, "shape"), what)
    return Part(block.name, shape, build_pose(block, dim, source, path))
