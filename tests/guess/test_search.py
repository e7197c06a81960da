"""Which answers are refined: counted in guesses, whatever the order in which they come in."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np
import pytest

from berthing.guess.search import EFFORTS, Search
from berthing.solve.outcome import ITERATION_LIMIT, SOLVED, Outcome
from berthing.transcription.problem import Motion
from support.documents import puck, scenario

PHASE = scenario(puck()).phases[0]
(VEHICLE,) = PHASE.vehicles
NX = len(VEHICLE.model.state_names)
LENGTH_M = 4.0


def outcome(cost: float | None, y_m: float = 0.0) -> Outcome:
    """An answer that passes at y, or none."""
    states = np.zeros((NX, 5))
    states[1] = y_m
    motion = Motion(10.0, {VEHICLE.name: states}, {VEHICLE.name: np.zeros((2, 4))})
    none = np.zeros(0)
    return Outcome(
        SOLVED if cost is not None else ITERATION_LIMIT, none, none, none, none, motion,
        cost or 0.0, 1, 0.0, "",
    )  # fmt: skip


@dataclass
class Pool:
    """Hands over what is given, in the order given; None for a child that died."""

    given: dict[int, Outcome | None]
    polls: int = 0

    @property
    def busy(self) -> bool:
        return bool(self.given)

    def poll(self, at_once: int, timeout_s: float | None) -> list[tuple[int, Outcome]]:
        self.polls += 1
        i = next(iter(self.given))
        found = self.given.pop(i)
        return [] if found is None else [(i, found)]

    def close(self) -> None:
        self.given.clear()


def search(
    outcomes: list[Outcome | None], effort: str, order: list[int] | None = None,
    deadline: float = float("inf"),
) -> Search:  # fmt: skip
    pool = Pool({i: outcomes[i] for i in order or range(len(outcomes))})
    names = [f"guess {i}" for i in range(len(outcomes))]
    return Search(names, pool, EFFORTS[effort], PHASE, LENGTH_M, lambda *_: None, deadline)


def next_name(found: Search, certified: float | None = None) -> str | None:
    """Of the next candidate."""
    candidate = found.next_candidate(certified)
    return candidate and candidate[0]


def tried(found: Search, certified: float | None = None) -> list[str]:
    found.first_answers()
    out = []
    while (name := next_name(found, certified)) is not None:
        out.append(name)
    return out


MIXED = [outcome(None), outcome(3.0, 0.0), outcome(2.0, 2.0), outcome(4.0, -2.0), outcome(1.0, 6.0)]


@pytest.mark.parametrize("effort", list(EFFORTS))
@pytest.mark.parametrize("order", [[0, 1, 2, 3, 4], [4, 3, 2, 1, 0], [2, 4, 0, 3, 1]])
def test_order_of_arrival_does_not_matter(effort: str, order: list[int]) -> None:
    for certified in (None, 2.5):
        assert tried(search(MIXED, effort, order), certified) == tried(
            search(MIXED, effort), certified
        )


def test_fast_takes_the_first_answer_and_no_other_once_certified() -> None:
    found = search(MIXED, "fast")
    found.first_answers()
    assert next_name(found) == "guess 1"
    assert found.next_candidate(3.1) is None


def test_normal_stops_where_two_agree_on_the_cheapest() -> None:
    same = [outcome(2.0), outcome(2.0 * (1 + 1e-5)), outcome(1.0, 3.0)]
    found = search(same, "normal")
    found.first_answers()
    assert next_name(found) == "guess 0"
    assert "guess 2" not in tried(search(same, "normal"), certified=5.0)
    # Two that agree on a dearer way are no reason to stop.
    cheaper = [outcome(1.0, 3.0), outcome(2.0), outcome(2.0), outcome(0.5, -3.0)]
    assert tried(search(cheaper, "normal"))[0] == "guess 3"


def test_thorough_waits_for_all() -> None:
    assert tried(search(MIXED, "thorough"))[0] == "guess 4"


def test_only_what_may_beat_the_plan_is_refined() -> None:
    assert tried(search(MIXED, "normal"), certified=2.05) == ["guess 4"]
    assert tried(search(MIXED, "thorough"), certified=2.05) == ["guess 4", "guess 2"]


def test_one_passage_is_refined_once() -> None:
    twice = [outcome(2.0, 0.0), outcome(2.2, 0.1), outcome(3.0, 2.0)]
    assert tried(search(twice, "thorough")) == ["guess 0", "guess 2"]


def test_a_mirror_image_is_refined_only_where_nothing_is_certified() -> None:
    mirrored = [outcome(2.0, 2.0), outcome(2.0, -2.0)]
    assert tried(search(mirrored, "thorough")) == ["guess 0", "guess 1"]
    found = search(mirrored, "thorough")
    found.first_answers()
    assert found.next_candidate(None) is not None
    assert found.next_candidate(9.0) is None


def test_guesses_are_solved_until_one_can_be_certified() -> None:
    found = search([outcome(2.0), outcome(None), outcome(3.0, 2.0)], "fast")
    found.first_answers()
    assert [next_name(found) for _ in range(2)] == ["guess 0", "guess 2"]
    assert found.next_candidate(None) is None


def test_a_solve_that_died_holds_nobody_up() -> None:
    assert tried(search([None, outcome(2.0)], "normal")) == ["guess 1"]


def test_past_the_deadline_nothing_more_is_solved() -> None:
    late = search(MIXED, "normal", deadline=time.monotonic() - 1.0)
    assert tried(late) == []
    assert isinstance(late.pool, Pool)
    assert late.pool.polls == 0


def test_no_guess_is_solved_where_those_solved_already_are_to_do() -> None:
    found = search([outcome(1.0), outcome(2.0, 3.0)], "fast")
    found.first_answers()
    assert next_name(found) == "guess 0"
    assert found.next_candidate(None, more=False) is None
    assert next_name(found) == "guess 1"
