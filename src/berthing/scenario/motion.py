"""How structures move: laws pose(t) with bounds on their speed."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array, as_array, skew
from berthing.geometry.pose import Pose
from berthing.scenario.attitude import direction

# Continuity class of laws whose every derivative exists; more than any scheme asks for.
ANALYTIC = 1000


class Motion(ABC):
    """Pose of a structure's frame in the inertial frame over time, on the scenario's clock."""

    kind: ClassVar[str]

    @property
    @abstractmethod
    def dim(self) -> int:
        """2 or 3."""

    @property
    @abstractmethod
    def continuity(self) -> int:
        """How often pose(t) can be differentiated continuously."""

    @property
    def span_s(self) -> tuple[float, float]:
        """The times for which the law is known."""
        return (-math.inf, math.inf)

    @abstractmethod
    def pose(self, t: Array) -> Pose:
        """Poses, batched, at the times t (k,)."""

    @abstractmethod
    def velocity(self, t: Array) -> tuple[Array, Array]:
        """Velocity of the origin (k, dim) and angular rate (k, 3), inertial axes, at t (k,)."""

    @abstractmethod
    def speed_bound(self, t0: float, t1: float) -> tuple[float, float]:
        """Upper bounds on the origin's speed (m/s) and on the rate (rad/s) over all of [t0, t1]."""


@dataclass(frozen=True, eq=False)
class Fixed(Motion):
    """At rest."""

    fixed_pose: Pose

    kind: ClassVar[str] = "fixed"

    @property
    def dim(self) -> int:
        return self.fixed_pose.dim

    @property
    def continuity(self) -> int:
        return ANALYTIC

    def pose(self, t: Array) -> Pose:
        return _drifting(self.fixed_pose, np.zeros(self.dim), np.asarray(t))

    def velocity(self, t: Array) -> tuple[Array, Array]:
        return np.zeros((len(t), self.dim)), np.zeros((len(t), 3))

    def speed_bound(self, t0: float, t1: float) -> tuple[float, float]:
        return 0.0, 0.0


@dataclass(frozen=True, eq=False)
class ConstantVelocity(Motion):
    """Straight on, without turning.

    Attributes:
        pose0: at t = 0.
        velocity_m_s: inertial (dim,).
    """

    pose0: Pose
    velocity_m_s: Array

    kind: ClassVar[str] = "constant-velocity"

    def __post_init__(self) -> None:
        velocity = as_array(self.velocity_m_s, (self.pose0.dim,), "velocity_m_s")
        object.__setattr__(self, "velocity_m_s", velocity)

    @property
    def dim(self) -> int:
        return self.pose0.dim

    @property
    def continuity(self) -> int:
        return ANALYTIC

    def pose(self, t: Array) -> Pose:
        return _drifting(self.pose0, self.velocity_m_s, np.asarray(t))

    def velocity(self, t: Array) -> tuple[Array, Array]:
        return np.tile(self.velocity_m_s, (len(t), 1)), np.zeros((len(t), 3))

    def speed_bound(self, t0: float, t1: float) -> tuple[float, float]:
        return float(np.linalg.norm(self.velocity_m_s)), 0.0


@dataclass(frozen=True, eq=False)
class ConstantSpin(Motion):
    """Turning at a constant rate about an axis of its own through its origin, which drifts.

    R(t) = R₀ exp(t ω axis_body^×): the axis stays where it is in body and inertial axes alike.

    Attributes:
        pose0: at t = 0.
        axis_body: of any length but zero, kept as a unit vector (3,); in the plane it is ±z.
        rate_rad_s: about it.
        velocity_m_s: of the origin, inertial (dim,).
    """

    pose0: Pose
    axis_body: Array
    rate_rad_s: float
    velocity_m_s: Array

    kind: ClassVar[str] = "spin"

    def __post_init__(self) -> None:
        object.__setattr__(self, "axis_body", direction(self.axis_body, 3, "axis_body"))
        if self.dim == 2 and abs(self.axis_body[2]) != 1.0:
            raise InputError("axis_body", "leaves the plane", "[0, 0, 1] or [0, 0, -1]")
        as_array(self.rate_rad_s, (), "rate_rad_s")
        velocity = as_array(self.velocity_m_s, (self.dim,), "velocity_m_s")
        object.__setattr__(self, "velocity_m_s", velocity)

    @property
    def dim(self) -> int:
        return self.pose0.dim

    @property
    def continuity(self) -> int:
        return ANALYTIC

    @property
    def rate_inertial_rad_s(self) -> Array:
        """The angular rate in inertial axes (3,)."""
        turned = self.pose0.rotation @ self.axis_body if self.dim == 3 else self.axis_body
        return np.asarray(self.rate_rad_s * turned, dtype=np.float64)

    def pose(self, t: Array) -> Pose:
        t = np.asarray(t, dtype=np.float64)
        angle = self.rate_rad_s * t[:, None, None]
        # Rodrigues' formula; in the plane its leading 2×2 block is the planar rotation.
        k = skew(self.axis_body)
        spin = np.eye(3) + np.sin(angle) * k + (1.0 - np.cos(angle)) * (k @ k)
        position = self.pose0.position + t[:, None] * self.velocity_m_s
        return Pose(position, self.pose0.rotation @ spin[:, : self.dim, : self.dim])

    def velocity(self, t: Array) -> tuple[Array, Array]:
        shape = (len(t), 1)
        return np.tile(self.velocity_m_s, shape), np.tile(self.rate_inertial_rad_s, shape)

    def speed_bound(self, t0: float, t1: float) -> tuple[float, float]:
        return float(np.linalg.norm(self.velocity_m_s)), abs(self.rate_rad_s)


def _drifting(pose: Pose, velocity: Array, t: Array) -> Pose:
    position = pose.position + t[:, None] * velocity
    return Pose(position, np.broadcast_to(pose.rotation, (len(t), *pose.rotation.shape)))
