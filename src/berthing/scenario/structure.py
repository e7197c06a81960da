"""A structure: a body that moves by a law of its own."""

from __future__ import annotations

from dataclasses import dataclass

from berthing.errors import InputError
from berthing.geometry.body import Body
from berthing.scenario.motion import Motion


@dataclass(frozen=True, eq=False)
class Structure:
    """What vehicles must keep clear of, or berth to.

    Attributes:
        name: unique among vehicles and structures.
        body: its shape, in its own frame.
        motion: pose of that frame in the inertial one over time.

    Raises:
        InputError: body and motion differ in dimension.
    """

    name: str
    body: Body
    motion: Motion

    def __post_init__(self) -> None:
        if self.body.dim != self.motion.dim:
            found = f"has a {self.body.dim}-D body and a {self.motion.dim}-D motion"
            raise InputError(self.name, found, "one dimension")

    @property
    def dim(self) -> int:
        """2 or 3."""
        return self.body.dim
