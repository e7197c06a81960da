"""Meshes and robot descriptions in files."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Discriminator, Field, JsonValue, Tag, model_validator
from pydantic_core import PydanticCustomError

from berthing.scenario.schema.fields import Block, Name, Number, Positive, Vector3, shape_of
from berthing.scenario.schema.shapes import PartBlock, Placed, Shape, ShapeModelBlock

# Of `berthing.mesh.units`, whose names these are; a test compares them.
Units = Literal["m", "dm", "cm", "mm", "um", "in", "ft"]


class PieceBlock(Placed):
    """A convex piece of a mesh, in the frame of the mesh."""

    shape: Shape


class MeshPartBlock(Placed):
    """A part given by a mesh file: STL, OBJ, PLY or GLB."""

    name: Name
    mesh: str = Field(description="path of the file, from the folder of the scenario")
    units: Units | None = Field(default=None, description="of the file's numbers; GLB has metres")
    scale_m: Vector3 | None = Field(
        default=None, description="metres in one of the file's numbers along each axis, or units"
    )
    volume_ratio: Annotated[Positive, Field(gt=1)] | None = Field(
        default=None, description="volume of the pieces over that of the mesh, to aim at"
    )
    shape_model: ShapeModelBlock | None = Field(
        default=None, description="of every piece, instead of the default under solver"
    )
    pieces: list[PieceBlock] | None = Field(
        default=None, description="written by berthing: convex sets that contain the mesh"
    )
    certificate: dict[str, JsonValue] | None = Field(
        default=None, description="written by berthing: the proof that they do, and the mesh's hash"
    )

    @model_validator(mode="after")
    def _whole(self) -> MeshPartBlock:
        if self.units is not None and self.scale_m is not None:
            raise PydanticCustomError("rule", "has both units and scale_m; one says it all")
        if (self.pieces is None) != (self.certificate is None):
            raise PydanticCustomError("rule", "needs pieces and certificate together, or neither")
        return self


class UrdfBlock(Block):
    """A robot description, its joints held still."""

    file: str = Field(description="path of the file, from the folder of the scenario")
    joints: dict[str, Number] = Field(
        default={}, description="positions of joints by name, in rad or m; 0 for the others"
    )
    sha256: str | None = Field(
        default=None, description="written by berthing when it has put the links among the parts"
    )


Urdf = Annotated[
    Annotated[str, Tag("word")] | Annotated[UrdfBlock, Tag("block")], Discriminator(shape_of)
]


def _kind_of_part(value: object) -> str:
    has_mesh = "mesh" in value if isinstance(value, dict) else isinstance(value, MeshPartBlock)
    return "part from a mesh" if has_mesh else "part with a shape"


AnyPart = Annotated[
    Annotated[PartBlock, Tag("part with a shape")]
    | Annotated[MeshPartBlock, Tag("part from a mesh")],
    Discriminator(_kind_of_part),
]
Parts = Annotated[list[AnyPart], Field(min_length=1)]


class Bodied(Block):
    """What has a body: parts, the links of a robot, or both."""

    parts: Parts | None = None
    urdf: Urdf | None = Field(default=None, description="a robot description, all of its links")
