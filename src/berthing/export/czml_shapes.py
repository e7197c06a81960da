"""CZML's shapes for ours; those that it lacks, such as polytopes, are not drawn."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.sphere import Sphere

# A planar set is drawn as thick as this.
THICKNESS_M = 0.01
_SAME = np.array([1.0, 0.0, 0.0, 0.0])
# CZML's cylinders lie along z: the turns that lay z along our axis.
_TURNS = {
    "x": quaternion.from_axis_angle(np.array([0.0, 1.0, 0.0]), np.pi / 2),
    "y": quaternion.from_axis_angle(np.array([1.0, 0.0, 0.0]), -np.pi / 2),
    "z": _SAME,
}

Drawn = tuple[Array, dict[str, Any]]


def graphics(shape: ConvexSet, rgba: list[int]) -> Drawn | None:
    """The turn (4,) to put before the part's own, and the packet's entry; None where none fits."""
    make = _SHAPES.get(type(shape))
    if make is None:
        return None
    turn, (key, entry) = make(shape)
    look = {"material": {"solidColor": {"color": {"rgba": [*rgba[:3], 160]}}}, "outline": True}
    return turn, {key: {**entry, **look}}


def _box(shape: Any) -> tuple[Array, tuple[str, dict[str, Any]]]:
    return _SAME, ("box", {"dimensions": {"cartesian": _three(2.0 * shape.half_extents)}})


def _sphere(shape: Any) -> tuple[Array, tuple[str, dict[str, Any]]]:
    radius = max(shape.radius, THICKNESS_M)
    return _SAME, ("ellipsoid", {"radii": {"cartesian": _three(np.full(shape.dim, radius))}})


def _ellipsoid(shape: Any) -> tuple[Array, tuple[str, dict[str, Any]]]:
    return _SAME, ("ellipsoid", {"radii": {"cartesian": _three(shape.semi_axes)}})


def _cylinder(shape: Any) -> tuple[Array, tuple[str, dict[str, Any]]]:
    radius = {"topRadius": shape.radius, "bottomRadius": shape.radius}
    return _TURNS[shape.axis], ("cylinder", {"length": 2.0 * shape.half_length, **radius})


def _three(sizes: Array) -> list[float]:
    return [float(v) for v in [*sizes, THICKNESS_M][:3]]


_SHAPES: dict[type, Callable[[Any], tuple[Array, tuple[str, dict[str, Any]]]]] = {
    Box: _box,
    Sphere: _sphere,
    Ellipsoid: _ellipsoid,
    Cylinder: _cylinder,
}
