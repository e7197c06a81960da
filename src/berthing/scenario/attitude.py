"""Sets of attitudes that a start or a goal may ask for."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array, as_array

# A unit quaternion or axis written with seven digits errs by less; more is a mistake of the user,
# not of rounding. Within it the value is normalised.
UNIT_ROUNDING = 1e-6


def unit(value: Array, length: int, where: str) -> Array:
    """``value`` normalised, read-only, once it is a unit vector to within ``UNIT_ROUNDING``.

    Raises:
        InputError: wrong length of the list, not finite, or not of unit norm.
    """
    vector = as_array(value, (length,), where)
    norm = float(np.linalg.norm(vector))
    if abs(norm - 1.0) > UNIT_ROUNDING:
        raise InputError(where, f"has the norm {norm:.9g}", "1")
    return as_array(vector / norm, (length,), where)


def direction(value: Array, length: int, where: str) -> Array:
    """``value`` scaled to unit length, read-only; any length but zero will do.

    Raises:
        InputError: wrong length of the list, not finite, or zero.
    """
    vector = as_array(value, (length,), where)
    norm = float(np.linalg.norm(vector))
    if norm == 0.0:
        raise InputError(where, "is a zero vector", "a direction")
    return as_array(vector / norm, (length,), where)


@dataclass(frozen=True, eq=False)
class FixedAttitude:
    """One attitude, up to an angle.

    Attributes:
        q: q_FB, body to the end's frame, scalar first (4,); q and −q are the same.
        tolerance_rad: the angle from it that is allowed.
    """

    q: Array
    tolerance_rad: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "q", unit(self.q, 4, "attitude"))
        _check_tolerance(self.tolerance_rad)

    def in_frame(self, q_IF: Array) -> FixedAttitude:
        """The same set seen from the inertial frame, the end's frame being turned by ``q_IF``."""
        return FixedAttitude(quaternion.multiply(q_IF, self.q), self.tolerance_rad)

    def nominal(self) -> Array:
        """A member of the set at its centre, scalar first (4,)."""
        return self.q

    def error_rad(self, q: Array) -> Array:
        """Angle (...) from the attitudes q (..., 4) to the centre of the set."""
        return np.asarray(quaternion.angle_between(self.q, q), dtype=np.float64)


@dataclass(frozen=True)
class FreeAttitude:
    """Any attitude."""

    def in_frame(self, q_IF: Array) -> FreeAttitude:
        """Any attitude, seen from anywhere."""
        return self

    def nominal(self) -> Array:
        """The identity, scalar first (4,)."""
        return np.array([1.0, 0.0, 0.0, 0.0])

    def error_rad(self, q: Array) -> Array:
        """Zeros (...) for the attitudes q (..., 4)."""
        return np.zeros(np.shape(q)[:-1])


@dataclass(frozen=True, eq=False)
class AxisAttitude:
    """A body axis points along an axis of the end's frame; the roll about it is free.

    Attributes:
        body_axis, world_axis: of any length but zero; kept as unit vectors (3,).
        tolerance_rad: the angle between the two that is allowed.
    """

    body_axis: Array
    world_axis: Array
    tolerance_rad: float = 0.0

    def __post_init__(self) -> None:
        for name in ("body_axis", "world_axis"):
            object.__setattr__(self, name, direction(getattr(self, name), 3, name))
        _check_tolerance(self.tolerance_rad)

    def in_frame(self, q_IF: Array) -> AxisAttitude:
        """The same set seen from the inertial frame, the end's frame being turned by ``q_IF``."""
        axis = quaternion.rotation_matrix(q_IF) @ self.world_axis
        return AxisAttitude(self.body_axis, axis, self.tolerance_rad)

    def nominal(self) -> Array:
        """The member least turned from the identity, scalar first (4,)."""
        b, w = self.body_axis, self.world_axis
        normal = np.cross(b, w)
        sine = float(np.linalg.norm(normal))
        if sine < UNIT_ROUNDING and b @ w < 0.0:
            # Opposite: any axis across b will do; take it across b's smallest component.
            normal = np.cross(b, np.eye(3)[np.argmin(np.abs(b))])
        elif sine == 0.0:
            return np.array([1.0, 0.0, 0.0, 0.0])
        axis = normal / np.linalg.norm(normal)
        angle = math.atan2(sine, float(b @ w))
        return np.asarray(quaternion.from_axis_angle(axis, np.float64(angle)), dtype=np.float64)

    def error_rad(self, q: Array) -> Array:
        """Angle (...) between the two axes at the attitudes q (..., 4)."""
        axis = quaternion.rotation_matrix(q) @ self.body_axis
        sine = np.linalg.norm(np.cross(axis, self.world_axis), axis=-1)
        return np.asarray(np.arctan2(sine, axis @ self.world_axis), dtype=np.float64)


Attitude = FixedAttitude | FreeAttitude | AxisAttitude


def _check_tolerance(value: float) -> None:
    if not 0.0 <= value <= math.pi:
        raise InputError("tolerance_rad", f"is {value}", "an angle from 0 to π")
