"""Code of the user's own in files: where it is, what of it is meant, and its parameters."""

from __future__ import annotations

import math
from typing import Any, Literal

from pydantic import Field, JsonValue, field_validator
from pydantic_core import PydanticCustomError

from berthing.scenario.schema.fields import Block, Name, Positive


class UserBlock(Block):
    """Something in a Python file beside the scenario's."""

    file: str = Field(description="path of a Python file, relative to the scenario's")
    name: str = Field(description="what in it is meant")
    parameters: dict[str, JsonValue] = Field(default={}, description="p of the functions")
    code: str | None = Field(
        default=None, description="the text of the file, filled in where a plan is written"
    )

    @field_validator("parameters")
    @classmethod
    def _are_values(cls, parameters: dict[str, Any]) -> dict[str, Any]:
        # pydantic lets infinities pass inside free-form values, and files do not keep nulls.
        if not _are_plain(parameters):
            raise PydanticCustomError("rule", "has null, NaN or an infinite number in it")
        return parameters


class UserModelBlock(UserBlock):
    """Dynamics of the user's own: a berthing UserModel."""

    model: Literal["user"]


class PathConstraintBlock(UserBlock):
    """g(t, x, u, p, xp) ≤ 0, a function."""

    label: Name | None = Field(default=None, description="in messages; the function's name if none")
    tolerance: Positive = Field(default=1e-4, description="a row above zero by no more is no fault")
    scale: Positive = Field(default=1.0, description="the usual size of the rows")


class RunningCostBlock(UserBlock):
    """h(t, x, u, p, xp), a function: what a vehicle adds to the integrand of the cost."""

    vehicle: Name
    scale: Positive = Field(default=1.0, description="the usual size of h")


def _are_plain(value: Any) -> bool:
    if isinstance(value, dict):
        return all(map(_are_plain, value.values()))
    if isinstance(value, list):
        return all(map(_are_plain, value))
    return value is not None and (not isinstance(value, float) or math.isfinite(value))
