"""Shapes and parts in files. Sizes are full sizes, as one measures them."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from berthing.scenario.schema.fields import (
    Block,
    Name,
    Number,
    Positive,
    Quaternion,
    Sizes,
    Vector,
)


class BoxShape(Block):
    """A rectangle or cuboid about its own origin."""

    type: Literal["box"]
    size_m: Sizes = Field(description="full size along each axis")


class SphereShape(Block):
    """A disc or ball."""

    type: Literal["sphere"]
    radius_m: Positive


class PointShape(Block):
    """A point."""

    type: Literal["point"]


class EllipsoidShape(Block):
    """An ellipse or ellipsoid along its own axes."""

    type: Literal["ellipsoid"]
    semi_axes_m: Sizes


class CylinderShape(Block):
    """A circular cylinder about its own origin."""

    type: Literal["cylinder"]
    radius_m: Positive
    length_m: Positive = Field(description="full length")
    axis: Literal["x", "y", "z"] = "x"


class PolytopeShape(Block):
    """The hull of vertices, or the points x with normals · x <= offsets."""

    type: Literal["polytope"]
    vertices_m: list[Vector] | None = None
    normals: list[Vector] | None = None
    offsets_m: list[Number] | None = None

    @model_validator(mode="after")
    def _one_description(self) -> PolytopeShape:
        by_vertices = self.vertices_m is not None
        given = (self.normals is not None, self.offsets_m is not None)
        if given != (not by_vertices, not by_vertices):
            raise PydanticCustomError(
                "rule", "needs one description: vertices_m, or normals with offsets_m"
            )
        return self


Shape = Annotated[
    BoxShape | SphereShape | PointShape | EllipsoidShape | CylinderShape | PolytopeShape,
    Field(discriminator="type"),
]


class Placed(Block):
    """Something with a pose in an outer frame: the origin, unturned, unless it says otherwise."""

    position_m: Vector | None = None
    attitude: Quaternion | None = Field(
        default=None, description="in space: unit quaternion, scalar first, own to outer frame"
    )
    angle_rad: Number | None = Field(
        default=None, description="in the plane: counter-clockwise, own to outer frame"
    )


class PartBlock(Placed):
    """A convex part of a body, placed in the body's frame."""

    name: Name
    shape: Shape
