"""A vehicle: a body with a dynamics model, limits, a start and a goal."""

from __future__ import annotations

from dataclasses import dataclass

from berthing.errors import InputError
from berthing.geometry.body import Body
from berthing.scenario.goal import End
from berthing.scenario.limits import Limits
from berthing.scenario.native_state import Model


@dataclass(frozen=True, eq=False)
class Vehicle:
    """What is to be moved, in one phase.

    Attributes:
        name: unique among vehicles and structures; the same in every phase.
        body: its shape, in the frame at its reference point.
        model: its dynamics, with the data.
        limits: on controls and states.
        start, goal: sets; the start is at the beginning of the phase.

    Raises:
        InputError: dimensions or lengths that do not fit together.
    """

    name: str
    body: Body
    model: Model
    limits: Limits
    start: End
    goal: End

    def __post_init__(self) -> None:
        found = {
            "body": self.body.dim,
            "model": self.model.dim,
            "start": self.start.dim,
            "goal": self.goal.dim,
        }
        if len(set(found.values())) > 1:
            parts = ", ".join(f"{key} {value}-D" for key, value in found.items())
            raise InputError(self.name, f"mixes dimensions: {parts}", "one dimension")
        nx, nu = len(self.model.state_names), len(self.model.control_names)
        if (len(self.limits.state_lower), len(self.limits.control_lower)) != (nx, nu):
            raise InputError(
                self.name, "has limits of another length", f"{nx} states, {nu} controls"
            )

    @property
    def dim(self) -> int:
        """2 or 3."""
        return self.body.dim
