"""Paths worth trying, with no word from the user: straight, around each thing, turned, random."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.body import Body
from berthing.geometry.enclosing import extents
from berthing.geometry.pose import Pose
from berthing.guess.in_the_way import in_the_way
from berthing.guess.nearby import ROOM
from berthing.guess.path import Guess, VehiclePath
from berthing.guess.thrust import pushing_attitude, turned_onto
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle

RANDOM_GUESSES = 2
"""They are what a seed changes."""

MAX_OBSTACLES = 3
"""Structures to go around one by one, those nearest the straight line first."""


@dataclass(frozen=True)
class _Ends:
    r0: Array
    q0: Array
    r1: Array
    q1: Array

    @property
    def along(self) -> Array:
        """Unit vector from start to goal; x where they coincide."""
        step = self.r1 - self.r0
        length = float(np.linalg.norm(step))
        return step / length if length > 0.0 else np.eye(len(step))[0]


def candidates(
    scenario: Scenario, phase: Phase, seed: int, drawn: int = RANDOM_GUESSES
) -> list[Guess]:
    """Guesses in the order in which they are worth trying, ``drawn`` of them random."""
    duration = phase.horizon.nominal_s
    ends = {v.name: _ends(scenario, v, duration) for v in phase.vehicles}
    out = [_guess("straight", phase, ends, {}), *_pushing(phase, ends)]
    if not scenario.structures and len(phase.vehicles) < 2:
        return out
    out += _turned(phase, ends)
    around = _around(scenario, phase, ends, duration)
    lots = _random(scenario, phase, ends, duration, np.random.default_rng(seed), drawn)
    # The nearest thing's sides first, then one drawn by the seed, then the rest.
    return [*out, *around[:4], *lots[:1], *around[4:], *lots[1:]]


def _ends(scenario: Scenario, vehicle: Vehicle, duration_s: float) -> _Ends:
    start = vehicle.start.resolve(0.0, scenario)
    goal = vehicle.goal.resolve(duration_s, scenario)
    q0, q1 = start.attitude.nominal(), goal.attitude.nominal()
    return _Ends(start.position_m, q0, goal.position_m, q1 if q0 @ q1 >= 0.0 else -q1)


def _guess(
    name: str, phase: Phase, ends: dict[str, _Ends], middle: dict[str, tuple[Array, Array | None]]
) -> Guess:
    """Straight paths, but through the middle waypoint (position, attitude or None) where given."""
    paths = {}
    for vehicle in phase.vehicles:
        end = ends[vehicle.name]
        if vehicle.name in middle:
            position, attitude = middle[vehicle.name]
            q = _midway(end) if attitude is None else attitude
            positions = np.stack([end.r0, position, end.r1])
            paths[vehicle.name] = VehiclePath(positions, np.stack([end.q0, q, end.q1]))
        else:
            paths[vehicle.name] = VehiclePath(
                np.stack([end.r0, end.r1]), np.stack([end.q0, end.q1])
            )
    return Guess(name, paths)


def _midway(end: _Ends) -> Array:
    return np.asarray(quaternion.slerp(end.q0, end.q1, np.asarray(0.5)))


def _around(
    scenario: Scenario, phase: Phase, ends: dict[str, _Ends], duration_s: float
) -> list[Guess]:
    """Past each structure on every side, by no more than it takes."""
    out = []
    margin = scenario.margins.default_m
    lead = phase.vehicles[0]
    for name, body, pose in _obstacles(scenario, lead, ends[lead.name], duration_s):
        # The frame of a body may lie anywhere; what is to be passed is its middle.
        centre = _centre(body, pose)
        for label, lead_side in _sides(ends[lead.name].along):
            middle: dict[str, tuple[Array, Array | None]] = {}
            for vehicle in phase.vehicles:
                # A vehicle that goes another way has other sides; it takes the first one's then.
                side = dict(_sides(ends[vehicle.name].along)).get(label, lead_side)
                reach = body_support(body, pose, side)
                size = body_support(vehicle.body, Pose.identity(vehicle.dim), -side)
                offset = reach - side @ centre + size + margin
                middle[vehicle.name] = (centre + offset * side, None)
            out.append(_guess(f"{label} past {name}", phase, ends, middle))
    if len(phase.vehicles) > 1:
        out += _apart(phase, ends)
    return out


def _apart(phase: Phase, ends: dict[str, _Ends]) -> list[Guess]:
    """Vehicles that make room for each other, to opposite sides of the first one's way."""
    out = []
    room = max(v.body.bounding_radius for v in phase.vehicles)
    for label, side in _sides(ends[phase.vehicles[0].name].along):
        middle: dict[str, tuple[Array, Array | None]] = {}
        for i, vehicle in enumerate(phase.vehicles):
            end = ends[vehicle.name]
            sign = 1.0 if i % 2 == 0 else -1.0
            position = 0.5 * (end.r0 + end.r1) + sign * (1 + i // 2) * room * side
            middle[vehicle.name] = (position, None)
        out.append(_guess(f"apart {label}", phase, ends, middle))
    return out


def _turned(phase: Phase, ends: dict[str, _Ends]) -> list[Guess]:
    """Straight, with the longest side of each body laid along the way in between."""
    middle: dict[str, tuple[Array, Array | None]] = {}
    for vehicle in phase.vehicles:
        end = ends[vehicle.name]
        if vehicle.dim == 3 and vehicle.model.turns:
            q = _along(vehicle.body, end)
            middle[vehicle.name] = (0.5 * (end.r0 + end.r1), q)
    return [_guess("turned along the way", phase, ends, middle)] if middle else []


def _along(body: Body, end: _Ends) -> Array:
    axes = np.eye(3)
    identity = Pose.identity(3)
    spans = [body_support(body, identity, a) + body_support(body, identity, -a) for a in axes]
    long_axis = axes[int(np.argmax(spans))]
    now = quaternion.rotation_matrix(end.q0) @ long_axis
    return turned_onto(now, end.along if now @ end.along >= 0.0 else -end.along, end.q0)


def _pushing(phase: Phase, ends: dict[str, _Ends]) -> list[Guess]:
    """Straight, turned in between so that each body pushes hardest: where time is to be won."""
    if not phase.horizon.is_free:
        return []
    middle: dict[str, tuple[Array, Array | None]] = {}
    for vehicle in phase.vehicles:
        end = ends[vehicle.name]
        q = pushing_attitude(vehicle, end.q0, end.along)
        if q is not None:
            middle[vehicle.name] = (0.5 * (end.r0 + end.r1), q)
    return [_guess("pushing along the way", phase, ends, middle)] if middle else []


def _random(
    scenario: Scenario,
    phase: Phase,
    ends: dict[str, _Ends],
    duration_s: float,
    rng: np.random.Generator,
    count: int,
) -> list[Guess]:
    """Through random poses in a box around everything."""
    out = []
    for i in range(count):
        middle: dict[str, tuple[Array, Array | None]] = {}
        for vehicle in phase.vehicles:
            end = ends[vehicle.name]
            corners = [end.r0, end.r1]
            for _, body, pose in _obstacles(scenario, vehicle, end, duration_s):
                corners += _box(body, pose)
            low, high = np.min(corners, axis=0), np.max(corners, axis=0)
            position = rng.uniform(low - 1.0, high + 1.0)
            q = rng.normal(size=4)
            middle[vehicle.name] = (position, q / np.linalg.norm(q))
        out.append(_guess(f"random {i + 1}", phase, ends, middle))
    return out


def _obstacles(
    scenario: Scenario, vehicle: Vehicle, end: _Ends, duration_s: float
) -> list[tuple[str, Body, Pose]]:
    """What is in the way of structures at half time, nearest the straight line first.

    Nothing goes around half-spaces.
    """
    length = float(np.linalg.norm(end.r1 - end.r0))
    size = 2.0 * vehicle.body.bounding_radius + scenario.margins.default_m
    found = []
    for structure in scenario.structures:
        pose = structure.motion.pose(np.array([0.5 * duration_s]))[0]
        body = in_the_way(structure.body, pose, (end.r0, end.r1), size + ROOM * length, size)
        if body is None:
            continue
        centre = _centre(body, pose)
        along = np.clip((centre - end.r0) @ end.along, 0.0, np.linalg.norm(end.r1 - end.r0))
        distance = float(np.linalg.norm(centre - end.r0 - along * end.along))
        found.append((distance, structure.name, body, pose))
    found.sort(key=lambda item: item[0])
    return [(name, body, pose) for _, name, body, pose in found[:MAX_OBSTACLES]]


def _centre(body: Body, pose: Pose) -> Array:
    return np.asarray(np.mean(_box(body, pose), axis=0))


def _box(body: Body, pose: Pose) -> list[Array]:
    """The lower and the upper corner (d,) of a placed body's box along the inertial axes."""
    boxes = [extents(part.shape, pose.compose(part.placement)) for part in body.parts]
    return [np.min(boxes, axis=0)[0], np.max(boxes, axis=0)[1]]


def body_support(body: Body, pose: Pose, n: Array) -> float:
    """max n·x over a placed body; n (d,) inertial."""
    values = []
    for part in body.parts:
        placed = pose.compose(part.placement)
        values.append(float(n @ placed.position + part.shape.support(placed.unrotate(n))[0]))
    return max(values)


def _sides(along: Array) -> list[tuple[str, Array]]:
    """Unit vectors across ``along``, near the coordinate axes: two in the plane, four in space."""
    out: list[tuple[str, Array]] = []
    names = "xyz"
    order = np.argsort(np.abs(along))[: len(along) - 1]
    basis = [along]
    for axis in sorted(int(a) for a in order):
        v = np.eye(len(along))[axis]
        for b in basis:
            v = v - (v @ b) * b
        v = v / np.linalg.norm(v)
        basis.append(v)
        out += [(f"+{names[axis]}", v), (f"-{names[axis]}", -v)]
    return out
