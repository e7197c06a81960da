"""Starts and goals that already break a margin: bad input, found before any planning."""

from __future__ import annotations

import numpy as np

from berthing.clearance.separation import separation
from berthing.errors import InputError
from berthing.geometry.body import Part
from berthing.geometry.pose import Pose
from berthing.scenario.attitude import FixedAttitude
from berthing.scenario.goal import End
from berthing.scenario.motion import Fixed
from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.verify.part_pair import enclosing_ball
from berthing.verify.settings import ENDPOINT_TOLERANCE_M

Poses = dict[tuple[str, str, str, float | None], Pose | None]
"""By phase, owner, end and time."""


def check_endpoints(scenario: Scenario) -> None:
    """Refuse a start or goal at which a pair is closer than its margin, whatever the plan.

    Sets of poses are judged by their best member: a position within r and an attitude within θ
    can be r + 2 ρ sin(θ/2) further away than the centre of the set, ρ the reach of the part from
    the reference point. Ends of free attitude, and goals at a free time beside a structure that
    moves, are left to the planner.

    Raises:
        InputError: names the vehicle, the end, the pair, its distance and its margin.
    """
    begin: float | None = 0.0
    known: Poses = {}
    for phase in scenario.phases:
        end = _end_of(phase, begin)
        for pair in scenario.pairs(phase):
            for name, t in (("start", begin), ("goal", end)):
                _check(scenario, phase, pair, name, t, known)
        begin = end


def _end_of(phase: Phase, begin: float | None) -> float | None:
    """When the phase ends; None where that is for the solver to choose."""
    return None if begin is None or phase.horizon.is_free else begin + phase.horizon.min_s


def _check(
    scenario: Scenario, phase: Phase, pair: Pair, name: str, t: float | None, known: Poses
) -> None:
    margin = _margin(scenario, phase, pair, t)
    if margin is None:
        return
    ends = [_end(owner, name) for owner in (pair.owner_a, pair.owner_b)]
    if t is None and ends[0] is not None and ends[0].frame == pair.owner_b.name:
        # In the structure's own frame the pair is the same at all times.
        t = 0.0
    poses: list[Pose | None] = []
    for owner, end in zip((pair.owner_a, pair.owner_b), ends, strict=True):
        key = (phase.name, owner.name, name, t)
        if key not in known:
            known[key] = _pose(scenario, owner, end, t)
        poses.append(known[key])
    if poses[0] is None or poses[1] is None:
        return
    a, b = pair.part_a, pair.part_b
    if _balls_apart(poses[0], a, poses[1], b) >= margin:
        return
    found = separation(
        a.shape, poses[0].compose(a.placement), b.shape, poses[1].compose(b.placement)
    )
    reach = sum(_slack(end, part) for end, part in zip(ends, (a, b), strict=True))
    if found.distance + reach < margin - ENDPOINT_TOLERANCE_M:
        where = f"{pair.owner_a.name}.{name}"
        state = "overlaps" if found.distance < 0.0 else "is too close to"
        raise InputError(
            where,
            f"{pair.ref_a} {state} {pair.ref_b}: their distance is {found.distance:.6g} m",
            f"at least the margin of {margin:g} m",
        )


def _balls_apart(pose_a: Pose, a: Part, pose_b: Pose, b: Part) -> float:
    """No more than the distance of two parts whose bodies are at the poses (m)."""
    ball_a, ball_b = enclosing_ball(a), enclosing_ball(b)
    dim = pose_a.dim
    apart = pose_b.apply(ball_b.centre[:dim]) - pose_a.apply(ball_a.centre[:dim])
    return float(np.linalg.norm(apart)) - ball_a.radius - ball_b.radius


def _end(owner: Vehicle | Structure, name: str) -> End | None:
    """The start or goal of a vehicle; a structure has none."""
    if isinstance(owner, Structure):
        return None
    return owner.start if name == "start" else owner.goal


def _margin(scenario: Scenario, phase: Phase, pair: Pair, t: float | None) -> float | None:
    """The margin at t; at an unknown time the least that could hold, None if contact could."""
    if t is not None:
        return scenario.margins.margin(pair.ref_a, pair.ref_b, t)
    latest = sum(p.horizon.max_s for p in scenario.phases)
    windows = scenario.margins.windows(pair.ref_a, pair.ref_b, (0.0, latest))
    margins = [margin for _, _, margin in windows]
    return None if None in margins else min(m for m in margins if m is not None)


def _pose(
    scenario: Scenario, owner: Vehicle | Structure, end: End | None, t: float | None
) -> Pose | None:
    """The pose at the end, or the centre of its set; None where it is not known."""
    if end is None:
        return None if not isinstance(owner, Structure) else _structure_pose(owner, t)
    if not isinstance(end.attitude, FixedAttitude) and _turns(owner):
        return None
    frame = None if end.frame is None else scenario.structure(end.frame)
    if t is None and frame is not None and not isinstance(frame.motion, Fixed):
        return None
    return end.resolve(0.0 if t is None else t, scenario).pose


def _turns(owner: Vehicle | Structure) -> bool:
    """Whether the attitude is part of the vehicle's state; of others it is always the identity."""
    return isinstance(owner, Vehicle) and owner.model.turns


def _structure_pose(structure: Structure, t: float | None) -> Pose | None:
    if t is None and not isinstance(structure.motion, Fixed):
        return None
    return structure.motion.pose(np.array([0.0 if t is None else t]))[0]


def _slack(end: End | None, part: Part) -> float:
    """How much further away than its centre a member of the set can be (m)."""
    if end is None:
        return 0.0
    ball = enclosing_ball(part)
    reach = float(np.linalg.norm(ball.centre)) + ball.radius
    angle = getattr(end.attitude, "tolerance_rad", 0.0)
    return end.position_tolerance_m + 2.0 * reach * float(np.sin(0.5 * angle))
