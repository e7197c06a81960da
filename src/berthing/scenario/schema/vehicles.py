"""Vehicles in files: dynamics, limits, start and goal."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Discriminator, Field, Tag, model_validator
from pydantic_core import PydanticCustomError

from berthing.scenario.schema.fields import (
    Block,
    Name,
    NonNegative,
    Number,
    PerAxis,
    Positive,
    Quaternion,
    Vector,
    Vector3,
    shape_of,
)
from berthing.scenario.schema.meshes import Bodied
from berthing.scenario.schema.user import PathConstraintBlock, UserModelBlock

Rows3 = list[Vector3]


class WrenchBlock(Block):
    """A known force and torque, body frame, linear between the times."""

    name: Name
    point_m: Vector3 = Field(default=[0.0, 0.0, 0.0], description="where the force acts")
    times_s: list[Number]
    force_n: Rows3
    torque_nm: Rows3


class RigidBodyBlock(Block):
    """The paper's spacecraft."""

    model: Literal["rigid-body"]
    mass_kg: Positive | None = Field(
        default=None, description="may be absent where the parts' density or a URDF gives it"
    )
    inertia_kg_m2: (
        Annotated[
            Annotated[list[Number], Field(min_length=3, max_length=3), Tag("diagonal")]
            | Annotated[list[Vector3], Field(min_length=3, max_length=3), Tag("matrix")],
            Discriminator(lambda v: "matrix" if _has_rows(v) else "diagonal"),
        ]
        | None
    ) = Field(
        default=None,
        description="about the reference point: three principal moments, or 3×3; may be absent "
        "where meshes or a URDF give it",
    )
    first_moment_kg_m: Vector3 = Field(
        default=[0.0, 0.0, 0.0], description="mass times the centre of mass"
    )
    density_kg_m3: Positive | None = Field(
        default=None, description="of meshes, in place of mass, first moment and inertia"
    )
    wrenches: list[WrenchBlock] = Field(default=[])


class PointMassBlock(Block):
    """A double integrator, force in inertial axes."""

    model: Literal["point-mass"]
    mass_kg: Positive


class BicycleBlock(Block):
    """A car in the plane, reference at the rear axle; limits by name under states and controls."""

    model: Literal["bicycle"]
    wheelbase_m: Positive


class FreeFlyerBlock(Block):
    """A rigid body in the plane, force in its own axes."""

    model: Literal["free-flyer"]
    mass_kg: Positive
    inertia_kg_m2: Positive = Field(description="about the centre of mass, the reference point")


Dynamics = Annotated[
    RigidBodyBlock | PointMassBlock | FreeFlyerBlock | BicycleBlock | UserModelBlock,
    Field(discriminator="model"),
]

Bound = Annotated[list[Number | None], Field(min_length=2, max_length=3)]
Range = Annotated[list[Number | None], Field(min_length=2, max_length=2)]


class PositionLimits(Block):
    """A box for the reference point; null where it has no side."""

    lower: Bound | None = None
    upper: Bound | None = None


class LimitsBlock(Block):
    """Bounds, one number for all axes or one an axis; absent where there is none."""

    max_force_n: PerAxis | None = None
    max_torque_nm: PerAxis | None = None
    max_speed_m_s: PerAxis | None = Field(default=None, description="inertial components")
    max_rate_rad_s: PerAxis | None = Field(default=None, description="body components")
    position_m: PositionLimits | None = None
    states: dict[str, Range] = Field(
        default={}, description="[lower, upper] of native components by name, null for none"
    )
    controls: dict[str, Range] = Field(default={}, description="likewise")


class AxisBlock(Block):
    """A body axis points along an axis of the end's frame; the roll is free."""

    body_axis: Vector3
    points_along: Vector3
    tolerance_rad: NonNegative = 0.0


AttitudeBlock = Annotated[
    Annotated[Quaternion, Tag("list")]
    | Annotated[Literal["free"], Tag("word")]
    | Annotated[AxisBlock, Tag("block")],
    Discriminator(shape_of),
]

VectorOrFree = Annotated[
    Annotated[Vector, Tag("list")] | Annotated[Literal["free"], Tag("word")],
    Discriminator(shape_of),
]

Vector3OrFree = Annotated[
    Annotated[Vector3, Tag("list")] | Annotated[Literal["free"], Tag("word")],
    Discriminator(shape_of),
]


class EndBlock(Block):
    """A start or goal: at rest, unturned, exact, in the inertial frame unless it says otherwise."""

    position_m: Vector
    position_tolerance_m: NonNegative = 0.0
    attitude: AttitudeBlock | None = None
    angle_rad: Number | None = Field(default=None, description="attitude in the plane")
    attitude_tolerance_rad: NonNegative = 0.0
    velocity_m_s: VectorOrFree | None = None
    rate_rad_s: Vector3OrFree | None = None
    frame: str | None = Field(default=None, description="name of a structure")
    states: dict[str, Number] = Field(
        default={}, description="native components that are given besides, by name"
    )

    @model_validator(mode="after")
    def _tolerance_has_centre(self) -> EndBlock:
        fixed = self.attitude is None or isinstance(self.attitude, list)
        if self.attitude_tolerance_rad > 0.0 and not fixed:
            raise PydanticCustomError(
                "rule", "has attitude_tolerance_rad, but its attitude is not a quaternion"
            )
        return self


class VehicleBlock(Bodied):
    """What is to be moved."""

    name: Name
    dynamics: Dynamics
    limits: LimitsBlock = LimitsBlock()
    start: EndBlock | None = Field(
        default=None, description="in later phases: the goal of the phase before, if absent"
    )
    goal: EndBlock
    path_constraints: list[PathConstraintBlock] = Field(default=[])


def _has_rows(value: object) -> bool:
    return isinstance(value, list | tuple) and any(isinstance(v, list | tuple) for v in value)
