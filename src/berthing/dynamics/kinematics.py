"""What a native state says about pose and rates, alike for every model downstream."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from berthing.sym import Sym


@dataclass(frozen=True)
class Kinematics:
    """Casadi expressions of one state.

    Attributes:
        position: of the reference point, inertial (d,).
        rotation: body → inertial (d, d).
        velocity: of the reference point, inertial (d,).
        rate_body: angular rate, body axes (3,); None where the body cannot turn freely.
        attitude_error: target quaternion (4,) → rows that vanish at that attitude and at no
            other, fewer than the attitude has components; None where the body never turns.
    """

    position: Sym
    rotation: Sym
    velocity: Sym
    rate_body: Sym | None
    attitude_error: Callable[[Sym], Sym] | None
