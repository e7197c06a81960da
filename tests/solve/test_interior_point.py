"""Our own method: known optima, IPOPT's answers and multipliers, and what it must not claim."""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np
import pytest

from berthing.geometry.arrays import Array
from berthing.proximity.formulations import formulate
from berthing.solve import interior_point as method
from berthing.solve.barrier import Bounds, longest
from berthing.solve.evaluation import Evaluation
from berthing.solve.filter import Filter, Merit
from berthing.solve.interior_point import InteriorPoint, Settings
from berthing.solve.ipopt import Answer, Budget, Solver
from berthing.solve.outcome import NOT_CONVERGED
from berthing.solve.quick import QuickSolver
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Problem, build
from berthing.transcription.sites import node_sites
from support.documents import puck, scenario, structure
from support.solving import BACKOFF_M, posed, programme, start_of

POST = structure("post", [3, 0.1], {"type": "sphere", "radius_m": 0.6})
GIVEN = scenario(puck(), structures=[POST])


def solve(
    nlp: dict[str, Any], start: list[float], lower: list[float], upper: list[float],
    settings: Settings | None = None, bounded: tuple[int, ...] = (),
) -> method.Found:  # fmt: skip
    own = InteriorPoint(Evaluation(nlp, bounded), np.array(lower), np.array(upper))
    return own.solve(np.array(start, dtype=np.float64), np.zeros(0), settings or Settings())


def hock_schittkowski_71() -> dict[str, Any]:
    x = ca.MX.sym("x", 4)
    f = x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2]
    return programme(x, f, ca.vertcat(x[0] * x[1] * x[2] * x[3], ca.sumsqr(x)))


def test_a_known_optimum_with_its_multipliers() -> None:
    # Hock and Schittkowski, Test Examples for Nonlinear Programming Codes, problem 71.
    found = solve(
        hock_schittkowski_71(), [1, 5, 5, 1], [25, 40, 1, 1, 1, 1], [np.inf, 40, 5, 5, 5, 5],
        bounded=(0, 1, 2, 3),
    )  # fmt: skip
    assert found.status == method.SOLVED
    assert found.point.f == pytest.approx(17.0140173, abs=1e-6)
    assert found.point.x == pytest.approx([1.0, 4.7429994, 3.8211503, 1.3794082], abs=1e-6)
    # A lower bound that acts has a negative multiplier of f + yᵀ g.
    assert found.point.y[:2] == pytest.approx([-0.5522937, 0.1614686], abs=1e-6)
    assert found.point.y[2] == pytest.approx(-1.0878712, abs=1e-6)


def test_negative_curvature_is_left() -> None:
    x = ca.MX.sym("x", 1)
    found = solve(programme(x, -(x**2), x), [0.1], [-1], [2])
    assert found.status == method.SOLVED
    assert found.point.x[0] == pytest.approx(2.0, abs=1e-6)


def test_rows_that_exclude_each_other_are_never_solved() -> None:
    x = ca.MX.sym("x", 2)
    rows = ca.vertcat(ca.sumsqr(x), x[0] + x[1])
    found = solve(programme(x, ca.sumsqr(x), rows), [0.3, 0.2], [-np.inf, 5], [1, np.inf])
    assert found.status in (method.STUCK, method.ITERATIONS)
    assert np.max(np.abs(found.point.g - found.point.s)) > 1e-3


def test_iterations_and_time_run_out() -> None:
    problem = hock_schittkowski_71(), [1, 5, 5, 1], [25, 40], [np.inf, 40]
    assert solve(*problem, Settings(iterations=2)).status == method.ITERATIONS
    assert solve(*problem, Settings(seconds=-1.0)).status == method.OUT_OF_TIME


@pytest.fixture(scope="module")
def problem() -> Problem:
    return posed(GIVEN, 4, 4)


