"""A convex piece of a decomposition: its shape, where it lies, and what of it the proof uses."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array, as_array
from berthing.geometry.box import Box
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.mesh.hull import hull_volume

# Sides of the prism that stands for a cylinder in the proof: it lies inside by 0.2% of the radius.
PRISM_SIDES = 48
# A cylinder's radius over the inner radius of that prism.
ROUNDING = float(1.0 / np.cos(np.pi / PRISM_SIDES))


@dataclass(frozen=True, eq=False)
class Piece:
    """A convex set in the frame of the mesh.

    Attributes:
        shape: a polytope, a box, or a cylinder along its x axis, in metres.
        placement: a single pose of the shape's frame in the mesh's.
        written: what it was read from, since numbers that are normalised when read would come out
            otherwise by a rounding; None of a piece that was made here.
    """

    shape: ConvexSet
    placement: Pose
    written: Mapping[str, Any] | None = None

    @cached_property
    def core(self) -> Polytope:
        """A polytope in the frame of the mesh, inside the piece: the piece itself, if flat-sided.

        Of this the proof speaks: what the core covers, the piece covers.
        """
        return _CORES[type(self.shape)](self.shape, self.placement)

    def pushed(self, push_m: float) -> Piece:
        """The piece with every face of its core moved out by ``push_m``, its placement as it is."""
        return Piece(_PUSHED[type(self.shape)](self.shape, push_m), self.placement)

    @property
    def volume(self) -> float:
        """In m³."""
        return _VOLUMES[type(self.shape)](self.shape)

    @property
    def faces(self) -> int:
        """How many; a round one counts as one."""
        return 3 if isinstance(self.shape, Cylinder) else len(self.core.b)

    def to_json(self) -> dict[str, Any]:
        """As a part of a scenario file: shape, position and attitude, the latter where needed."""
        if self.written is not None:
            return dict(self.written)
        block: dict[str, Any] = {"shape": _WRITERS[type(self.shape)](self.shape)}
        if np.any(self.placement.position != 0.0):
            block["position_m"] = self.placement.position.tolist()
        if np.any(self.placement.rotation != np.eye(3)):
            block["attitude"] = quaternion.from_matrix(self.placement.rotation).tolist()
        return block

    @staticmethod
    def from_json(block: Mapping[str, Any], where: str) -> Piece:
        """What ``to_json`` wrote.

        Raises:
            InputError: anything else, with the key.
        """
        shape = block.get("shape")
        kind = shape.get("type") if isinstance(shape, Mapping) else None
        if not isinstance(shape, Mapping) or kind not in _READERS:
            raise InputError(f"{where}.shape", "is no piece", f"one of: {', '.join(_READERS)}")
        position = as_array(block.get("position_m", [0, 0, 0]), (3,), f"{where}.position_m")
        q = as_array(block.get("attitude", [1, 0, 0, 0]), (4,), f"{where}.attitude")
        try:
            return Piece(_READERS[kind](shape), Pose.from_quaternion(position, q), block)
        except InputError as error:
            raise InputError(f"{where}.{error.where}", error.what, error.expected) from None
        except (KeyError, TypeError, ValueError):
            raise InputError(f"{where}.shape", f"is not a whole {kind}") from None


def _moved(A: Array, b: Array, placement: Pose) -> Polytope:
    rows = placement.rotate(A)
    return Polytope(rows, b + rows @ placement.position)


def _polytope_core(shape: Polytope, placement: Pose) -> Polytope:
    still = not np.any(placement.position) and np.array_equal(placement.rotation, np.eye(3))
    return shape if still else _moved(shape.A, shape.b, placement)


def _box_core(shape: Box, placement: Pose) -> Polytope:
    A, b = shape.halfspaces()
    return _moved(A, b, placement)


def _cylinder_core(shape: Cylinder, placement: Pose) -> Polytope:
    """A prism whose edges lie on the round face."""
    angle = np.arange(PRISM_SIDES) * (2.0 * np.pi / PRISM_SIDES)
    sides = np.stack([np.zeros_like(angle), np.cos(angle), np.sin(angle)], axis=1)
    ends = np.array([[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]])
    b = np.concatenate(
        [np.full(PRISM_SIDES, shape.radius / ROUNDING), np.full(2, shape.half_length)]
    )
    return _moved(np.concatenate([sides, ends]), b, placement)


_CORES: dict[type[ConvexSet], Callable[[Any, Pose], Polytope]] = {
    Polytope: _polytope_core,
    Box: _box_core,
    Cylinder: _cylinder_core,
}

_VOLUMES: dict[type[ConvexSet], Callable[[Any], float]] = {
    Polytope: lambda s: hull_volume(s.corners),
    Box: lambda s: float(np.prod(2.0 * s.half_extents)),
    Cylinder: lambda s: float(np.pi * s.radius**2 * 2.0 * s.half_length),
}

_PUSHED: dict[type[ConvexSet], Callable[[Any, float], ConvexSet]] = {
    Polytope: lambda s, push: Polytope(s.A, s.b + push),
    Box: lambda s, push: Box(s.half_extents + push),
    Cylinder: lambda s, push: Cylinder(s.radius + ROUNDING * push, s.half_length + push, s.axis),
}

_WRITERS: dict[type[ConvexSet], Callable[[Any], dict[str, Any]]] = {
    Polytope: lambda s: {
        "type": "polytope", "normals": s.A.tolist(), "offsets_m": s.b.tolist()
    },
    Box: lambda s: {"type": "box", "size_m": (2.0 * s.half_extents).tolist()},
    Cylinder: lambda s: {
        "type": "cylinder", "radius_m": s.radius, "length_m": 2.0 * s.half_length, "axis": "x"
    },
}  # fmt: skip


def _along_x(block: Mapping[str, Any]) -> Cylinder:
    """KeyError for another axis: such a cylinder was not written here."""
    return {"x": Cylinder(block["radius_m"], 0.5 * block["length_m"], "x")}[block["axis"]]


_READERS: dict[str, Callable[[Mapping[str, Any]], ConvexSet]] = {
    "polytope": lambda b: Polytope(np.array(b["normals"]), np.array(b["offsets_m"])),
    "box": lambda b: Box(0.5 * np.array(b["size_m"])),
    "cylinder": _along_x,
}
