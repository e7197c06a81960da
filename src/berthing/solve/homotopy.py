"""A relaxed problem solved stage by stage, each from the last."""

from __future__ import annotations

from dataclasses import replace

from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Answer, Budget, Solver, Start
from berthing.solve.outcome import Outcome
from berthing.transcription.problem import Problem


def solve_by_stages(
    problem: Problem,
    scenario: Scenario,
    start: Start,
    *,
    preset: str,
    budget: Budget,
    backoff_m: float,
) -> Outcome:
    """Solve ``problem`` with each ε of its homotopy in turn.

    Relaxed rows overstate distances, so that no answer but the last stage's is one.

    Args:
        preset: how the first stage is solved; the others are warm.
        budget: of each stage.

    Returns:
        The last stage's outcome, or that of the first to fail; iterations and time are of all.
    """
    outcome: Outcome | None = None
    for eps in problem.homotopy:
        here, answer, spent = start, None, (0, 0.0)
        if outcome is not None:
            here, answer = Start(outcome.motion, start.normals), Answer(problem, outcome)
            spent = outcome.iterations, outcome.wall_time_s
        solver = Solver.build(problem, preset if answer is None else "warm", budget)
        new = solver.solve(scenario, here, backoff_m=backoff_m, previous=answer, eps=eps)
        outcome = replace(
            new, iterations=new.iterations + spent[0], wall_time_s=new.wall_time_s + spent[1]
        )
        if not new.solved:
            break
    assert outcome is not None
    return outcome
