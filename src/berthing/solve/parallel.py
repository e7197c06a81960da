"""One solver, many guesses, side by side on the cores there are.

Each solve runs in a forked child, which inherits the solver built in the parent: nothing casadi
owns has to be pickled, and a child that must stop can be killed. Threads would not do: MUMPS keeps
state of its own in the process.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Iterator, Sequence
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from typing import Protocol

from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Start
from berthing.solve.outcome import Outcome


class Solves(Protocol):
    """A solver of one problem, ours or IPOPT."""

    def solve(self, scenario: Scenario, start: Start, *, backoff_m: float) -> Outcome:
        """The outcome from one start."""
        ...


def cores() -> int:
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else 1


class SolvePool:
    """Solves from many starts, in their order, at most so many at a time.

    Leaving the context kills what still runs. Where there is one core, or no fork, a poll solves
    one start itself.
    """

    def __init__(
        self, solver: Solves, scenario: Scenario, starts: Sequence[Start], backoff_m: float
    ) -> None:
        self._solver, self._scenario = solver, scenario
        self._starts, self._backoff_m = starts, backoff_m
        self._queue = list(range(len(starts)))
        self._running: dict[Connection, tuple[int, BaseProcess]] = {}

    def __enter__(self) -> SolvePool:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Kill what still runs."""
        for receiver, (_index, child) in self._running.items():
            child.kill()
            child.join()
            receiver.close()
        self._running.clear()

    @property
    def busy(self) -> bool:
        """Whether there is more to come."""
        return bool(self._queue or self._running)

    def poll(self, at_once: int, timeout_s: float | None) -> list[tuple[int, Outcome]]:
        """Keep ``at_once`` solves running and hand over those that have ended.

        Args:
            timeout_s: how long to wait for one to end; None waits as long as it takes.

        Returns:
            (index of the start, outcome); a child that died without an answer is left out.
        """
        if cores() < 2 or not hasattr(os, "fork"):
            return [self._solve_here()] if self._queue and timeout_s != 0.0 else []
        while self._queue and len(self._running) < at_once:
            self._launch(self._queue.pop(0))
        found = []
        for ready in wait(list(self._running), timeout_s):
            assert isinstance(ready, Connection)
            i, child = self._running.pop(ready)
            outcome = _received(ready)
            child.join()
            if outcome is not None:
                found.append((i, outcome))
        return found

    def _launch(self, i: int) -> None:
        context = multiprocessing.get_context("fork")
        receiver, sender = context.Pipe(duplex=False)
        arguments = (sender, self._solver, self._scenario, self._starts[i], self._backoff_m)
        child = context.Process(target=_child, args=arguments)
        child.start()
        sender.close()
        self._running[receiver] = (i, child)

    def _solve_here(self) -> tuple[int, Outcome]:
        i = self._queue.pop(0)
        start = self._starts[i]
        return i, self._solver.solve(self._scenario, start, backoff_m=self._backoff_m)


def solve_each(
    solver: Solves, scenario: Scenario, starts: Sequence[Start], backoff_m: float
) -> Iterator[tuple[int, Outcome]]:
    """Solve from every start as cores come free; yields (index, outcome) as they end.

    Closing the iterator kills what still runs.
    """
    with SolvePool(solver, scenario, starts, backoff_m) as pool:
        while pool.busy:
            yield from pool.poll(cores(), None)


def _received(receiver: Connection) -> Outcome | None:
    try:
        outcome = receiver.recv()
    except EOFError:
        return None
    finally:
        receiver.close()
    assert isinstance(outcome, Outcome)
    return outcome


def _child(
    sender: Connection, solver: Solves, scenario: Scenario, start: Start, backoff_m: float
) -> None:
    # Ctrl-C reaches the whole group; the parent alone decides what becomes of it.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    sender.send(solver.solve(scenario, start, backoff_m=backoff_m))
    sender.close()
