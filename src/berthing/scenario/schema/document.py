"""The scenario file as a whole."""

from __future__ import annotations

import json
from typing import Annotated, Literal

from pydantic import Field, JsonValue, model_validator
from pydantic_core import PydanticCustomError

from berthing.scenario.schema.fields import Block, Name, NonNegative, Number, Positive, Whole
from berthing.scenario.schema.shapes import ShapeModelBlock
from berthing.scenario.schema.structures import StructureBlock
from berthing.scenario.schema.user import RunningCostBlock
from berthing.scenario.schema.vehicles import VehicleBlock


class HorizonBlock(Block):
    """A duration, or bounds on a free one."""

    duration_s: Positive | None = None
    min_s: Positive | None = None
    max_s: Positive | None = None

    @model_validator(mode="after")
    def _one_form(self) -> HorizonBlock:
        fixed = self.duration_s is not None
        given = (self.min_s is not None, self.max_s is not None)
        if given != (not fixed, not fixed):
            raise PydanticCustomError("rule", "needs duration_s, or min_s with max_s")
        return self


class CostBlock(Block):
    """Weights of ∫ (control_energy ‖u‖² + time + Σ h) dt, h the user's own."""

    control_energy: NonNegative = 1.0
    time: NonNegative = 0.0
    running: list[RunningCostBlock] = Field(default=[])


class OverrideBlock(Block):
    """An exception to the default margin."""

    between: Annotated[list[str], Field(min_length=2, max_length=2)] = Field(
        description="two selectors, each owner or owner.part"
    )
    margin_m: NonNegative | None = None
    contact: Literal["allowed"] | None = None
    window_s: Annotated[list[Number], Field(min_length=2, max_length=2)] | None = None

    @model_validator(mode="after")
    def _one_of_two(self) -> OverrideBlock:
        if (self.margin_m is None) == (self.contact is None):
            raise PydanticCustomError("rule", "needs one of margin_m and contact: allowed")
        return self


class MarginsBlock(Block):
    """How far apart things stay; where several overrides apply, the last wins."""

    default_m: NonNegative
    overrides: list[OverrideBlock] = Field(default=[])


class SolverBlock(Block):
    """The command line's options; it wins. And how parts are modelled that do not say."""

    formulation: Name = "plane"
    scheme: Name = "lgr"
    nodes: Annotated[Whole, Field(ge=2)] | None = None
    time_limit_s: Positive | None = None
    seed: Annotated[Whole, Field(ge=0)] = 0
    guess: Name = "default"
    tolerance: Positive | None = None
    controls: Literal["polynomial", "piecewise-linear", "piecewise-constant"] = "polynomial"
    sample_time_s: Positive = 1.0
    shape_model: ShapeModelBlock | None = None
    effort: Literal["fast", "normal", "thorough"] = "normal"


class PhaseContent(Block):
    """What a phase has beside its name."""

    horizon: HorizonBlock
    cost: CostBlock = CostBlock()
    vehicles: Annotated[list[VehicleBlock], Field(min_length=1)]


class PhaseBlock(PhaseContent):
    """A stretch of time with its vehicles."""

    name: Name


class Common(Block):
    """What holds for all phases."""

    schema_version: Literal[1]
    name: Name
    description: str = ""
    structures: list[StructureBlock] = Field(default=[])
    margins: MarginsBlock
    solver: SolverBlock = SolverBlock()
    meta: dict[str, JsonValue] = Field(
        default={}, description="what exports need: epoch, centre, frame, object ids"
    )

    @model_validator(mode="after")
    def _meta_is_json(self) -> Common:
        # Checked as text: pydantic lets infinities and NaN pass inside free-form values.
        try:
            json.dumps(self.meta, allow_nan=False)
        except ValueError:
            raise PydanticCustomError("rule", "has NaN or an infinite number in meta") from None
        return self


class SinglePhaseFile(PhaseContent, Common):
    """Shorthand for one phase, called main."""


SHORTHAND_KEYS = tuple(PhaseContent.model_fields)


class ScenarioFile(Common):
    """The normal form."""

    further_keys = SHORTHAND_KEYS

    phases: Annotated[list[PhaseBlock], Field(min_length=1)]
