"""The solver's call: what its statuses mean, and what a solve may spend."""

from __future__ import annotations

import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest

from berthing.solve.ipopt import PRESETS, Answer, Budget, Solver
from berthing.solve.outcome import ADVICE, STATUS, Outcome
from berthing.transcription.problem import Problem
from berthing.transcription.sites import Site
from support.documents import puck, scenario, structure
from support.solving import BACKOFF_M, guessed, posed, start_of

POST = structure("post", [3, 0.1], {"type": "sphere", "radius_m": 0.6})
GIVEN = scenario(puck(), structures=[POST])


@pytest.fixture(scope="module")
def problem() -> Problem:
    return posed(GIVEN, 4, 4)


def solve(problem: Problem, *, preset: str = "cold", budget: Budget | None = None) -> Outcome:
    solver = Solver.build(problem, preset, budget)
    return solver.solve(problem.scenario, start_of(problem, 1), backoff_m=BACKOFF_M)


@pytest.fixture(scope="module")
def outcome(problem) -> Outcome:
    return solve(problem)


class Canned:
    """Stands in for IPOPT: the answer is the start, the status is as told."""

    def __init__(self, problem: Problem, status: str) -> None:
        self.rows, self.status = problem.layout.rows.size, status

    def __call__(self, **arguments: Any) -> dict[str, Any]:
        x = ca.DM(arguments["x0"])
        return {
            "x": x,
            "g": ca.DM.zeros(self.rows),
            "lam_x": 0 * x,
            "lam_g": ca.DM.zeros(self.rows),
        }

    def stats(self) -> dict[str, Any]:
        return {"return_status": self.status, "iter_count": 7}


def canned(problem: Problem, status: str) -> Outcome:
    solver = Solver(problem, Canned(problem, status), 0.0)
    return solver.solve(GIVEN, start_of(problem), backoff_m=BACKOFF_M)


STATUSES = {
    "Solve_Succeeded": "solved",
    "Solved_To_Acceptable_Level": "not_converged",
    "Infeasible_Problem_Detected": "locally_infeasible",
    "Maximum_Iterations_Exceeded": "iteration_limit",
    "Maximum_WallTime_Exceeded": "time_limit",
    "Maximum_CpuTime_Exceeded": "time_limit",
    "Restoration_Failed": "not_converged",
    "Search_Direction_Becomes_Too_Small": "not_converged",
    "Diverging_Iterates": "not_converged",
    "Invalid_Number_Detected": "not_converged",
    "Feasible_Point_Found": "not_converged",
}


@pytest.mark.parametrize(("status", "expected"), STATUSES.items())
def test_only_success_counts_as_solved(problem, status, expected) -> None:
    outcome = canned(problem, status)
    assert outcome.status == expected
    assert outcome.solved == (status == "Solve_Succeeded")
    assert bool(outcome.advice) != outcome.solved
    assert outcome.iterations == 7


def test_every_status_has_advice() -> None:
    assert set(STATUS.values()) <= set(ADVICE)
    assert [status for status, advice in ADVICE.items() if not advice] == ["solved"]


@pytest.mark.parametrize("status", ["User_Requested_Stop", "NonIpopt_Exception_Thrown"])
def test_an_interrupt_that_ipopt_swallowed_is_raised_again(problem, status) -> None:
    with pytest.raises(KeyboardInterrupt):
        canned(problem, status)


SCRIPT = """
import os, subprocess
from support.documents import puck, scenario, structure
from support.solving import posed, start_of
from berthing.solve.ipopt import Solver

post = structure("post", [3, 0.1], {"type": "sphere", "radius_m": 0.6})
given = scenario(puck(), structures=[post])
problem = posed(given, 60, 4)
solver, start = Solver.build(problem), start_of(problem, 1)
# From outside, as a terminal does: a thread of our own would wait for the solve to return.
subprocess.Popen(["sh", "-c", f"sleep 0.5; kill -INT {os.getpid()}"])
try:
    while True:
        solver.solve(given, start, backoff_m=1e-3)
except KeyboardInterrupt:
    print("interrupted")
"""


def test_ctrl_c_ends_a_real_solve() -> None:
    root = Path(__file__).parents[2]
    run = subprocess.run(
        [sys.executable, "-c", SCRIPT], capture_output=True, text=True, timeout=60, check=False,
        env={"PYTHONPATH": f"{root / 'src'}:{root / 'tests'}"},
    )  # fmt: skip
    assert run.stdout.strip().splitlines()[-1:] == ["interrupted"], run.stderr


