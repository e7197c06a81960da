"""Shapes and parts in files. Sizes are full sizes, as one measures them."""

from __future__ import annotations

import math
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
    Whole,
)

Axis = Literal["x", "y", "z"]
Even = Annotated[Whole, Field(ge=2, multiple_of=2)]


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
    axis: Axis = "x"


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


class SuperellipsoidShape(Block):
    """The points with sum of (x_i / semi_axes_i)^exponents_i at most size^size_exponent."""

    type: Literal["superellipsoid"]
    semi_axes_m: Sizes
    exponents: Annotated[list[Even], Field(min_length=1, max_length=3)] = Field(
        description="even, one an axis, or one for all"
    )
    size: Positive = 1.0
    size_exponent: Positive = 2.0


class SmoothedPolytopeShape(Block):
    """The points with sum of base^(exponents_j (normals_j . x - offsets_j)) at most 1."""

    type: Literal["smoothed-polytope"]
    normals: list[Vector]
    offsets_m: list[Number]
    exponents: list[Positive] = Field(description="per metre, one a row, or one for all")
    level_exponent: Positive | None = Field(default=None, description="scales the level only")
    base: Annotated[Positive, Field(gt=1)] = math.e


class CapsuleShape(Block):
    """The points within a radius of a segment."""

    type: Literal["capsule"]
    radius_m: Positive
    length_m: Positive = Field(description="of the straight part, caps excluded")
    axis: Axis = "x"


class ConeShape(Block):
    """A circular cone, its tip forward on the axis, its origin half way up."""

    type: Literal["cone"]
    radius_m: Positive
    length_m: Positive = Field(description="full height")
    axis: Axis = "x"


class TruncatedConeShape(Block):
    """A circular cone cut off below its tip, its origin half way up."""

    type: Literal["truncated-cone"]
    base_radius_m: Positive = Field(description="at the rear end of the axis")
    top_radius_m: Positive = Field(description="at the forward end of the axis")
    length_m: Positive = Field(description="full height")
    axis: Axis = "x"


class HalfSpaceShape(Block):
    """A wall or ground without end: the points with normal . x <= offset; of structures only."""

    type: Literal["half-space"]
    normal: Vector = Field(description="outward")
    offset_m: Number = 0.0


class OffsetShape(Block):
    """Another shape and all within a radius of it."""

    type: Literal["offset"]
    shape: Shape
    radius_m: Positive


class IntersectionShape(Block):
    """What several placed shapes have in common; half-spaces are welcome."""

    type: Literal["intersection"]
    sets: Annotated[list[MemberBlock], Field(min_length=2)]


Shape = Annotated[
    BoxShape
    | SphereShape
    | PointShape
    | EllipsoidShape
    | CylinderShape
    | PolytopeShape
    | SuperellipsoidShape
    | SmoothedPolytopeShape
    | CapsuleShape
    | ConeShape
    | TruncatedConeShape
    | HalfSpaceShape
    | OffsetShape
    | IntersectionShape,
    Field(discriminator="type"),
]


class ShapeModelBlock(Block):
    """What stands for a shape while a motion is planned; the check has the shape itself."""

    side: Literal["exact", "inner", "outer"]
    exponent: Positive | None = Field(
        default=None,
        description="per metre for boxes and polytopes, an even power for cylinders",
    )
    error_m: Positive | None = Field(
        default=None, description="distance allowed between model and shape, or exponent"
    )


class Placed(Block):
    """Something with a pose in an outer frame: the origin, unturned, unless it says otherwise."""

    position_m: Vector | None = None
    attitude: Quaternion | None = Field(
        default=None, description="in space: unit quaternion, scalar first, own to outer frame"
    )
    angle_rad: Number | None = Field(
        default=None, description="in the plane: counter-clockwise, own to outer frame"
    )


class MemberBlock(Placed):
    """One of the sets that an intersection is made of, in the frame of the intersection."""

    shape: Shape


class PartBlock(Placed):
    """A convex part of a body, placed in the body's frame."""

    name: Name
    shape: Shape
    shape_model: ShapeModelBlock | None = Field(
        default=None, description="instead of the default under solver"
    )


OffsetShape.model_rebuild()
IntersectionShape.model_rebuild()
