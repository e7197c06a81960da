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

from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Solver, Start
from berthing.solve.outcome import Outcome


def cores() -> int:
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else 1


def solve_each(
    solver: Solver, scenario: Scenario, starts: Sequence[Start], backoff_m: float
) -> Iterator[tuple[int, Outcome]]:
    """Solve from every start, in order as cores come free; yields (index, outcome) as they end.

    A child that dies without an answer is left out. Closing the iterator kills what still runs.
    """
    if cores() < 2 or len(starts) < 2 or not hasattr(os, "fork"):
        for i, start in enumerate(starts):
            yield i, solver.solve(scenario, start, backoff_m=backoff_m)
        return
    running: dict[Connection, tuple[int, BaseProcess]] = {}
    queue = list(range(len(starts)))
    try:
        while queue or running:
            while queue and len(running) < cores():
                i = queue.pop(0)
                receiver, child = _forked(solver, scenario, starts[i], backoff_m)
                running[receiver] = (i, child)
            for ready in wait(list(running)):
                assert isinstance(ready, Connection)
                i, child = running.pop(ready)
                outcome = _received(ready)
                child.join()
                if outcome is not None:
                    yield i, outcome
    finally:
        for _, child in running.values():
            child.kill()
            child.join()


def _forked(
    solver: Solver, scenario: Scenario, start: Start, backoff_m: float
) -> tuple[Connection, BaseProcess]:
    """A child at work on ``start``, and where its outcome will come from."""
    context = multiprocessing.get_context("fork")
    receiver, sender = context.Pipe(duplex=False)
    child = context.Process(target=_child, args=(sender, solver, scenario, start, backoff_m))
    child.start()
    # The child has its own copy: with ours closed, its death is the end of the stream.
    sender.close()
    return receiver, child


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
    sender: Connection, solver: Solver, scenario: Scenario, start: Start, backoff_m: float
) -> None:
    # Ctrl-C reaches the whole group; the parent alone decides what becomes of it.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    sender.send(solver.solve(scenario, start, backoff_m=backoff_m))
    sender.close()
