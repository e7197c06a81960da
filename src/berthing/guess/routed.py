"""Guesses from routes: collision-free paths of the full shape, found by searching SE(3).

The searches of ``berthing.routes`` take a second or so, so that they are made only where every
simple guess is blocked: through a window after a turn, around a corner, into a truss.
"""

from __future__ import annotations

from weakref import WeakKeyDictionary

import numpy as np

from berthing.errors import BerthingError
from berthing.guess.path import Guess, VehiclePath
from berthing.routes.routing import Routes, route
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

SEEDS = 1000
"""Of routes to a seed of ours: those of different seeds are never the same."""

# By scenario, seed and number: the guesses of a scenario are asked for more than once.
_known: WeakKeyDictionary[Scenario, dict[tuple[int, int], Guess | None]] = WeakKeyDictionary()


def routed(scenario: Scenario, phase: Phase, seed: int, count: int, left_s: float) -> list[Guess]:
    """Guesses along routes; none where structures move, or a vehicle cannot follow any path.

    Args:
        count: how many, of different draws.
        left_s: time that is left, infinite where there is no limit.
    """
    still = all(isinstance(own.motion, Fixed) for own in scenario.structures)
    if not still or not all(_goes_any_way(own.model) for own in phase.vehicles):
        return []
    known = _known.setdefault(scenario, {})
    found = []
    for i in range(count):
        key = seed, i
        if key not in known:
            known[key] = _guess(scenario, phase, key, SHARE * left_s)
        guess = known[key]
        if guess is None:
            # The other searches would end alike.
            break
        found.append(guess)
    return found


def _goes_any_way(model: Model) -> bool:
    return (model.name if isinstance(model, UserModel) else model.kind) in ANY_WAY


def _guess(scenario: Scenario, phase: Phase, key: tuple[int, int], limit_s: float) -> Guess | None:
    seed, i = key
    try:
        answer = route(
            scenario, seed=SEEDS * seed + i, time_limit_s=max(min(limit_s, LONGEST_S), 1e-3),
            shortcuts=SHORTCUTS,
        )
    except BerthingError:
        # Ends that keep a margin at their own times alone.
        return None
    return Guess(f"route {i + 1}", _paths(answer, phase)) if answer.routes else None


def _paths(answer: Routes, phase: Phase) -> dict[str, VehiclePath]:
    states = answer.routes[0].states
    paths = {}
    for i, name in enumerate(answer.vehicles):
        own = states[:, i]
        dim = phase.vehicle(name).dim
        paths[name] = VehiclePath(np.array(own[:, :dim]), np.array(own[:, 3:]))
    return paths
