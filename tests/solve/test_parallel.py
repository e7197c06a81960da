"""Solves side by side: all of them are handed over, and none outlives its pool."""

from __future__ import annotations

import multiprocessing
import os
import time
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest

from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.scenario import Scenario
from berthing.solve import parallel
from berthing.solve.ipopt import Solver, Start
from berthing.solve.parallel import SolvePool, solve_each
from support.documents import puck, scenario, structure
from support.solving import BACKOFF_M, posed, start_of

POST = structure("post", [3, 0.1], {"type": "sphere", "radius_m": 0.6})
GIVEN: Scenario = scenario(puck(), structures=[POST])
LONG_S = 60.0


@pytest.fixture(scope="module")
def solver() -> Solver:
    return Solver.build(posed(GIVEN, 3, 3))


@pytest.fixture(autouse=True)
def two_cores(monkeypatch) -> Iterator[None]:
    monkeypatch.setattr(parallel, "cores", lambda: 2)
    yield
    assert multiprocessing.active_children() == []


def starts(solver: Solver, count: int) -> list[Start]:
    return [start_of(solver.problem, i) for i in range(count)]


def stuck(pair: int, a: Pose, b: Pose) -> Array:
    """Normals that never come."""
    time.sleep(LONG_S)
    return np.zeros(a.position.shape)


def fatal(pair: int, a: Pose, b: Pose) -> Array:
    """Normals that end the process."""
    os._exit(1)


def test_every_start_is_answered_as_it_would_be_alone(solver) -> None:
    given = starts(solver, 4)
    found = dict(solve_each(solver, GIVEN, given, BACKOFF_M))
    assert sorted(found) == [0, 1, 2, 3]
    for i, start in enumerate(given):
        alone = solver.solve(GIVEN, start, backoff_m=BACKOFF_M)
        assert found[i].status == alone.status
        np.testing.assert_allclose(found[i].x, alone.x, atol=1e-9)
    # The guesses are different ones, so that an answer in another's place would show.
    assert len({outcome.iterations for outcome in found.values()}) > 1


def test_closing_kills_what_still_runs(solver) -> None:
    first, *rest = starts(solver, 3)
    given = [first, *(replace(start, normals=stuck) for start in rest)]
    began = time.monotonic()
    answers = solve_each(solver, GIVEN, given, BACKOFF_M)
    assert next(answers)[0] == 0
    assert multiprocessing.active_children()
    answers.close()
    assert multiprocessing.active_children() == []
    assert time.monotonic() - began < 0.5 * LONG_S


def stumble(pool: SolvePool) -> None:
    """Uses a pool and fails."""
    with pool:
        assert pool.poll(2, 0.05) == []
        assert len(multiprocessing.active_children()) == 2
        raise RuntimeError("enough")


def test_an_error_in_the_loop_kills_them_too(solver) -> None:
    given = [replace(start, normals=stuck) for start in starts(solver, 2)]
    with pytest.raises(RuntimeError, match="enough"):
        stumble(SolvePool(solver, GIVEN, given, BACKOFF_M))
    assert multiprocessing.active_children() == []


def test_a_child_that_dies_is_left_out(solver) -> None:
    given = starts(solver, 3)
    given[1] = replace(given[1], normals=fatal)
    assert sorted(i for i, _ in solve_each(solver, GIVEN, given, BACKOFF_M)) == [0, 2]


def test_polling_keeps_no_more_than_asked_at_once(solver) -> None:
    given = [replace(start, normals=stuck) for start in starts(solver, 3)]
    with SolvePool(solver, GIVEN, given, BACKOFF_M) as pool:
        assert pool.poll(1, 0.0) == []
        assert len(multiprocessing.active_children()) == 1
        assert pool.poll(2, 0.0) == []
        assert len(multiprocessing.active_children()) == 2
        assert pool.busy
    assert not multiprocessing.active_children()


def test_on_one_core_a_waiting_poll_solves_here(solver, monkeypatch) -> None:
    monkeypatch.setattr(parallel, "cores", lambda: 1)
    with SolvePool(solver, GIVEN, starts(solver, 2), BACKOFF_M) as pool:
        assert pool.poll(1, 0.0) == []
        assert [i for i, _ in pool.poll(1, None)] == [0]
        assert pool.busy
        # A solve ends by its own budget: a limit of the poll's does not keep it from being begun.
        assert [i for i, _ in pool.poll(1, 1.0)] == [1]
        assert not pool.busy
    assert sorted(i for i, _ in solve_each(solver, GIVEN, starts(solver, 2), BACKOFF_M)) == [0, 1]


def test_nothing_to_solve_is_no_answer(solver) -> None:
    assert list(solve_each(solver, GIVEN, [], BACKOFF_M)) == []
