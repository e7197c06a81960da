"""A point mass: position and velocity, attitude always the identity."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.native_state import Model


@dataclass(frozen=True)
class PointMass(Model):
    """A double integrator in two or three dimensions; its body does not turn.

    The native state is r_I, v_I; the control is the force in inertial axes.

    Raises:
        InputError: mass not positive, or a dimension other than 2 or 3.
    """

    mass_kg: float
    workspace_dim: int = 3

    kind: ClassVar[str] = "point-mass"

    def __post_init__(self) -> None:
        if not (np.isfinite(self.mass_kg) and self.mass_kg > 0.0):
            raise InputError("mass_kg", f"is {self.mass_kg}", "a positive number")
        if self.workspace_dim not in (2, 3):
            raise InputError("workspace_dim", f"is {self.workspace_dim}", "2 or 3")

    @property
    def dim(self) -> int:
        return self.workspace_dim

    @property
    def state_names(self) -> tuple[str, ...]:
        axes = "xyz"[: self.dim]
        return (*(f"{a}_m" for a in axes), *(f"v{a}_m_s" for a in axes))

    @property
    def control_names(self) -> tuple[str, ...]:
        return tuple(f"f{a}_n" for a in "xyz"[: self.dim])

    def pose(self, x: Array) -> Pose:
        d = self.dim
        return Pose(x[..., :d], np.broadcast_to(np.eye(d), (*x.shape[:-1], d, d)))

    def velocity(self, x: Array) -> tuple[Array, Array]:
        return x[..., self.dim :], np.zeros((*x.shape[:-1], 3))

    def assemble(self, r_m: Array, q_IB: Array, v_m_s: Array, w_body_rad_s: Array) -> Array:
        return np.concatenate([r_m, v_m_s], axis=-1)
