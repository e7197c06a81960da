"""Routes: paths of the full shape from start to goal, every leg of them certified."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.result import CERTIFIED, ITERATION_LIMIT, TIME_LIMIT, ProgressEvent
from berthing.routes.checker import Checker
from berthing.routes.ends import ends_of
from berthing.routes.legs import Legs
from berthing.routes.proven import proven
from berthing.routes.resting import at_rest
from berthing.routes.seeking import Found, Seeker
from berthing.routes.space import stride
from berthing.routes.ways import same_way
from berthing.scenario.scenario import Scenario
from berthing.verify.endpoints import check_endpoints

Progress = Callable[[ProgressEvent], None]

# Routes found for each way that is asked for, after which there is taken to be no other.
ROUTES_A_WAY = 6


@dataclass(frozen=True)
class Route:
    """One way from start to goal.

    Attributes:
        states: (n + 1, V, 7), vehicles as in ``Routes``: position in m and q_IB, scalar first.
        legs: what is proven of the n legs between them; all are certified.
        length_m: of the whole, turns counted by the reach of the bodies.
    """

    states: Array
    legs: Legs
    length_m: float

    @property
    def clearance_m(self) -> float:
        """Below the clearance of every pair at every instant; +∞ without pairs."""
        return float(np.min(self.legs.bound_m))


@dataclass(frozen=True)
class Search:
    """One search that was made.

    Attributes:
        pad_m: kept beyond margins. step_m: its steps. rounds: at most.
        found: ``nothing``, ``uncertified``, ``known`` for a way that was found before, or ``way``.
        wall_time_s: how long it took.
    """

    pad_m: float
    step_m: float
    rounds: int
    found: str
    wall_time_s: float


@dataclass(frozen=True)
class Routes:
    """The answer to a scenario; finding none is an answer too.

    Attributes:
        outcome: ``certified`` where there is a route; ``iteration_limit`` or ``time_limit``.
        vehicles: names, in the order of the rows of a state.
        frame: None where states are in the inertial frame, else the moving structure in whose
            frame they are.
        routes: the ways found, in the order in which they were.
        searches: what was tried.
    """

    outcome: str
    vehicles: tuple[str, ...]
    frame: str | None
    routes: tuple[Route, ...]
    searches: tuple[Search, ...]
    seed: int
    wall_time_s: float


def route(
    scenario: Scenario,
    *,
    seed: int = 0,
    classes: int = 1,
    time_limit_s: float | None = None,
    progress: Progress | None = None,
) -> Routes:
    """Find ways for the vehicles of a scenario, and prove them.

    All vehicles move at once; on each leg straight and at a constant rate of turn. Nothing is said
    of forces, speeds or times, nor of how a vehicle can move: `berthing.plan` finds motions. Where
    the only structure moves, a route is a path in its frame.

    Args:
        seed: of what is drawn; the same seed gives the same routes.
        classes: how many ways that cannot be swept into each other by straight strides.
        time_limit_s: wall time allowed; None for as long as the searches take.
        progress: is told what goes on.

    Raises:
        InputError: a scenario of several phases, structures that move apart or a goal that does
            not move along, an end that is too near something, or options out of range.
    """
    _check(scenario, classes, time_limit_s)
    began = time.monotonic()
    check_endpoints(scenario)
    still, frame = at_rest(scenario)
    checker = Checker(still)
    start, goal = ends_of(checker, np.random.default_rng(seed))
    seeker = Seeker(checker, start, goal)
    search = _Searches(seeker, seed, began + (time_limit_s or np.inf), progress)
    search.run(classes)
    outcome = CERTIFIED if search.routes else TIME_LIMIT if search.late else ITERATION_LIMIT
    names = tuple(own.name for own in checker.vehicles)
    seconds = time.monotonic() - began
    return Routes(outcome, names, frame, tuple(search.routes), tuple(search.made), seed, seconds)


def _check(scenario: Scenario, classes: int, time_limit_s: float | None) -> None:
    if classes < 1:
        raise InputError("classes", f"is {classes}", "1 or more")
    if time_limit_s is not None and not time_limit_s > 0.0:
        raise InputError("time_limit_s", f"is {time_limit_s:g}", "more than zero seconds")
    if len(scenario.phases) > 1:
        what = f"has {len(scenario.phases)} phases; between them bodies change"
        raise InputError(scenario.name, what, "a scenario of one phase")


class _Searches:
    """What is tried, in order, and what came of it."""

    def __init__(
        self, seeker: Seeker, seed: int, deadline: float, progress: Progress | None
    ) -> None:
        self._seeker, self._seed = seeker, seed
        self._deadline, self._progress = deadline, progress
        self.routes: list[Route] = []
        self.made: list[Search] = []

    @property
    def late(self) -> bool:
        return time.monotonic() > self._deadline

    def run(self, classes: int) -> None:
        """Search until there are so many ways, or no others come up."""
        for number in range(ROUTES_A_WAY * classes):
            if len(self.routes) >= classes or not self._one(number):
                break

    def _one(self, number: int) -> bool:
        """Find one route, of a new way or not; False where there is none or time is up."""
        began = time.monotonic()
        self._say("search", f"route {number + 1}")
        for search in self._seeker.searches(self._seed, number, self._deadline):
            found = self._kept(search)
            now = time.monotonic()
            self.made.append(Search(search.pad_m, search.step_m, search.rounds, found, now - began))
            began = now
            if found in ("way", "known"):
                return True
            self._say("search", f"{1e3 * search.pad_m:.3g} mm beyond margins: {found}")
        return False

    def _kept(self, search: Found) -> str:
        for candidate in search.paths:
            self._say("prove", f"{len(candidate)} states")
            states, legs = proven(self._seeker.checker, search.slides, candidate)
            if legs.certified:
                return self._keep(states, legs)
        return "uncertified" if search.paths else "nothing"

    def _keep(self, states: Array, legs: Legs) -> str:
        checker = self._seeker.checker
        if any(same_way(checker, states, old.states) for old in self.routes):
            return "known"
        lengths = checker.space.length(stride(states[:-1], states[1:]))
        self.routes.append(Route(states, legs, float(np.sum(lengths))))
        return "way"

    def _say(self, stage: str, detail: str) -> None:
        if self._progress is not None:
            ways = f"{len(self.routes)} found, " if self.routes else ""
            self._progress(ProgressEvent(stage, ways + detail))
