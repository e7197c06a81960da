"""The pose tube: how far what flies may be from the interpolant, which is what is certified."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from berthing.geometry.body import Part
from berthing.scenario.pair import Pair
from berthing.verify.part_pair import enclosing_ball
from berthing.verify.replay import Replay
from berthing.verify.settings import INTEGRATOR_ATTITUDE_RAD, INTEGRATOR_POSITION_M


@dataclass(frozen=True)
class Tube:
    """Bounds over all instants of a phase on the error of a vehicle's pose.

    Attributes:
        position_m: of the reference point.
        attitude_rad: the angle of the rotation between what flies and the interpolant.
    """

    position_m: float
    attitude_rad: float

    def around(self, part: Part) -> float:
        """How far a point of the part may be from where the interpolant has it (m).

        A turn by θ moves a point at the distance ρ from the axis by 2 ρ sin(θ/2) at most; the
        part lies in a ball.
        """
        if self.attitude_rad == 0.0:
            return self.position_m
        ball, half = enclosing_ball(part), 0.5 * min(self.attitude_rad, math.pi)
        reach = float(np.linalg.norm(ball.centre)) + ball.radius
        return self.position_m + 2.0 * math.sin(half) * reach


EXACT = Tube(0.0, 0.0)


def tube_of(replay: Replay) -> Tube:
    """What the replay found, and an allowance for the error of the replay itself."""
    turned = replay.attitude_error_rad
    return Tube(
        replay.position_error_m + INTEGRATOR_POSITION_M,
        # What never turns is not turned by its integrator either.
        turned + INTEGRATOR_ATTITUDE_RAD if turned > 0.0 else 0.0,
    )


def tubes_of(replays: Iterable[Replay]) -> dict[str, Tube]:
    """By vehicle."""
    return {replay.vehicle: tube_of(replay) for replay in replays}


def pair_tube(pair: Pair, tubes: Mapping[str, Tube]) -> float:
    """By how much what flies may be nearer than the interpolant says (m), both bodies together.

    Structures move as they are told.
    """
    ends = ((pair.owner_a, pair.part_a), (pair.owner_b, pair.part_b))
    return sum(tubes.get(owner.name, EXACT).around(part) for owner, part in ends)
