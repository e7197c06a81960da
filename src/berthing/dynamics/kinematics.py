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
        velocity: of the reference point, inertial (d,); None where the state does not tell.
        rate_body: angular rate, body axes (3,), about z (1,) in the plane; None where the body
            cannot turn freely, or the state does not tell.
        attitude_error: target quaternion (4,) → rows that vanish at that attitude and at no
            other, fewer than the attitude has components; None where the body never turns.
        quaternion: the attitude as it stands in the state (4,), of any norm; None where it is
            none.
    """

    position: Sym
    rotation: Sym
    velocity: Sym | None
    rate_body: Sym | None
    attitude_error: Callable[[Sym], Sym] | None
    quaternion: Sym | None = None
