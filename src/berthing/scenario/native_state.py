"""The data of a dynamics model, and the map from its native state to a pose."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar

from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose


class Model(ABC):
    """Data of a dynamics model; its equations are written elsewhere, twice: to solve and to check.

    Attributes:
        kind: the name of the model in files and plans, e.g. ``rigid-body``.
    """

    kind: ClassVar[str]

    @property
    def noun(self) -> str:
        """The model in a sentence."""
        return f"a {self.kind.replace('-', ' ')}"

    @property
    @abstractmethod
    def dim(self) -> int:
        """Dimension of the workspace: 2 or 3."""

    @property
    @abstractmethod
    def state_names(self) -> tuple[str, ...]:
        """The columns of the native state (nx), units in the names."""

    @property
    @abstractmethod
    def control_names(self) -> tuple[str, ...]:
        """The columns of the native control (nu), units in the names."""

    @property
    def turns(self) -> bool:
        """Whether the attitude is part of the state; of other models it is always the identity."""
        return "qw" in self.state_names

    @property
    def tells_rates(self) -> bool:
        """Whether the state alone tells velocity and rate."""
        return True

    @abstractmethod
    def pose(self, x: Array) -> Pose:
        """Poses of the body's reference frame in the inertial one; x (..., nx)."""

    @abstractmethod
    def velocity(self, x: Array) -> tuple[Array, Array]:
        """Inertial velocity of the reference point (..., dim) and angular rate (..., 3).

        The rate is in inertial axes, rad/s. NaN where the model does not tell.
        """

    @abstractmethod
    def assemble(self, r_m: Array, q_IB: Array, v_m_s: Array, w_body_rad_s: Array) -> Array:
        """Native states (..., nx) of the given motion.

        Args:
            r_m: inertial positions (..., dim).
            q_IB: attitudes (..., 4); a model without attitude ignores them.
            v_m_s: inertial velocities (..., dim).
            w_body_rad_s: rates in the body frame (..., 3); ignored likewise.
        """
