"""Guesses from routes: collision-free paths of the full shape, found by searching SE(3).

The searches of ``berthing.routes`` take a second or so, so that they are made only where every
simple guess is blocked: through a window after a turn, around a corner, into a truss.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from berthing.errors import BerthingError
from berthing.geometry.arrays import Array
from berthing.guess.path import Guess, VehiclePath
from berthing.routes.checker import Checker
from berthing.routes.ends import ends_of
from berthing.routes.mended import sampled
from berthing.routes.relaxing import WEIGHTS, Relaxing, straight_energy
from berthing.routes.seeking import Seeker
from berthing.scenario.motion import Fixed
from berthing.scenario.native_state import Model
from berthing.scenario.phase import Phase
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.scenario import Scenario
from berthing.scenario.user_model import UserModel
from berthing.scenario.vehicle import Vehicle

SHARE = 0.25
"""Of the time that is left, for routes."""

LONGEST_S = 60.0
"""Of a search where there is no time limit: routes that are found take some seconds at most."""

SHORTCUTS = 40
"""Tried on a route that is a guess as it is."""

DETOURS = (0.3, 0.4, 1.2, 1.2, np.inf)
"""Routes are drawn in turn with so long detours (as of a ``Region``), so many for each that is
wanted: passages differ a hundred times in what they cost, and short ways are missed among all."""

AGREE, DIFFER = 0.05, 0.02
"""Shares of the least energy: two routes so near to it end the search for one, and routes that
differ by less are taken for one."""

STRAIGHT = 1.3
"""Energies of the straight motion with nothing in the way: what costs less is cheap enough."""

ROUND = 0.2
"""Square of the radius of gyration of what has no inertia of its own, in reaches of the body."""

ANY_WAY = ("rigid-body", "point-mass", "free-flyer")
"""Models that can go and turn in any direction."""

# By scenario, seed and how many were wanted: guesses are asked for more than once.
_known: WeakKeyDictionary[Scenario, dict[tuple[int, int], list[Guess]]] = WeakKeyDictionary()


@dataclass(frozen=True)
class _Drawn:
    """A route, relaxed where that can be, and the energy that its motion takes."""

    path: Array
    relaxing: Relaxing | None

    @property
    def energy(self) -> float:
        return np.inf if self.relaxing is None else self.relaxing.energy


def routed(scenario: Scenario, phase: Phase, seed: int, count: int, left_s: float) -> list[Guess]:
    """Guesses along routes, the cheapest first; none where structures move, a phase is one of
    several, or a vehicle cannot follow any path.

    Args:
        count: how many at most; of draws that come to the same, one is taken.
        left_s: time that is left, infinite where there is no limit.
    """
    still = all(isinstance(own.motion, Fixed) for own in scenario.structures)
    alone = len(scenario.phases) == 1
    if not still or not alone or not all(_goes_any_way(own.model) for own in phase.vehicles):
        return []
    known = _known.setdefault(scenario, {})
    if (seed, count) not in known:
        drawn = _cheapest(_draws(scenario, phase, seed, count, SHARE * left_s), count)
        known[seed, count] = [
            Guess(f"route {i + 1}", _paths(own, phase)) for i, own in enumerate(drawn)
        ]
    return known[seed, count]


def _goes_any_way(model: Model) -> bool:
    return (model.name if isinstance(model, UserModel) else model.kind) in ANY_WAY


def _draws(scenario: Scenario, phase: Phase, seed: int, count: int, limit_s: float) -> list[_Drawn]:
    """Routes of several draws."""
    try:
        checker = Checker(scenario, phase)
        ends = ends_of(checker, np.random.default_rng(seed))
    except BerthingError:
        # Ends that keep a margin at their own times alone.
        return []
    deadline = time.monotonic() + max(min(limit_s, LONGEST_S), 1e-3)
    scene, duration_s = checker.compiled, phase.horizon.nominal_s
    weights = np.array([_inertia(own) for own in phase.vehicles])
    seeker = Seeker(checker, *ends, SHORTCUTS if scene is None else 0)
    enough = STRAIGHT * straight_energy(*ends, weights, duration_s)
    found: list[_Drawn] = []
    for number in range(len(DETOURS) * count):
        detour = DETOURS[number % len(DETOURS)]
        if count == 1 and found and np.isinf(detour):
            break
        path = _clear(seeker, seed, number, deadline, detour)
        if path is not None:
            relaxing = None
            if scene is not None:
                relaxing = Relaxing.of(checker.space, scene, path, weights, duration_s)
            if relaxing is not None:
                relaxing.follow(WEIGHTS[0])
            found.append(_Drawn(path, relaxing))
        elif np.isinf(detour):
            # The other searches would end alike.
            break
        # What is not relaxed is not told apart.
        full = scene is None and len(found) == count
        if full or time.monotonic() > deadline or (count == 1 and _settled(found, enough)):
            break
    return found


def _settled(found: list[_Drawn], enough: float) -> bool:
    """Whether more draws are hardly worth it: one is cheap, or two agree on the least."""
    energies = [*sorted(own.energy for own in found), np.inf, np.inf]
    return energies[0] < enough or energies[1] < (1.0 + AGREE) * energies[0]


def _cheapest(found: list[_Drawn], count: int) -> list[_Drawn]:
    """So many that differ, their motions followed to the end."""
    taken: list[_Drawn] = []
    for own in sorted(found, key=lambda one: one.energy):
        if taken and own.energy < (1.0 + DIFFER) * taken[-1].energy:
            continue
        taken.append(own)
        if len(taken) == count:
            break
    for relaxing in (own.relaxing for own in taken if own.relaxing is not None):
        for weight in WEIGHTS[1:]:
            relaxing.follow(weight)
    return taken


def _clear(seeker: Seeker, seed: int, number: int, deadline: float, detour: float) -> Array | None:
    """States (n + 1, V, 7) of a path that is clear at samples: what follows it certifies itself."""
    for search in seeker.searches(seed, number, deadline, detour):
        for path in search.paths:
            states = sampled(search.slides, path)
            if states is not None:
                return states
    return None


def _inertia(vehicle: Vehicle) -> list[float]:
    """What a force and a torque pay for accelerations, about; of other models in terms of mass."""
    model = vehicle.model
    if isinstance(model, RigidBody):
        return [model.mass_kg] * 3 + [float(np.trace(model.inertia_kg_m2)) / 3.0] * 3
    return [1.0] * 3 + [ROUND * vehicle.body.bounding_radius**2] * 3


def _paths(own: _Drawn, phase: Phase) -> dict[str, VehiclePath]:
    states = own.path if own.relaxing is None else own.relaxing.states
    fractions = None if own.relaxing is None else np.linspace(0.0, 1.0, len(states))
    return {
        vehicle.name: VehiclePath(
            np.array(states[:, i, : vehicle.dim]), np.array(states[:, i, 3:]), fractions
        )
        for i, vehicle in enumerate(phase.vehicles)
    }
