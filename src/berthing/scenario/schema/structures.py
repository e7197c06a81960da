"""Structures and their motions in files."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from berthing.scenario.schema.fields import Block, Name, Number, Quaternion, Vector, Vector3
from berthing.scenario.schema.meshes import Bodied
from berthing.scenario.schema.shapes import Placed


class FixedMotion(Block):
    """At rest at the structure's pose."""

    type: Literal["fixed"]


class ConstantVelocityMotion(Block):
    """From the structure's pose at t = 0, straight on."""

    type: Literal["constant-velocity"]
    velocity_m_s: Vector


class SpinMotion(Block):
    """From the structure's pose at t = 0, turning about an axis of its own."""

    type: Literal["spin"]
    rate_rad_s: Number
    axis: Vector3 = Field(default=[0.0, 0.0, 1.0], description="in the structure's frame")
    velocity_m_s: Vector | None = Field(default=None, description="of its origin")


class TabulatedMotion(Block):
    """Through a table of poses, by cubic splines; the structure has no pose beside it."""

    type: Literal["tabulated"]
    times_s: list[Number]
    positions_m: list[Vector]
    attitudes: list[Quaternion] | None = None
    angles_rad: list[Number] | None = Field(default=None, description="in the plane")


MotionBlock = Annotated[
    FixedMotion | ConstantVelocityMotion | SpinMotion | TabulatedMotion,
    Field(discriminator="type"),
]


class StructureBlock(Placed, Bodied):
    """A body that moves by a law of its own."""

    name: Name
    motion: MotionBlock = FixedMotion(type="fixed")
