"""A start or a goal: a set of states, in the inertial frame or in a structure's."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array, as_array
from berthing.geometry.pose import Pose
from berthing.scenario.attitude import Attitude, FixedAttitude
from berthing.scenario.structure import Structure


class Structures(Protocol):
    """Whatever finds a structure by its name; a scenario does."""

    def structure(self, name: str) -> Structure:
        """The structure called ``name``."""
        ...


def _identity() -> FixedAttitude:
    return FixedAttitude(np.array([1.0, 0.0, 0.0, 0.0]))


@dataclass(frozen=True, eq=False)
class End:
    """Where a vehicle begins or ends, in the frame F named.

    Attributes:
        position_m: of the body's reference point, axes of F (dim,).
        position_tolerance_m: radius of the ball of positions allowed.
        attitude: set of attitudes, body to F.
        velocity_m_s: relative to F, axes of F (dim,); None where it is free.
        rate_rad_s: of the body relative to F, body axes (3,); None where it is free.
        frame: None for the inertial frame, else the name of a structure.
        states: native components that are given besides, by name: a mass, a steering angle.

    Raises:
        InputError: wrong shapes, numbers that are not finite, a negative tolerance.
    """

    position_m: Array
    position_tolerance_m: float = 0.0
    attitude: Attitude = field(default_factory=_identity)
    velocity_m_s: Array | None = None
    rate_rad_s: Array | None = None
    frame: str | None = None
    states: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        position = as_array(self.position_m, (None,), "position_m")
        if len(position) not in (2, 3):
            raise InputError("position_m", f"has {len(position)} components", "2 or 3")
        object.__setattr__(self, "position_m", position)
        shapes = {"velocity_m_s": len(position), "rate_rad_s": 3}
        for name, length in shapes.items():
            if getattr(self, name) is not None:
                object.__setattr__(self, name, as_array(getattr(self, name), (length,), name))
        tolerance = self.position_tolerance_m
        if not 0.0 <= tolerance < math.inf:
            raise InputError("position_tolerance_m", f"is {tolerance}", "0 or more, finite")
        for name, value in self.states.items():
            as_array(value, (), f"states.{name}")

    @property
    def dim(self) -> int:
        """2 or 3."""
        return len(self.position_m)

    def resolve(self, t: float, structures: Structures) -> InertialEnd:
        """The same set in the inertial frame at the time t (s), F moving as it does.

        With F's origin at r_F, moving with v_F, and F turning with ω_F:
        r = r_F + R_IF p, and v = v_F + ω_F × (R_IF p) + R_IF v_rel.

        Raises:
            InputError: the structure does not exist.
        """
        if self.frame is None:
            return InertialEnd(
                self.position_m, self.position_tolerance_m, self.attitude,
                self.velocity_m_s, self.rate_rad_s, np.zeros(3),
            )  # fmt: skip
        motion = structures.structure(self.frame).motion
        when = np.array([t])
        frame = motion.pose(when)[0]
        origin_velocity, rate = (value[0] for value in motion.velocity(when))
        arm = frame.rotation @ self.position_m
        velocity = None
        if self.velocity_m_s is not None:
            swept = np.cross(rate, _lift(arm))[: self.dim]
            velocity = origin_velocity + swept + frame.rotation @ self.velocity_m_s
        q_IF = quaternion.from_matrix(_lift_rotation(frame.rotation))
        return InertialEnd(
            frame.position + arm, self.position_tolerance_m, self.attitude.in_frame(q_IF),
            velocity, self.rate_rad_s, rate,
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class InertialEnd:
    """An end at one instant, in the inertial frame.

    Attributes:
        position_m: (dim,).
        position_tolerance_m: radius of the ball allowed.
        attitude: set of attitudes q_IB.
        velocity_m_s: inertial (dim,); None where free.
        relative_rate_rad_s: of the body relative to the end's frame, body axes (3,); None: free.
        frame_rate_rad_s: of the end's frame, inertial axes (3,).
    """

    position_m: Array
    position_tolerance_m: float
    attitude: Attitude
    velocity_m_s: Array | None
    relative_rate_rad_s: Array | None
    frame_rate_rad_s: Array

    @property
    def pose(self) -> Pose:
        """The centre of the set; the nominal attitude where that is not fixed."""
        if len(self.position_m) == 2:
            w, _, _, z = self.attitude.nominal()
            return Pose.planar(self.position_m, 2.0 * np.arctan2(z, w))
        return Pose.from_quaternion(self.position_m, self.attitude.nominal())

    def rate_rad_s(self, q_IB: Array) -> Array | None:
        """Inertial rate in body axes (3,) that a body at the attitude q_IB must have.

        ω_B = ω_rel + R(q_IB)ᵀ ω_F; None where the rate is free.
        """
        if self.relative_rate_rad_s is None:
            return None
        turned: Array = quaternion.rotation_matrix(q_IB).T @ self.frame_rate_rad_s
        return self.relative_rate_rad_s + turned


def _lift(v: Array) -> Array:
    return v if len(v) == 3 else np.append(v, 0.0)


def _lift_rotation(rotation: Array) -> Array:
    lifted = np.eye(3)
    d = len(rotation)
    lifted[:d, :d] = rotation
    return lifted
