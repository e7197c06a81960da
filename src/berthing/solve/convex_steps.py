"""Steps from a path that is clear to a motion that is, planes held meanwhile.

Each step is a convex problem: the equations linearised, every pair that is near held apart by the
plane that parts it best, every pose within a trust region. It neither jumps through walls nor
wanders, and it has no variables for planes, so that hundreds of pairs are no burden. What it gives
is a motion near a local optimum, in the passage of its start. Its order of convergence is one:
how planes turn as bodies move is left out.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy import sparse

from berthing.geometry.arrays import Array
from berthing.scenario.motion import Fixed
from berthing.scenario.scenario import Scenario
from berthing.solve.elastic_step import Linearised, Step, elastic_step
from berthing.solve.held_planes import Around, HeldPlanes
from berthing.solve.held_rows import held_rows
from berthing.solve.ipopt import Budget, Start
from berthing.solve.outcome import (
    ITERATION_LIMIT,
    LOCALLY_INFEASIBLE,
    SOLVED,
    TIME_LIMIT,
    Outcome,
)
from berthing.solve.restoration import Restoration
from berthing.solve.samples import Samples, spread_evenly
from berthing.transcription.elements import Index
from berthing.transcription.problem import Problem

PENALTY = 50.0
"""Of a unit of overlap at a node, against a cost of order one: above the multipliers seen."""

BETWEEN = 1
"""Samples between two points of the mesh."""

STIFFER, STIFFEST = 3.0, 1e4
"""Factor of the penalty where steps settle on an overlap, and the most that it may be."""

FIRST, LARGEST, LEAST = 0.1, 0.25, 1e-4
"""Trust region: of positions in lengths of the scenario, of quaternions."""

TURN = 0.3
"""That of quaternions in the first step, in which positions are free."""

ACCEPT, GOOD, GROW, SHRINK = 0.1, 0.7, 2.0, 0.3
"""Shares of the promised gain from which a step is taken, and the region grows; and the factors."""

LOOK = 0.25
"""Of the length: pairs nearer than this have rows in the first step."""

ROOM_M = 0.02
"""Pairs nearer than this have rows whatever the step before was."""

TILTED_M = 0.15
"""Pairs that keep more than this beyond their margin are held by planes that do not tilt."""

LEAST_TILT, TILT, TURNS = 0.02, 0.25, 2.0
"""Of normals that find further support points, rad: so many times the trust region of quaternions,
which is half the angle. At the least of it faces are found that nearly lie along each other: a body
that a step turns a little comes to touch with another corner, which had no row."""

SETTLED = 1e-2
"""A promised gain, as a share of the objective, that is not worth another step."""

MET_M = 1e-3
"""Overlap that an answer may have left: what is refined from it has none."""

STEPS = 30

CURVED = 1e-6
"""Least curvature: it holds what costs nothing."""

DEAR = 1.5
"""Price of an error of the equations, in the largest multiplier seen."""


@dataclass(frozen=True)
class _Point:
    """A motion, its values and what is near on it."""

    x: Array
    f: float
    g: Array
    around: Around


@dataclass(frozen=True)
class ConvexSteps:
    """A problem without separation rows, to be solved with them from as many starts as wanted.

    Attributes:
        fractions: (k,) of the phase at which pairs are held apart; spread evenly where None.
        region: trust region of the first step; positions are free in it where None.
        settled: promised gain, as a share of the objective, at which steps end.
        met_m: overlap that an answer may have left.
        mends: whether steps only take away overlaps, by the least change of states, whatever that
            costs: a step that gains moves other things closer.
    """

    problem: Problem
    budget: Budget
    fractions: Array | None = None
    region: float | None = None
    settled: float = SETTLED
    met_m: float = MET_M
    mends: bool = False

    def solve(self, scenario: Scenario, start: Start, *, backoff_m: float) -> Outcome:
        """Step from ``start`` until nothing is gained."""
        return _Run(self, scenario, start, backoff_m).run()

    @cached_property
    def samples(self) -> Samples:
        even = spread_evenly(self.problem.mesh, BETWEEN)
        return Samples(self.problem, even if self.fractions is None else self.fractions)

    @cached_property
    def bounded(self) -> Index:
        lower, upper = self.problem.layout.variables.bounds()
        return np.flatnonzero(np.isfinite(lower) | np.isfinite(upper))

    @cached_property
    def restoration(self) -> Restoration:
        return Restoration(self.problem, self.bounded)


def takes_steps(problem: Problem) -> bool:
    """Whether structures stand where they do whatever the variables are."""
    still = all(isinstance(own.motion, Fixed) for own in problem.scenario.structures)
    return still or not problem.phase.horizon.is_free


class _Run:
    """One solve."""

    def __init__(
        self, solver: ConvexSteps, scenario: Scenario, start: Start, backoff_m: float
    ) -> None:
        problem = solver.problem
        self.solver, self.problem, self.start = solver, problem, start
        self.began = time.perf_counter()
        self.planes = HeldPlanes(solver.samples, scenario, backoff_m)
        self.length_m = problem.layout.scale.length_m
        share = problem.mesh.point_count / len(solver.samples.fractions)
        self.penalty = PENALTY * min(share, 1.0)
        self.price = 1.0
        layout = problem.layout
        (row_lower, row_upper), (lower, upper) = layout.rows.bounds(), layout.variables.bounds()
        self.lower = np.concatenate([row_lower, lower[solver.bounded]])
        self.upper = np.concatenate([row_upper, upper[solver.bounded]])
        self.equal = self.lower == self.upper
        self.duration_s = start.motion.duration_s
        self.parameters = problem.parameter_vector(scenario, backoff_m, self.duration_s)
        self.evaluation = solver.restoration.evaluation
        self.evaluation.at(self.parameters)
        self.first = start.vector(problem, scenario)
        self.positions, self.turns = self._places()
        self.arm_m = max(own.vehicle.body.bounding_radius for own in layout.vehicles.values())
        self.multipliers = np.zeros(len(self.lower))

    def run(self) -> Outcome:
        region = self.solver.region
        share = LOOK if region is None else min(LOOK, region)
        at = self._point(self.first, ROOM_M + share * self.length_m)
        status, count = ITERATION_LIMIT, 0
        while count < min(self.solver.budget.iterations, STEPS):
            count += 1
            left = self.solver.budget.wall_time_s - (time.perf_counter() - self.began)
            if left <= 0.0:
                status = TIME_LIMIT
                break
            step = self._step(at, region, left)
            if step is None:
                if region is None:
                    break
                region *= SHRINK
            else:
                before, tried = at, region
                at, region = self._taken(at, step, region)
                grown = 1.0 if tried is None else max(region / tried, 1.0)
                if self._slow(before, at, step, grown):
                    if at.around.worst_m <= self.solver.met_m:
                        break
                    region = self._nearer(step, region)
            if region < LEAST:
                break
        if status == ITERATION_LIMIT:
            status = SOLVED if at.around.worst_m <= self.solver.met_m else LOCALLY_INFEASIBLE
        return self._outcome(at, status, count)

    def _slow(self, before: _Point, at: _Point, step: Step, grown: float) -> bool:
        """Whether the step promised, or brought, no more than is worth another one, which goes
        further by the factor ``grown``."""
        if self.solver.mends:
            return True
        enough = self.solver.settled * abs(at.f)
        brought = abs(at.f - before.f) if at.x is not before.x else np.inf
        return grown * min(abs(step.descent), brought) <= enough

    def _nearer(self, step: Step, region: float) -> float:
        """What takes away the overlap that is left: a higher price where the step left it on
        purpose; a smaller region where it did not know, for that is of second order in it."""
        if step.penalty > self.penalty * self.solver.met_m / self.length_m:
            self.penalty = min(STIFFER * self.penalty, STIFFEST)
            return region
        return SHRINK * region

    def _step(self, at: _Point, region: float | None, seconds: float) -> Step | None:
        tilt = TILT if region is None else float(np.clip(TURNS * region, LEAST_TILT, TILT))
        tilted_m = min(0.5 * at.around.reach_m, TILTED_M)
        held = held_rows(self.solver.samples, at.around, tilt, tilted_m)
        linearised = self._linearise(at)
        step = elastic_step(linearised, held, self.penalty, self._trust(region), seconds)
        if step is not None:
            self.multipliers = step.multipliers
            size = float(np.max(np.abs(self.multipliers[self.equal]), initial=0.0))
            self.price = max(self.price, DEAR * size)
        return step

    def _taken(self, at: _Point, step: Step, region: float | None) -> tuple[_Point, float]:
        """Where the step leads, or ``at`` where it gains too little; and the next region."""
        moved_m = self._moved(step.change)
        reach_m = ROOM_M + min(moved_m, LOOK * self.length_m)
        x = self.solver.restoration.restored(at.x + step.change, self.lower, self.equal)
        new = self._point(x, reach_m)
        if region is None:
            # A guess obeys no equations: there is nothing to compare with.
            return new, FIRST
        promised = self._merit(at) - at.f + step.descent - step.penalty
        gain = self._merit(at) - self._merit(new)
        if gain >= ACCEPT * promised:
            return new, min(GROW * region, LARGEST) if gain >= GOOD * promised else region
        near = self.planes.around(at.around.motion, reach_m)
        trusted = np.concatenate([self.positions, self.turns])
        return replace(at, around=near), SHRINK * min(
            region, float(np.max(np.abs(step.change[trusted])))
        )

    def _point(self, x: Array, reach_m: float) -> _Point:
        f, g = self.evaluation.value(x)
        f = 0.0 if self.solver.mends else f
        motion = self.problem.motion(x, self.duration_s)
        return _Point(x, f, g, self.planes.around(motion, reach_m))

    def _linearise(self, at: _Point) -> Linearised:
        evaluation = self.evaluation
        gradient, jacobian, hessian = evaluation.derivatives(at.x, np.zeros(len(self.lower)))
        # The diagonal is all of it where the horizon is fixed, for controls cost their squares.
        curvature = np.zeros(len(at.x))
        if self.solver.mends:
            gradient, curvature = np.zeros(len(at.x)), self.solver.restoration.weight
        else:
            rows, columns = (np.asarray(v) for v in evaluation.hessian.get_triplet())
            own = rows == columns
            curvature[rows[own]] = np.maximum(hessian[own], 0.0)
        pattern = tuple(np.asarray(v) for v in evaluation.jacobian.get_triplet())
        J = sparse.csr_matrix((jacobian, pattern), (len(self.lower), len(at.x)))
        return Linearised(gradient, curvature + CURVED, J, self.lower - at.g, self.upper - at.g)

    def _merit(self, at: _Point) -> float:
        off = at.g - np.clip(at.g, self.lower, self.upper)
        short = at.around.short_m / self.length_m
        return at.f + self.penalty * short + self.price * float(np.sum(np.abs(off)))

    def _places(self) -> tuple[Index, Index]:
        """Indices of the variables that are positions, and of the others that place bodies."""
        positions, turns = [np.empty(0, np.int64)], [np.empty(0, np.int64)]
        for own in self.problem.layout.vehicles.values():
            names = own.vehicle.model.state_names
            for column in own.pose_columns:
                kind = positions if names[column] in ("x_m", "y_m", "z_m") else turns
                kind.append(own.state.indices[column])
        return np.concatenate(positions), np.concatenate(turns)

    def _trust(self, region: float | None) -> Array:
        trust = np.full(len(self.first), np.inf)
        if region is not None:
            trust[self.positions] = region
        trust[self.turns] = TURN if region is None else region
        return trust

    def _moved(self, change: Array) -> float:
        """By how much no point of a body moves more."""
        root = float(np.sqrt(self.problem.phase.vehicles[0].dim))
        far = float(np.max(np.abs(change[self.positions]), initial=0.0))
        turn = float(np.max(np.abs(change[self.turns]), initial=0.0))
        return root * (far * self.length_m + 2.0 * turn * self.arm_m)

    def _outcome(self, at: _Point, status: str, count: int) -> Outcome:
        rows = self.problem.layout.rows.size
        bounds = np.zeros(len(at.x))
        bounds[self.solver.bounded] = self.multipliers[rows:]
        motion = at.around.motion
        return Outcome(
            status=status, x=at.x, multipliers=self.multipliers[:rows], bound_multipliers=bounds,
            parameters=self.parameters, motion=motion, cost=self.problem.cost(motion),
            iterations=count, wall_time_s=time.perf_counter() - self.began,
            worst_row=f"separation short by {max(at.around.worst_m, 0.0):.3g} m",
        )  # fmt: skip
