"""Steps in a trust region with the signed distance linearised anew at each.

Dynamics, limits and ends stay exact in every step, where sequential convex planners linearise
them too: what is compared is how the distance is treated.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import casadi as ca
import numpy as np

from berthing.geometry.arrays import Array
from berthing.proximity.linearised import LinearisedFormulation
from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Budget, Solver, Start
from berthing.solve.outcome import LOCALLY_INFEASIBLE, SOLVED, TIME_LIMIT, Outcome
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Problem, build
from berthing.transcription.sites import node_sites

NAME = "signed-distance-sequential"

PENALTY = 100.0
"""Of a unit of slack, against a cost of order one: well above the multipliers seen."""

FIRST_STEP, LEAST_STEP, LARGEST_STEP = 0.2, 1e-4, 1.0
"""How far positions may move in a step, as a share of the scenario's length; quaternions alike."""

ACCEPT, EXPAND, SHRINK = 0.1, 2.0, 0.4
"""The share of the promised gain that a step must bring, and what becomes of the region."""

STEPS = 40

SETTLED = 1e-6
"""A promised gain, against a cost of order one, that is not worth another step."""

MET = 1e-5
"""Overlap, in the unit of the separation rows, that counts as none."""


def linearised(scenario: Scenario, mesh: Mesh) -> Problem:
    """The problem of one phase with its distances linearised at every node."""
    (phase,) = scenario.phases
    sites = node_sites(mesh, len(scenario.pairs(phase)))
    return build(scenario, phase, mesh, sites, NAME, regulariser=PENALTY * max(len(sites), 1))


@dataclass(frozen=True)
class _Point:
    """Where the steps have come to: its merit is cost and penalised overlap, scaled."""

    outcome: Outcome
    merit: float
    overlap: float


class SequentialSolver:
    """A ``linearised`` problem with its solver, built once and called many times."""

    def __init__(self, problem: Problem, budget: Budget) -> None:
        self.problem, self.budget = problem, budget
        self.solver = Solver.build(problem, "cold", budget)
        x, p, g = (problem.nlp[key] for key in "xpg")
        self.rows: Any = ca.Function("rows", [x, p], [g])
        blocks = [problem.layout.variables.blocks[name] for name in problem.separation.blocks]
        forms = problem.formulations
        size = max((f.held for f in forms if isinstance(f, LinearisedFormulation)), default=0)
        self.held = np.array([b.indices.ravel()[:size] for b in blocks], dtype=int).ravel()
        self.slack = np.array([b.indices.ravel()[-1] for b in blocks], dtype=int)
        vehicles = problem.layout.vehicles.values()
        moving = [v.state.indices[list(v.pose_columns)].ravel() for v in vehicles]
        self.moving = np.concatenate(moving)

    def solve(self, scenario: Scenario, start: Start, *, backoff_m: float) -> Outcome:
        """Step from ``start`` until nothing is gained.

        The first step is not bounded, for a guess obeys no dynamics.

        Returns:
            The last step taken; solved only where nothing overlaps. Iterations and time are of all.
        """
        here, step = start, FIRST_STEP
        at: _Point | None = None
        iterations, seconds = 0, 0.0
        for _ in range(STEPS):
            bounds = self._bounds(scenario, here, None if at is None else step)
            outcome = self.solver.solve(scenario, here, backoff_m=backoff_m, bounds=bounds)
            iterations, seconds = iterations + outcome.iterations, seconds + outcome.wall_time_s
            if at is None:
                at = self._point(scenario, outcome, start)
                if not outcome.solved:
                    break
                promised = np.inf
            else:
                promised = at.merit - self._model(outcome)
                new = self._point(scenario, outcome, start)
                if outcome.solved and at.merit - new.merit >= ACCEPT * promised > 0.0:
                    at, step = new, min(step * EXPAND, LARGEST_STEP)
                else:
                    step *= SHRINK
            here = Start(at.outcome.motion, start.normals)
            if promised < SETTLED or step < LEAST_STEP or seconds > self.budget.wall_time_s:
                break
        assert at is not None
        status = at.outcome.status
        if at.outcome.solved:
            status = SOLVED if at.overlap <= MET else LOCALLY_INFEASIBLE
        if seconds > self.budget.wall_time_s:
            status = TIME_LIMIT
        return replace(at.outcome, status=status, iterations=iterations, wall_time_s=seconds)

    def _bounds(self, scenario: Scenario, here: Start, step: float | None) -> tuple[Array, Array]:
        """Normals and points held where ``here`` puts them; poses within ``step`` of it."""
        lower, upper = (bound.copy() for bound in self.problem.layout.variables.bounds())
        x = here.vector(self.problem, scenario)
        lower[self.held] = upper[self.held] = x[self.held]
        if step is not None:
            at = x[self.moving]
            lower[self.moving] = np.maximum(lower[self.moving], at - step)
            upper[self.moving] = np.minimum(upper[self.moving], at + step)
        return lower, upper

    def _model(self, outcome: Outcome) -> float:
        """The merit as the linearised distances have it."""
        scaled = outcome.cost / self.problem.layout.scale.cost
        return scaled + PENALTY * float(np.sum(outcome.x[self.slack]))

    def _point(self, scenario: Scenario, outcome: Outcome, start: Start) -> _Point:
        """The merit with exact signed distances: the linearised ones, taken there."""
        x = Start(outcome.motion, start.normals).vector(self.problem, scenario)
        rows = np.asarray(self.rows(x, outcome.parameters)).ravel()
        gaps = rows[list(self.problem.separation.rows)]
        overlap = np.maximum(-gaps, 0.0)
        scaled = outcome.cost / self.problem.layout.scale.cost
        merit = scaled + PENALTY * float(np.sum(overlap))
        return _Point(outcome, merit, float(np.max(overlap, initial=0.0)))
