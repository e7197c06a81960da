"""A vehicle: a body with a dynamics model, limits, a start and a goal."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import chain

import numpy as np

from berthing.errors import InputError
from berthing.geometry.body import Body
from berthing.scenario.attitude import Attitude, AxisAttitude, FixedAttitude
from berthing.scenario.goal import End
from berthing.scenario.limits import Limits
from berthing.scenario.native_state import Model
from berthing.scenario.path_constraint import PathConstraint


@dataclass(frozen=True, eq=False)
class Vehicle:
    """What is to be moved, in one phase.

    Attributes:
        name: unique among vehicles and structures; the same in every phase.
        body: its shape, in the frame at its reference point.
        model: its dynamics, with the data.
        limits: on controls and states.
        start, goal: sets; the start is at the beginning of the phase.
        path_constraints: g(x, u, t) ≤ 0 of the user's own, at every instant.

    Raises:
        InputError: dimensions or lengths that do not fit together, a part without bounds, or an
            end that asks for what the model does not have.
    """

    name: str
    body: Body
    model: Model
    limits: Limits
    start: End
    goal: End
    path_constraints: tuple[PathConstraint, ...] = ()

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
        for part in self.body.parts:
            if not np.isfinite(part.bounding_radius):
                what = f"has a part {part.name!r} without bounds: {type(part.shape).__name__}"
                raise InputError(self.name, what, "bounded sets")
        nx, nu = len(self.model.state_names), len(self.model.control_names)
        if (len(self.limits.state_lower), len(self.limits.control_lower)) != (nx, nu):
            raise InputError(
                self.name, "has limits of another length", f"{nx} states, {nu} controls"
            )
        object.__setattr__(self, "path_constraints", tuple(self.path_constraints))
        for kind, end in (("start", self.start), ("goal", self.goal)):
            self._check_end(f"{self.name}.{kind}", end)

    def _check_end(self, where: str, end: End) -> None:
        names = self.model.state_names
        unknown = [name for name in end.states if name not in names]
        if unknown:
            raise InputError(
                f"{where}.states", f"has {unknown[0]!r}", f"one of: {', '.join(names)}"
            )
        asked = chain(
            ["velocity_m_s"] * (end.velocity_m_s is not None),
            ["rate_rad_s"] * (end.rate_rad_s is not None and self.model.turns),
        )
        if not self.model.tells_rates:
            for key in asked:
                raise InputError(
                    f"{where}.{key}", "is asked of a model that does not tell its rates", "free"
                )
        if self.dim == 2 and self.model.turns and _leaves_the_plane(end.attitude):
            raise InputError(f"{where}.attitude", "leaves the plane", "a turn about z, or free")

    @property
    def dim(self) -> int:
        """2 or 3."""
        return self.body.dim


def _leaves_the_plane(attitude: Attitude) -> bool:
    if isinstance(attitude, FixedAttitude):
        return bool(np.any(attitude.q[1:3]))
    return isinstance(attitude, AxisAttitude)
