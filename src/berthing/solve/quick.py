"""Our own method first, IPOPT where it gets stuck: the same call, a fraction of the time."""

from __future__ import annotations

import time
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from berthing.geometry.arrays import Array
from berthing.proximity.formulation import Sweeping
from berthing.scenario.scenario import Scenario
from berthing.solve import interior_point
from berthing.solve.evaluation import Evaluation
from berthing.solve.interior_point import Found, InteriorPoint, Settings
from berthing.solve.ipopt import TOLERANCE, Answer, Budget, Solver, Start
from berthing.solve.outcome import ITERATION_LIMIT, NOT_CONVERGED, SOLVED, TIME_LIMIT, Outcome
from berthing.transcription.problem import Problem

BEGIN = {
    "cold": Settings(barrier=0.1),
    "near": Settings(barrier=1e-5, push=1e-4),
    "warm": Settings(barrier=1e-7, push=1e-7),
}
"""By preset: from a guess; from an answer on another mesh; from one with multipliers. With a
barrier of 1e-4 the second hops from one way through a corner to the next: ``offset-mass-wrench``
then took 14 rounds and was not certified, where 1e-5 takes six."""

ITERATIONS = 150
"""Of our own method; answers come in 30 to 80, or hardly ever."""

STATUS = {
    interior_point.SOLVED: SOLVED,
    interior_point.STUCK: NOT_CONVERGED,
    interior_point.ITERATIONS: ITERATION_LIMIT,
    interior_point.OUT_OF_TIME: TIME_LIMIT,
}


@dataclass(frozen=True)
class QuickSolver:
    """One problem with both its solvers, each built when it is first asked for.

    Attributes:
        preset: how starts are met: ``cold``, ``near`` or ``warm``.
        tolerance: of our own method; IPOPT's is its own.
        falls_back: whether IPOPT is asked where our own method finds nothing.
    """

    problem: Problem
    preset: str = "cold"
    budget: Budget = field(default_factory=Budget)
    tolerance: float = TOLERANCE
    falls_back: bool = True

    def allowed(self, preset: str, budget: Budget) -> QuickSolver:
        """The same solver, not built again, with another preset and budget."""
        other = replace(self, preset=preset, budget=budget)
        other.__dict__["own"] = self.own
        return other

    @property
    def quick(self) -> bool:
        """Whether our own method is for this problem: planes it is good at, while closest points
        with their complementarity take what IPOPT has for degenerate rows."""
        planes = all(isinstance(form, Sweeping) for form in self.problem.formulations)
        return planes and len(self.problem.homotopy) < 2

    @cached_property
    def own(self) -> InteriorPoint:
        """The interior-point method on this problem."""
        return InteriorPoint(*with_rows_alone(self.problem))

    @cached_property
    def ipopt(self) -> Solver:
        """IPOPT on this problem."""
        return Solver.build(self.problem, self.preset, self.budget)

    def solve(
        self,
        scenario: Scenario,
        start: Start,
        *,
        backoff_m: float,
        previous: Answer | None = None,
        eps: float | None = None,
    ) -> Outcome:
        """As ``Solver.solve``."""
        if start.patient or not self.quick:
            return self.ipopt.solve(
                scenario, start, backoff_m=backoff_m, previous=previous, eps=eps
            )
        began = time.perf_counter()
        problem, duration_s = self.problem, start.motion.duration_s
        parameters = problem.parameter_vector(scenario, backoff_m, duration_s, eps)
        x, multipliers = start.vector(problem, scenario, eps), None
        if previous is not None:
            carried = previous.carried(problem, x)
            x = carried["x0"]
            bounds = carried["lam_x0"][bounded_variables(problem)]
            multipliers = np.concatenate([carried["lam_g0"], bounds])
        settings = replace(
            BEGIN[self.preset], iterations=min(self.budget.iterations, ITERATIONS),
            seconds=self.budget.wall_time_s, tolerance=self.tolerance,
        )  # fmt: skip
        found = self.own.solve(x, parameters, settings, multipliers)
        spent = time.perf_counter() - began
        if found.status in (interior_point.SOLVED, interior_point.OUT_OF_TIME) or (
            not self.falls_back
        ):
            return self._outcome(found, parameters, duration_s, spent)
        outcome = self.ipopt.solve(scenario, start, backoff_m=backoff_m, previous=previous, eps=eps)
        return replace(
            outcome, iterations=outcome.iterations + found.iterations,
            wall_time_s=outcome.wall_time_s + spent,
        )  # fmt: skip

    def _outcome(self, found: Found, parameters: Array, duration_s: float, spent: float) -> Outcome:
        point = found.point
        outcome = outcome_of(self.problem, STATUS[found.status], point.x, point.y, parameters,
                             duration_s)  # fmt: skip
        return replace(
            outcome, iterations=found.iterations, wall_time_s=spent,
            worst_row=self.problem.layout.rows.worst(point.g[: self.problem.layout.rows.size]),
        )  # fmt: skip


def bounded_variables(problem: Problem) -> list[int]:
    """Those with bounds of their own."""
    below, above = problem.layout.variables.bounds()
    return [int(i) for i in np.flatnonzero(np.isfinite(below) | np.isfinite(above))]


def with_rows_alone(problem: Problem) -> tuple[Evaluation, Array, Array]:
    """The functions of ``problem``, bounded variables among the rows, and the rows' bounds."""
    lower, upper = problem.layout.rows.bounds()
    below, above = problem.layout.variables.bounds()
    bounded = bounded_variables(problem)
    return (
        Evaluation(problem.nlp, bounded),
        np.concatenate([lower, below[bounded]]),
        np.concatenate([upper, above[bounded]]),
    )


def outcome_of(
    problem: Problem, status: str, x: Array, y: Array, parameters: Array, duration_s: float
) -> Outcome:
    """The outcome at x (n,), with multipliers y of the rows and of bounded variables after them;
    what the solve took is left at zero."""
    rows = problem.layout.rows.size
    bound_multipliers = np.zeros(len(x))
    bound_multipliers[bounded_variables(problem)] = y[rows:]
    motion = problem.motion(x, duration_s)
    return Outcome(
        status=status,
        x=x,
        multipliers=y[:rows],
        bound_multipliers=bound_multipliers,
        parameters=parameters,
        motion=motion,
        cost=problem.cost(motion),
        iterations=0,
        wall_time_s=0.0,
        worst_row="",
    )
