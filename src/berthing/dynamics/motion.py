"""Motion laws of structures as casadi expressions of time.

The pose at t = 0 is a parameter (position, rotation), so that one programme serves a structure
wherever it stands; a table carries its poses itself and ignores the parameter.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from berthing.dynamics.rotation import rotation_matrix
from berthing.errors import CapabilityError
from berthing.geometry.arrays import skew
from berthing.geometry.pose import Pose
from berthing.scenario.motion import ConstantSpin, ConstantVelocity, Fixed, Motion
from berthing.scenario.tabulated import Tabulated
from berthing.sym import Sym


@dataclass(frozen=True)
class Frame:
    """A moving frame at one instant, inertial axes.

    Attributes:
        position, velocity: of the origin (d,).
        rotation: own → inertial (d, d).
        rate: angular rate (3,), inertial axes.
    """

    position: Sym
    rotation: Sym
    velocity: Sym
    rate: Sym


@dataclass(frozen=True)
class SymbolicMotion:
    """Casadi form of a law.

    Attributes:
        base: pose at t = 0, the parameter.
        frame: (law, base position, base rotation, t) → Frame.
    """

    base: Callable[[Any], Pose]
    frame: Callable[[Any, Sym, Sym, Sym], Frame]


def _fixed(motion: Fixed, r: Sym, R: Sym, t: Sym) -> Frame:
    return Frame(r, R, ca.DM.zeros(motion.dim), ca.DM.zeros(3))


def _constant_velocity(motion: ConstantVelocity, r: Sym, R: Sym, t: Sym) -> Frame:
    velocity = ca.DM(motion.velocity_m_s)
    return Frame(r + t * velocity, R, velocity, ca.DM.zeros(3))


def _spin(motion: ConstantSpin, r: Sym, R: Sym, t: Sym) -> Frame:
    d, k = motion.dim, skew(motion.axis_body)
    angle = motion.rate_rad_s * t
    spin = ca.DM.eye(3) + ca.sin(angle) * ca.DM(k) + (1 - ca.cos(angle)) * ca.DM(k @ k)
    velocity = ca.DM(motion.velocity_m_s)
    axis = ca.DM(motion.axis_body)
    rate = motion.rate_rad_s * (ca.mtimes(R, axis) if d == 3 else axis)
    return Frame(r + t * velocity, ca.mtimes(R, spin[:d, :d]), velocity, rate)


def _tabulated(motion: Tabulated, r: Sym, R: Sym, t: Sym) -> Frame:
    d, times = motion.dim, motion.times_s
    clamped = ca.fmin(ca.fmax(t, times[0]), times[-1])
    value, slope = _cubic(motion, 0, clamped)
    for i in range(1, len(times) - 1):
        later_value, later_slope = _cubic(motion, i, clamped)
        later = clamped >= times[i]
        value = ca.if_else(later, later_value, value)
        slope = ca.if_else(later, later_slope, slope)
    q, dq = value[d:], slope[d:]
    rate = 2.0 * (q[0] * dq[1:4] - dq[0] * q[1:4] + ca.cross(q[1:4], dq[1:4])) / ca.sumsqr(q)
    return Frame(value[:d], rotation_matrix(q)[:d, :d], slope[:d], rate)


def _cubic(motion: Tabulated, i: int, t: Sym) -> tuple[Sym, Sym]:
    a, b, c, d = (ca.DM(row) for row in motion.coefficients[:, i])
    s = t - float(motion.times_s[i])
    return ((a * s + b) * s + c) * s + d, (3 * a * s + 2 * b) * s + c


MOTIONS: dict[type[Motion], SymbolicMotion] = {
    Fixed: SymbolicMotion(lambda m: m.fixed_pose, _fixed),
    ConstantVelocity: SymbolicMotion(lambda m: m.pose0, _constant_velocity),
    ConstantSpin: SymbolicMotion(lambda m: m.pose0, _spin),
    Tabulated: SymbolicMotion(lambda m: m.pose(np.zeros(1))[0], _tabulated),
}


def symbolic_motion(motion: Motion) -> SymbolicMotion:
    """The casadi form of ``motion``; CapabilityError where none is registered."""
    try:
        return MOTIONS[type(motion)]
    except KeyError:
        known = ", ".join(sorted(t.__name__ for t in MOTIONS))
        raise CapabilityError(
            f"no symbolic form of the motion law {type(motion).__name__}; there are {known}"
        ) from None