def test_iterations_are_bounded(problem) -> None:
    stopped = solve(problem, budget=Budget(iterations=3))
    assert (stopped.status, stopped.iterations) == ("iteration_limit", 3)
    assert "short by" in stopped.worst_row
    assert not stopped.worst_row.endswith("short by 0")


def test_time_is_bounded(problem) -> None:
    assert solve(problem, budget=Budget(wall_time_s=1e-4)).status == "time_limit"


def test_a_goal_inside_a_wall_is_infeasible() -> None:
    wall = structure("wall", [7.5, 0], {"type": "box", "size_m": [2, 4]})
    closed = posed(scenario(puck(), structures=[wall], margin_m=0.3), 2, 3)
    outcome = Solver.build(closed).solve(closed.scenario, start_of(closed), backoff_m=BACKOFF_M)
    assert outcome.status == "locally_infeasible"
    assert "short by" in outcome.worst_row


def test_an_outcome_says_it_in_physical_units_and_crosses_processes(problem, outcome) -> None:
    assert outcome.solved
    assert outcome.cost == pytest.approx(problem.cost(outcome.motion), rel=1e-12)
    np.testing.assert_allclose(outcome.motion.states["puck"][:2, -1], [6.0, 0.0], atol=1e-9)
    copy = pickle.loads(pickle.dumps(outcome))
    np.testing.assert_array_equal(copy.x, outcome.x)
    assert outcome.wall_time_s > 0.0


def test_the_answer_keeps_its_rows_and_has_no_gradient_left(problem, outcome) -> None:
    nlp, x, p = problem.nlp, outcome.x, outcome.parameters
    g, jacobian = nlp["jac_g"](x, p)
    lower, upper = problem.layout.rows.bounds()
    values = np.asarray(g).ravel()
    assert np.all(values >= lower - 1e-8)
    assert np.all(values <= upper + 1e-8)
    slope = nlp["grad_f"](x, p)[1] + ca.mtimes(jacobian.T, outcome.multipliers)
    assert np.max(np.abs(np.asarray(slope).ravel() + outcome.bound_multipliers)) < 1e-6
    # At the guess neither holds.
    start = start_of(problem, 0).vector(problem, GIVEN)
    assert np.max(np.abs(np.asarray(nlp["jac_g"](start, p)[0]).ravel() - values)) > 0.1


@pytest.mark.parametrize("preset", PRESETS)
def test_every_preset_solves_from_the_answer(problem, outcome, preset) -> None:
    solver = Solver.build(problem, preset)
    start = start_of(problem)
    again = solver.solve(GIVEN, start, backoff_m=BACKOFF_M, previous=Answer(problem, outcome))
    assert again.solved
    assert again.cost == pytest.approx(outcome.cost, rel=1e-5)


def test_multipliers_make_the_second_solve_short(problem, outcome) -> None:
    warm = Solver.build(problem, "warm").solve(
        GIVEN, start_of(problem), backoff_m=BACKOFF_M, previous=Answer(problem, outcome)
    )
    assert warm.iterations <= 5
    assert warm.iterations < outcome.iterations / 2


def test_multipliers_are_carried_to_a_problem_with_more_rows(problem, outcome) -> None:
    sites = sorted([*problem.separation.sites, Site(0, 0.6, 0), Site(3, 0.4, 0)])
    more = posed(GIVEN, 4, 4, sites)
    start = start_of(more, 1)
    x0 = start.vector(more, GIVEN)
    carried = Answer(problem, outcome).carried(more, x0)
    names = problem.layout.variables.split(outcome.x)
    for name, value in more.layout.variables.split(carried["x0"]).items():
        if name in names:
            np.testing.assert_allclose(value, names[name], atol=1e-12)
    assert len(more.layout.variables.blocks) == len(names) + 4
    # Each old row keeps its multiplier, wherever it now stands; new ones have none.
    for site, row in zip(problem.separation.sites, problem.separation.rows, strict=True):
        there = more.separation.rows[more.separation.sites.index(site)]
        assert carried["lam_g0"][there] == outcome.multipliers[row]
    new = more.separation.rows[more.separation.sites.index(Site(0, 0.6, 0))]
    assert carried["lam_g0"][new] == 0.0
    solver = Solver.build(more, "warm")
    again = solver.solve(GIVEN, start, backoff_m=BACKOFF_M, previous=Answer(problem, outcome))
    assert again.solved
    assert again.cost >= outcome.cost * (1.0 - 1e-6)


def test_the_guess_itself_is_not_changed_by_solving(problem) -> None:
    motion = guessed(problem, 1)
    before = motion.states["puck"].copy()
    solve(problem, budget=Budget(iterations=2))
    np.testing.assert_array_equal(guessed(problem, 1).states["puck"], before)
