"""Field types that the file's blocks share, and the base of those blocks."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar

from pydantic import BaseModel, ConfigDict, Discriminator, Field, Tag, model_validator
from pydantic_core import PydanticCustomError

from berthing.scenario.suggest import did_you_mean

# Strict: neither "3" nor true is a number. Whole numbers are read as floats.
Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Positive = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0)]
NonNegative = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0)]
Whole = Annotated[int, Field(strict=True)]

# Names are joined by "." in selectors and by "|" in pairs, and a scenario's names a folder.
NAME_PATTERN = r"^[A-Za-z0-9][A-Za-z0-9_-]*$"
Name = Annotated[str, Field(pattern=NAME_PATTERN, max_length=100)]

Vector = Annotated[list[Number], Field(min_length=2, max_length=3)]
Vector3 = Annotated[list[Number], Field(min_length=3, max_length=3)]
Quaternion = Annotated[list[Number], Field(min_length=4, max_length=4)]
Sizes = Annotated[list[Positive], Field(min_length=2, max_length=3)]


# What YAML calls the kind of a value, by its Python type; the rest are numbers.
_KINDS: dict[type, str] = {list: "list", tuple: "list", dict: "block", str: "word"}


def shape_of(value: Any) -> str:
    """The tag of a union that is told apart by the kind of value: list, block, word or number."""
    return "block" if isinstance(value, BaseModel) else _KINDS.get(type(value), "number")


PerAxis = Annotated[
    Annotated[NonNegative, Tag("number")]
    | Annotated[list[NonNegative], Field(min_length=2, max_length=3), Tag("list")],
    Discriminator(shape_of),
]


class Block(BaseModel):
    """A mapping of the file whose keys are all known; an unknown one is refused by name."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    # Keys that other forms of the same block have, to suggest from.
    further_keys: ClassVar[tuple[str, ...]] = ()

    @model_validator(mode="before")
    @classmethod
    def _known_keys(cls, data: Any) -> Any:
        if not isinstance(data, dict):
            return data
        known = [*cls.model_fields, *cls.further_keys]
        for key in data:
            if key not in known:
                raise PydanticCustomError(
                    "unknown_key",
                    "is not a known key{hint}",
                    {"key": str(key), "hint": did_you_mean(str(key), known), "known": known},
                )
        return data
