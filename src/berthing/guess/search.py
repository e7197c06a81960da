"""Answers of guesses as they come in, and which of them is worth refining next.

What is tried is counted in guesses, never in seconds, and an answer counts only once all guesses
before it have ended: the same candidates come out on every machine, however many cores it has. Only
a time limit cuts this short.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np

from berthing.scenario.phase import Phase
from berthing.solve.outcome import Outcome
from berthing.solve.parallel import cores
from berthing.transcription.problem import Motion

SAME_PASSAGE = 0.25
"""Answers nearer than this share of the scenario's length are one and the same."""

SAME_COST = 1e-3
"""Answers whose costs differ by less than this share agree."""


@dataclass(frozen=True)
class Effort:
    """How far to look for a cheaper way.

    Attributes:
        agreeing: guesses are solved until so many answers agree on the least cost,
        answers: or until there are so many of them.
        worth: with a certified plan at hand, a further answer is refined only if its cost, which
            understates, is below this share of the plan's.
        drawn: random guesses.
        exact: pairs near some guess, up to which planes are variables from the start: answers are
            then optimal to the last digit, where convex steps end within a percent, but sooner.
        routes: guesses along routes, where simple guesses are blocked: the cheapest of four times
            as many that are drawn.
    """

    agreeing: float
    answers: float
    worth: float
    drawn: int
    exact: int
    routes: int


EFFORTS = {
    "fast": Effort(agreeing=1, answers=1, worth=0.0, drawn=2, exact=3, routes=1),
    "normal": Effort(agreeing=2, answers=4, worth=0.97, drawn=2, exact=6, routes=2),
    "thorough": Effort(agreeing=np.inf, answers=np.inf, worth=1.0, drawn=8, exact=6, routes=6),
}


class Answers(Protocol):
    """Where answers come from, such as a ``SolvePool``."""

    @property
    def busy(self) -> bool:
        """Whether there are starts that have not ended."""

    def poll(self, at_once: int, timeout_s: float | None) -> list[tuple[int, Outcome]]:
        """Start and outcome of those that have ended; waits for one at least, at most so long."""

    def close(self) -> None:
        """Give up those that have not ended."""


@dataclass
class Search:
    """Guesses of one phase, solved in the pool's order.

    Attributes:
        names: of the pool's starts.
        length_m: of the scenario.
        note: is told (name, outcome) of each.
        deadline: on the monotonic clock.
    """

    names: list[str]
    pool: Answers
    effort: Effort
    phase: Phase
    length_m: float
    note: Callable[[str, Outcome], None]
    deadline: float
    _ended: dict[int, Outcome] = field(default_factory=dict)
    _taken: int = 0
    _answers: list[tuple[str, Outcome]] = field(default_factory=list)
    _tried: list[Outcome] = field(default_factory=list)

    @property
    def motions(self) -> list[Motion]:
        """Of the answers so far."""
        return [outcome.motion for _, outcome in self._answers]

    def first_answers(self) -> None:
        """Solve guesses until the effort has what it asks for."""
        while not self._enough() and self._more():
            pass

    def next_candidate(
        self, certified_cost: float | None, *, more: bool = True
    ) -> tuple[str, Outcome] | None:
        """The cheapest answer of a passage not tried yet.

        Args:
            certified_cost: of the best certified plan. Where there is one, answers that may beat it
                count; where there is none, guesses are solved until one comes up,
            more: but only those solved already count where this is False.
        """
        worth = np.inf if certified_cost is None else self.effort.worth * certified_cost
        while True:
            for name, outcome in sorted(self._answers, key=lambda item: item[1].cost):
                known = certified_cost is not None and self._agrees(outcome)
                if outcome.cost < worth and not known and self._is_new(outcome):
                    self._tried.append(outcome)
                    return name, outcome
            if certified_cost is not None or not more or not self._more():
                return None

    def _enough(self) -> bool:
        costs = sorted(outcome.cost for _, outcome in self._answers)
        agree = sum(cost <= (1.0 + SAME_COST) * costs[0] for cost in costs)
        return agree >= self.effort.agreeing or len(costs) >= self.effort.answers

    def _more(self) -> bool:
        """Take one more guess into account, in their order; False where there is none."""
        while self._taken not in self._ended:
            left = self.deadline - time.monotonic()
            if self.pool.busy and left > 0.0:
                for i, outcome in self.pool.poll(cores(), left if np.isfinite(left) else None):
                    self._ended[i] = outcome
                    self.note(self.names[i], outcome)
            elif self._taken + 1 < len(self.names):
                # It died, or time is up.
                self._taken += 1
            else:
                return False
        outcome = self._ended[self._taken]
        if outcome.solved:
            self._answers.append((self.names[self._taken], outcome))
        self._taken += 1
        return True

    def _agrees(self, outcome: Outcome) -> bool:
        """Whether one that was tried costs the same: a mirror image, as often as not."""
        return any(abs(outcome.cost - old.cost) <= SAME_COST * old.cost for old in self._tried)

    def _is_new(self, outcome: Outcome) -> bool:
        apart_m = SAME_PASSAGE * self.length_m
        return all(_distance(outcome, old, self.phase) > apart_m for old in self._tried)


def _distance(a: Outcome, b: Outcome, phase: Phase) -> float:
    """Largest distance of two answers' positions over vehicles and nodes."""
    gaps = [
        a.motion.states[v.name][: v.dim] - b.motion.states[v.name][: v.dim] for v in phase.vehicles
    ]
    return max(float(np.max(np.linalg.norm(gap, axis=0))) for gap in gaps)