def test_same_answer_and_multipliers_as_ipopt(problem: Problem) -> None:
    start = start_of(problem, 1)
    ours = QuickSolver(problem).solve(problem.scenario, start, backoff_m=BACKOFF_M)
    theirs = Solver.build(problem).solve(problem.scenario, start, backoff_m=BACKOFF_M)
    assert ours.solved
    assert theirs.solved
    assert ours.cost == pytest.approx(theirs.cost, rel=1e-6)
    force, expected = (o.multipliers[list(problem.separation.rows)] for o in (ours, theirs))
    assert np.max(np.abs(expected)) > 0.0
    assert force == pytest.approx(expected, abs=1e-4 * np.max(np.abs(expected)))
    assert ours.worst_row.endswith("m") or "short by" in ours.worst_row


def test_an_answer_is_a_shorter_start(problem: Problem) -> None:
    start = start_of(problem, 1)
    first = QuickSolver(problem).solve(problem.scenario, start, backoff_m=BACKOFF_M)
    again = QuickSolver(problem, "warm").solve(
        problem.scenario, start, backoff_m=BACKOFF_M, previous=Answer(problem, first)
    )
    assert again.solved
    assert again.iterations < first.iterations / 2
    assert again.cost == pytest.approx(first.cost, rel=1e-6)


class Stuck:
    """Stands in for our own method: it never gets anywhere."""

    def __init__(self, rows: int) -> None:
        self.rows = rows

    def solve(self, x: Array, *_: object) -> method.Found:
        zero = np.zeros(self.rows)
        return method.Found(method.STUCK, method.Point(x, zero, zero, zero, 0.0, zero), 7, 1.0)


def test_ipopt_is_asked_where_our_own_method_is_stuck(
    problem: Problem, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(QuickSolver, "own", Stuck(problem.layout.rows.size))
    start = start_of(problem, 1)
    alone = QuickSolver(problem, falls_back=False)
    outcome = alone.solve(problem.scenario, start, backoff_m=BACKOFF_M)
    assert outcome.status == NOT_CONVERGED
    outcome = QuickSolver(problem).solve(problem.scenario, start, backoff_m=BACKOFF_M)
    assert outcome.solved
    assert outcome.iterations > 7


def test_closest_points_are_left_to_ipopt(problem: Problem) -> None:
    assert QuickSolver(problem).quick
    phase, mesh = GIVEN.phases[0], Mesh.uniform("lgr", 2, 3)
    other = build(GIVEN, phase, mesh, node_sites(mesh, 1), "kkt")
    assert not QuickSolver(other).quick
    assert formulate("kkt", *(part.shape for part in parts(problem))).variables


def parts(problem: Problem) -> tuple[Any, Any]:
    return problem.pairs[0].part_a, problem.pairs[0].part_b


def test_the_budget_is_kept(problem: Problem) -> None:
    quick = QuickSolver(problem, budget=Budget(3), falls_back=False)
    outcome = quick.solve(problem.scenario, start_of(problem, 1), backoff_m=BACKOFF_M)
    assert outcome.status == "iteration_limit"
    assert outcome.iterations == 3


def test_a_step_keeps_off_its_bounds() -> None:
    assert longest(np.array([1.0, 2.0]), np.array([1.0, -4.0]), 0.99) == pytest.approx(0.495)
    assert longest(np.array([1.0, 2.0]), np.array([1.0, 0.0]), 0.99) == 1.0


def test_slacks_begin_inside() -> None:
    bounds = Bounds.of(np.array([0.0, -np.inf, 1.0, 0.0]), np.array([np.inf, 3.0, 1.0, 1e-3]))
    for outside in ([-5.0, 9.0, 7.0, 0.5], [0.0, 3.0, 0.0, -0.5]):
        s = bounds.inside(np.array(outside))
        assert np.all(bounds.distance(s) > 0.0)
        assert s[2] == 1.0


def test_the_filter_refuses_what_is_worse_in_both() -> None:
    filter_ = Filter(1.0)
    here = Merit(1.0, 1.0)
    assert not filter_.takes(here, Merit(1.1, 1.1), 1.0, 0.1)
    assert not filter_.takes(here, Merit(np.nan, 0.0), 1.0, 0.1)
    assert filter_.takes(here, Merit(0.5, 2.0), 1.0, 0.1)
    # What was left is shut out from now on.
    assert not filter_.admits(Merit(1.0, 1.0))
    assert filter_.admits(Merit(0.9, 5.0))
