"""Routes: paths of the full shape from start to goal, every leg of them certified."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.result import CERTIFIED, ITERATION_LIMIT, TIME_LIMIT, ProgressEvent
from berthing.routes.checker import Checker
from berthing.routes.ends import ends_of
from berthing.routes.legs import Legs
from berthing.routes.proven import proven
from berthing.routes.region import Region
from berthing.routes.resting import at_rest
from berthing.routes.shorten import TRIES, shortened
from berthing.routes.sliding import slider
from berthing.routes.space import stride
from berthing.routes.trees import Trees
from berthing.routes.ways import same_way
from berthing.scenario.scenario import Scenario
from berthing.verify.endpoints import check_endpoints

Progress = Callable[[ProgressEvent], None]

# Searches, by what they keep beyond margins (an index of ``Region.pads_m``), the share of a whole
# step, and rounds: a passage that a wide pad closes is soon looked for with a narrow one, short
# steps do not leap through what is thin, and patience comes last.
LADDER = (
    (0, 1.0, 400), (1, 1.0, 400), (2, 1.0, 400),
    (0, 0.25, 400), (0, 1.0, 4000), (1, 0.5, 4000), (2, 0.25, 4000),
)  # fmt: skip

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
    shortcuts: int = TRIES,
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
        shortcuts: that are tried on a path: fewer of them leave it longer, sooner.

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
    search = _Searches(checker, start, goal, seed, began + (time_limit_s or np.inf), progress)
    search.shortcuts = shortcuts
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
        self, checker: Checker, start: Array, goal: Array, seed: int, deadline: float,
        progress: Progress | None,
    ) -> None:  # fmt: skip
        self._checker, self._start, self._goal = checker, start, goal
        self._region = Region.of(checker, start, goal)
        self._seed, self._deadline, self._progress = seed, deadline, progress
        self.routes: list[Route] = []
        self.made: list[Search] = []
        self.shortcuts = TRIES

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
        for rung, (pad, share, rounds) in enumerate(LADDER):
            rng = np.random.default_rng([self._seed, number, rung])
            began = time.monotonic()
            region = replace(self._region, step_m=share * self._region.step_m)
            found = self._search(region.pads_m[pad], region, rounds, rng)
            seconds = time.monotonic() - began
            self.made.append(Search(region.pads_m[pad], region.step_m, rounds, found, seconds))
            if found in ("way", "known"):
                return True
            if self.late:
                break
        return False

    def _search(self, pad_m: float, region: Region, rounds: int, rng: np.random.Generator) -> str:
        checker = self._checker
        self._say("search", f"{1e3 * pad_m:.3g} mm beyond margins")
        slides = slider(checker, pad_m, region.step_m)
        trees = Trees(checker.space, slides, region, rng, self._deadline)
        path = trees.path(self._start, self._goal, rounds)
        if path is None:
            return "nothing"
        self._say("prove", f"{len(path)} states")
        short = shortened(checker.space, slides, path, rng, self.shortcuts)
        for candidate in (short, path):
            states, legs = proven(checker, slides, candidate)
            if legs.certified:
                return self._keep(states, legs)
        return "uncertified"

    def _keep(self, states: Array, legs: Legs) -> str:
        if any(same_way(self._checker, states, old.states) for old in self.routes):
            return "known"
        lengths = self._checker.space.length(stride(states[:-1], states[1:]))
        self.routes.append(Route(states, legs, float(np.sum(lengths))))
        return "way"

    def _say(self, stage: str, detail: str) -> None:
        if self._progress is not None:
            ways = f"{len(self.routes)} found, " if self.routes else ""
            self._progress(ProgressEvent(stage, ways + detail))
