"""A known force and torque on a vehicle, e.g. by a manipulator that holds a module."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array, as_array


@dataclass(frozen=True, eq=False)
class Wrench:
    """Force and torque in the body frame: linear between the times given, constant outside.

    It is the paper's manipulator: f_s^m and g_s^m at ρ_s^m, known inputs of time.

    Attributes:
        name: unique in its vehicle.
        point_m: where the force acts, body frame (3,).
        times_s: strictly increasing (k,), on the scenario's clock.
        force_n: (k, 3).
        torque_nm: (k, 3), without the moment of the force.

    Raises:
        InputError: wrong shapes, numbers that are not finite, times that do not increase.
    """

    name: str
    point_m: Array
    times_s: Array
    force_n: Array
    torque_nm: Array

    def __post_init__(self) -> None:
        times = as_array(self.times_s, (None,), "times_s")
        if len(times) == 0 or np.any(np.diff(times) <= 0.0):
            raise InputError("times_s", "do not increase", "one or more increasing times")
        object.__setattr__(self, "times_s", times)
        object.__setattr__(self, "point_m", as_array(self.point_m, (3,), "point_m"))
        for name in ("force_n", "torque_nm"):
            object.__setattr__(self, name, as_array(getattr(self, name), (len(times), 3), name))

    @property
    def total_knots(self) -> tuple[Array, Array]:
        """Force (k, 3) and torque about the reference point (k, 3), g + ρ × f, at ``times_s``."""
        return self.force_n, self.torque_nm + np.cross(self.point_m, self.force_n)

    def total(self, t: Array) -> tuple[Array, Array]:
        """Force (k, 3) and torque about the body's reference point (k, 3) at the times t (k,)."""
        force, torque = self.total_knots
        return _interpolate(t, self.times_s, force), _interpolate(t, self.times_s, torque)


def _interpolate(t: Array, times: Array, values: Array) -> Array:
    t = np.atleast_1d(np.asarray(t, dtype=np.float64))
    return np.stack([np.interp(t, times, column) for column in values.T], axis=-1)
