"""Where a route begins and ends: a state out of each set of starts and goals."""

from __future__ import annotations

import numpy as np

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.routes.checker import Checker
from berthing.routes.space import state_of
from berthing.scenario.attitude import Attitude, AxisAttitude, FixedAttitude
from berthing.scenario.goal import End
from berthing.scenario.vehicle import Vehicle
from berthing.verify.frames import lifted

# States drawn from a set of ends whose middle is too near something.
DRAWN = 400


def ends_of(checker: Checker, rng: np.random.Generator) -> tuple[Array, Array]:
    """A valid start and a valid goal (V, 7): the middles of the sets if they are.

    Raises:
        InputError: no member that was tried keeps its margins and limits.
    """
    return _end(checker, "start", rng), _end(checker, "goal", rng)


def _end(checker: Checker, name: str, rng: np.random.Generator) -> Array:
    sets = [own.start if name == "start" else own.goal for own in checker.vehicles]
    pairs = list(zip(checker.vehicles, sets, strict=True))
    middle = np.array([_member(checker, own, end, None) for own, end in pairs])
    if checker.valid_state(middle):
        return middle
    for _ in range(DRAWN):
        state = np.array([_member(checker, own, end, rng) for own, end in pairs])
        if checker.valid_state(state):
            return state
    raise _refusal(checker, name, middle)


def _refusal(checker: Checker, name: str, middle: Array) -> InputError:
    found = checker.clearance_of(middle)
    where = f"{' and '.join(own.name for own in checker.vehicles)}: {name}"
    if found.excess_m >= 0.0:
        return InputError(where, "lies outside of the limits on positions", "a place within them")
    what = f"{found.pair} are {found.distance_m:.6g} m apart"
    return InputError(
        where, what, f"{found.required_m:g} m, the largest margin that they ever have"
    )


def _member(checker: Checker, own: Vehicle, end: End, rng: np.random.Generator | None) -> Array:
    """A row (7,): the middle of the set, or one that is drawn."""
    at = end.resolve(0.0, checker.scenario)
    row = state_of(at.pose)
    if not own.model.turns:
        row[3:] = [1.0, 0.0, 0.0, 0.0]
    if rng is None:
        return row
    push = rng.normal(size=own.dim)
    push *= at.position_tolerance_m * rng.random() ** (1.0 / own.dim) / np.linalg.norm(push)
    row[:3] += lifted(push)
    if own.model.turns:
        row[3:] = _turned(at.attitude, row[3:], own.dim, rng)
    return row


def _turned(attitude: Attitude, q: Array, dim: int, rng: np.random.Generator) -> Array:
    """A member of the set of attitudes with the middle q, by a turn in inertial axes."""
    axis = rng.normal(size=3) if dim == 3 else np.array([0.0, 0.0, 1.0])
    angle = rng.uniform(-np.pi, np.pi)
    if isinstance(attitude, FixedAttitude):
        angle *= attitude.tolerance_rad / np.pi
    elif isinstance(attitude, AxisAttitude):
        axis = attitude.world_axis
    return quaternion.multiply(quaternion.from_axis_angle(axis, angle), q)
