"""What the certificate knows of a moving frame: exact jets at times, ceilings on intervals.

Everything here is in three dimensions; a planar frame lies at z = 0 and turns about z.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Protocol

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array, skew

Index = npt.NDArray[np.intp]
Mask = npt.NDArray[np.bool_]


@dataclass(frozen=True)
class Jet:
    """A frame at times (k,), in inertial axes.

    Attributes:
        position, velocity, acceleration: of its origin (k, 3).
        rotation: own → inertial (k, 3, 3).
        rate, rate_dot: ω and its derivative (k, 3), of the normalised attitude.
    """

    position: Array
    velocity: Array
    acceleration: Array
    rotation: Array
    rate: Array
    rate_dot: Array


@dataclass(frozen=True)
class Ceilings:
    """Upper bounds on norms over whole cells (n,), inertial axes.

    Attributes:
        acceleration, jerk: second and third derivative of the origin's position.
        rate, rate_dot, rate_ddot: ω and its first two derivatives.
        length: the lengths whose rounding enters a position (m).
    """

    acceleration: Array
    jerk: Array
    rate: Array
    rate_dot: Array
    rate_ddot: Array
    length: Array

    def at(self, cells: Index) -> Ceilings:
        """Those of the cells (k,)."""
        return Ceilings(*(getattr(self, f.name)[cells] for f in fields(self)))


class BodyMotion(Protocol):
    """A frame whose motion is smooth within each of its cells.

    Attributes:
        edges_s: ends of the cells (n + 1,), increasing.
        ceilings: (n,).
        turns: False where the attitude is constant.
        rests: True where nothing moves at all.
    """

    @property
    def edges_s(self) -> Array: ...
    @property
    def ceilings(self) -> Ceilings: ...
    @property
    def turns(self) -> bool: ...
    @property
    def rests(self) -> bool: ...

    def jet(self, t: Array, cells: Index) -> Jet:
        """At the times t (k,), each taken to lie in its cell, ends included."""
        ...


@dataclass(frozen=True)
class SteadyMotion:
    """Constant velocity and constant rate: r = r₀ + v t, R = exp(t ω^×) R₀.

    Attributes:
        span_s: the interval of time that matters.
        position_m, velocity_m_s: at t = 0 (3,).
        rotation: R₀ (3, 3).
        rate_rad_s: ω, inertial axes (3,).
    """

    span_s: tuple[float, float]
    position_m: Array
    velocity_m_s: Array
    rotation: Array
    rate_rad_s: Array

    @property
    def edges_s(self) -> Array:
        return np.array(self.span_s)

    @property
    def turns(self) -> bool:
        return bool(np.any(self.rate_rad_s))

    @property
    def rests(self) -> bool:
        return not self.turns and not np.any(self.velocity_m_s)

    @property
    def ceilings(self) -> Ceilings:
        zero = np.zeros(1)
        last = max(map(abs, self.span_s))
        rate = float(np.linalg.norm(self.rate_rad_s))
        reach = np.linalg.norm(self.position_m) + last * np.linalg.norm(self.velocity_m_s)
        return Ceilings(zero, zero, zero + rate, zero, zero, zero + reach * (1.0 + rate * last))

    def jet(self, t: Array, cells: Index) -> Jet:
        still = np.zeros((len(t), 3))
        return Jet(
            self.position_m + t[:, None] * self.velocity_m_s,
            still + self.velocity_m_s,
            still,
            self._rotation(t),
            still + self.rate_rad_s,
            still,
        )

    def _rotation(self, t: Array) -> Array:
        if not self.turns:
            return np.broadcast_to(self.rotation, (len(t), 3, 3))
        rate = float(np.linalg.norm(self.rate_rad_s))
        k = skew(self.rate_rad_s / rate)
        angle = rate * t[:, None, None]
        # Rodrigues' formula.
        turn = np.eye(3) + np.sin(angle) * k + (1.0 - np.cos(angle)) * (k @ k)
        return np.asarray(turn @ self.rotation)
