"""Guesses from routes: collision-free paths of the full shape, found by searching SE(3).

The searches of ``berthing.routes`` take a second or so, so that they are made only where every
simple guess is blocked: through a window after a turn, around a corner, into a truss.
"""

from __future__ import annotations

import time
from itertools import takewhile
from weakref import WeakKeyDictionary

import numpy as np

from berthing.errors import BerthingError
from berthing.geometry.arrays import Array
from berthing.guess.path import Guess, VehiclePath
from berthing.routes.checker import Checker
from berthing.routes.ends import ends_of
from berthing.routes.mended import sampled
from berthing.routes.seeking import Seeker
from berthing.scenario.motion import Fixed
from berthing.scenario.native_state import Model
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.user_model import UserModel

SHARE = 0.25
"""Of the time that is left, for one route."""

LONGEST_S = 60.0
"""Of a search where there is no time limit: routes that are found take some seconds at most."""

SHORTCUTS = 40
"""Tried on a route: what it is a guess of is made shorter by other means."""

ANY_WAY = ("rigid-body", "point-mass", "free-flyer")
"""Models that can go and turn in any direction."""

# By scenario, seed and number: the guesses of a scenario are asked for more than once.
_known: WeakKeyDictionary[Scenario, dict[tuple[int, int], Guess | None]] = WeakKeyDictionary()


def routed(scenario: Scenario, phase: Phase, seed: int, count: int, left_s: float) -> list[Guess]:
    """Guesses along routes; none where structures move, a phase is one of several, or a vehicle
    cannot follow any path.

    Args:
        count: how many, of different draws.
        left_s: time that is left, infinite where there is no limit.
    """
    still = all(isinstance(own.motion, Fixed) for own in scenario.structures)
    alone = len(scenario.phases) == 1
    if not still or not alone or not all(_goes_any_way(own.model) for own in phase.vehicles):
        return []
    known = _known.setdefault(scenario, {})
    if not _answered(known, seed, count):
        known.update(_drawn(scenario, phase, seed, count, SHARE * left_s))
    found = (known.get((seed, i)) for i in range(count))
    return [guess for guess in found if guess is not None]


def _answered(known: dict[tuple[int, int], Guess | None], seed: int, count: int) -> bool:
    """Whether all these were looked for, or others after one that was not found."""
    numbers = takewhile(lambda i: (seed, i) in known, range(count))
    asked = [known[seed, i] for i in numbers]
    return len(asked) == count or None in asked


def _goes_any_way(model: Model) -> bool:
    return (model.name if isinstance(model, UserModel) else model.kind) in ANY_WAY


def _drawn(
    scenario: Scenario, phase: Phase, seed: int, count: int, limit_s: float
) -> dict[tuple[int, int], Guess | None]:
    """By seed and number; none after the first that is not found: others would end alike."""
    found: dict[tuple[int, int], Guess | None] = {}
    try:
        checker = Checker(scenario, phase)
        ends = ends_of(checker, np.random.default_rng(seed))
    except BerthingError:
        # Ends that keep a margin at their own times alone.
        return {(seed, 0): None}
    seeker = Seeker(checker, *ends, SHORTCUTS)
    for i in range(count):
        states = _clear(seeker, seed, i, max(min(limit_s, LONGEST_S), 1e-3))
        if states is None:
            found[seed, i] = None
            break
        found[seed, i] = Guess(f"route {i + 1}", _paths(states, phase))
    return found


def _clear(seeker: Seeker, seed: int, number: int, limit_s: float) -> Array | None:
    """States (n + 1, V, 7) of a path that is clear at samples: what follows it certifies itself."""
    for search in seeker.searches(seed, number, time.monotonic() + limit_s):
        for path in search.paths:
            states = sampled(search.slides, path)
            if states is not None:
                return states
    return None


def _paths(states: Array, phase: Phase) -> dict[str, VehiclePath]:
    paths = {}
    for i, vehicle in enumerate(phase.vehicles):
        own = states[:, i]
        paths[vehicle.name] = VehiclePath(np.array(own[:, : vehicle.dim]), np.array(own[:, 3:]))
    return paths
