"""A scenario whose one structure moves, seen from that structure, where it rests."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.pose import Pose
from berthing.routes.legs import require_rest
from berthing.routes.space import Space, state_of
from berthing.scenario.goal import End
from berthing.scenario.motion import ConstantVelocity, Fixed
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle


def at_rest(scenario: Scenario) -> tuple[Scenario, str | None]:
    """The scenario in a frame in which its structures rest, and whose frame that is.

    As it is where they rest in the inertial frame. Where the only structure moves, vehicles start
    where it sees them at the time 0, and their goals have to be in its frame.

    Raises:
        InputError: structures that move and have no such frame, or a goal in another frame.
    """
    if all(isinstance(own.motion, Fixed) for own in scenario.structures):
        return scenario, None
    if len(scenario.structures) > 1:
        require_rest(scenario)
    (structure,) = scenario.structures
    frame = structure.motion.pose(np.zeros(1))[0]
    turning = not isinstance(structure.motion, ConstantVelocity)
    phases = tuple(
        replace(
            phase,
            vehicles=tuple(_seen(own, structure.name, frame, turning) for own in phase.vehicles),
        )
        for phase in scenario.phases
    )
    still = replace(structure, motion=Fixed(Pose.identity(structure.dim)))
    return replace(scenario, phases=phases, structures=(still,)), structure.name


def _seen(own: Vehicle, structure: str, frame: Pose, turning: bool) -> Vehicle:
    goal = own.goal
    if goal.frame != structure:
        what = f"is not in the frame of {structure}, which moves"
        raise InputError(f"{own.name}.goal", what, "a goal in its frame, or structures at rest")
    if turning and not own.model.turns and own.body.bounding_radius > 0.0:
        what = f"does not turn, and {structure} does"
        raise InputError(own.name, what, "a vehicle that turns, or structures at rest")
    space = Space.of([own])
    if np.any(np.isfinite([space.lower_m, space.upper_m])):
        what = f"has limits on its position, and {structure} moves"
        raise InputError(own.name, what, "no such limits, or structures at rest")
    return replace(own, start=_start(own, structure, frame), goal=replace(goal, frame=None))


def _start(own: Vehicle, structure: str, frame: Pose) -> End:
    start = own.start
    if start.frame == structure:
        return replace(start, frame=None)
    if start.frame is not None:
        raise InputError(f"{own.name}.start", f"is in the frame of {start.frame}", structure)
    turned = quaternion.conjugate(state_of(frame)[3:])
    return replace(
        start,
        position_m=frame.inverse().apply(start.position_m),
        attitude=start.attitude.in_frame(turned),
    )
