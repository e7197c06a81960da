"""Planning again while flying: from where things are, on what is left of the time.

The last certified plan is the start: its states, on its own mesh and rows where the clock has not
moved, on what is left of them where it has. What comes out is verified like any plan; where it is
not certified in time, the last certified plan goes on.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from berthing import result as outcomes
from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.guess.normals import exact_normals
from berthing.planner import plan_with_answer
from berthing.refine.refiner import BACKOFF_M, Refiner, make_plan
from berthing.result import Result
from berthing.scenario.clock import begun_at
from berthing.scenario.margin import MarginPolicy
from berthing.scenario.options import POLYNOMIAL, SolverOptions
from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Answer, Budget, Start
from berthing.solve.quick import QuickSolver
from berthing.trajectory import Plan
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion, build
from berthing.transcription.sites import Site
from berthing.verify.endpoints import check_endpoints
from berthing.verify.verification import Verification, verify

ITERATIONS = 100
SWEEP_NODES = 0.42
"""Sites nearer than this many mean distances of nodes share planes, as in the refinement."""

SLIVER = 0.3
"""A first segment shorter than this share of the next one is joined to it."""

INSIDE_MARGIN = "inside_margin"
"""Outcome where the vehicle is closer to something than its margin, yet apart from it."""


@dataclass(frozen=True)
class Replanned:
    """The plan to fly from now on.

    Attributes:
        outcome: ``certified`` where the plan is new; else why the last one goes on.
        begins_s: when the plan's own clock stood at zero, on the first scenario's clock.
        scenario: what the plan answers, on its own clock.
        plan, verification: certified, new or not.
        seconds: what re-planning took.
        iterations: of the solver.
    """

    outcome: str
    begins_s: float
    scenario: Scenario
    plan: Plan
    verification: Verification
    seconds: float
    iterations: int

    @property
    def fresh(self) -> bool:
        """Whether the plan was made by this call."""
        return self.outcome == outcomes.CERTIFIED

    def state(self, vehicle: str, time_s: float) -> Array:
        """Planned native state (nx,) at a time of the first scenario's clock."""
        own = self.plan.phases[0].vehicle(vehicle)
        return np.asarray(own.state(np.array([time_s - self.begins_s]))[0])

    def control(self, vehicle: str, time_s: float) -> Array:
        """Planned native control (nu,) at a time of the first scenario's clock."""
        own = self.plan.phases[0].vehicle(vehicle)
        return np.asarray(own.control(np.array([time_s - self.begins_s]))[0])


@dataclass(frozen=True)
class _Certified:
    """The last certified plan with the solve that it came from."""

    begins_s: float
    scenario: Scenario
    plan: Plan
    verification: Verification
    answer: Answer

    @property
    def ends_s(self) -> float:
        return self.begins_s + self.plan.phases[0].t1_s


class Planner:
    """One scenario, planned once and then again from wherever things are.

    Raises:
        InputError: controls are asked for that are not polynomials.

    >>> import berthing as bt
    >>> planner = bt.Planner(bt.load("free-space"))
    >>> flown = planner.plan().plan.phases[0].vehicle("spacecraft")
    >>> measured = flown.state(np.array([10.0]))[0]
    >>> planner.replan(measured, 10.0, deadline_s=60.0).outcome
    'certified'
    """

    def __init__(self, scenario: Scenario, *, options: SolverOptions | None = None) -> None:
        self.scenario = scenario
        self.options = options or scenario.solver
        if self.options.controls != POLYNOMIAL:
            raise InputError("controls", f"are {self.options.controls}", POLYNOMIAL)
        self._last: _Certified | None = None
        self._solver: tuple[float, QuickSolver] | None = None

    def plan(self) -> Result:
        """Plan from the scenario's own start, as ``berthing.plan`` does."""
        result, answer = plan_with_answer(self.scenario, options=self.options)
        if result.outcome == outcomes.CERTIFIED and answer is not None:
            assert result.plan is not None
            assert result.verification is not None
            self._keep(_Certified(0.0, self.scenario, result.plan, result.verification, answer))
        return result

    def replan(
        self,
        state: Mapping[str, Array] | Array,
        time_s: float,
        *,
        structures: Mapping[str, Pose] | None = None,
        deadline_s: float = float("inf"),
    ) -> Replanned:
        """Plan from ``state`` at ``time_s``.

        Args:
            state: native state (nx,) of each vehicle, or of the only one.
            time_s: on the scenario's clock; not before the last certified plan begins.
            structures: measured poses; the others are where their laws say.
            deadline_s: wall time; a step that has begun is finished. What is not certified by
                then is dropped.

        Returns:
            The new plan where it is certified, else the last certified one.

        Raises:
            InputError: nothing is certified yet; the time is not within the plan; a vehicle or
                structure is unknown; a vehicle is in collision; or something depends on the clock
                in a way that is not shifted.
        """
        began = time.monotonic()
        last = self._last
        if last is None:
            raise InputError("replan", "nothing is certified yet", "plan() first, certified")
        if not last.begins_s <= time_s < last.ends_s:
            expected = f"from {last.begins_s:g} s to before {last.ends_s:g} s"
            raise InputError("time_s", f"is {time_s:g}", expected)
        asked = begun_at(self.scenario, state, time_s, structures or {})
        check_endpoints(replace(asked, margins=MarginPolicy(0.0)))
        try:
            check_endpoints(asked)
        except InputError:
            return self._result(last, INSIDE_MARGIN, began, 0)
        outcome, iterations, made = self._again(asked, time_s, last, began + deadline_s)
        if made is not None:
            self._keep(made)
        assert self._last is not None
        return self._result(self._last, outcome, began, iterations)

    def _result(self, kept: _Certified, outcome: str, began: float, iterations: int) -> Replanned:
        return Replanned(
            outcome, kept.begins_s, kept.scenario, kept.plan, kept.verification,
            time.monotonic() - began, iterations,
        )  # fmt: skip

    def _keep(self, made: _Certified) -> None:
        self._last = made

    def _again(
        self, asked: Scenario, time_s: float, last: _Certified, deadline: float
    ) -> tuple[str, int, _Certified | None]:
        """Solve, verify, and refine where that is not enough."""
        solver, motion, previous = self._ready(asked, time_s, last)
        left = deadline - time.monotonic()
        if left <= 0.0:
            return outcomes.TIME_LIMIT, 0, None
        solver = solver.allowed("warm" if previous else "near", Budget(ITERATIONS, left))
        problem = solver.problem
        start = Start(motion, exact_normals(problem.pairs))
        outcome = solver.solve(asked, start, backoff_m=BACKOFF_M, previous=previous)
        iterations = outcome.iterations
        if time.monotonic() > deadline:
            return outcomes.TIME_LIMIT, iterations, None
        if not outcome.solved:
            return outcome.status, iterations, None
        answer = Answer(problem, outcome)
        made = make_plan(asked, problem, outcome, self.options.formulation, self.options.seed)
        found = verify(asked, made)
        if not found.certified and time.monotonic() < deadline:
            refined = self._refiner(asked, problem.mesh, deadline).follow("again", answer)
            iterations += sum(attempt.iterations for attempt in refined.attempts)
            if refined.certified and refined.answer is not None:
                assert refined.plan is not None
                assert refined.verification is not None
                made, found, answer = refined.plan, refined.verification, refined.answer
        if not found.certified:
            late = time.monotonic() > deadline
            return outcomes.TIME_LIMIT if late else outcomes.NOT_CERTIFIED, iterations, None
        return outcomes.CERTIFIED, iterations, _Certified(time_s, asked, made, found, answer)

    def _refiner(self, asked: Scenario, mesh: Mesh, deadline: float) -> Refiner:
        return Refiner(
            asked, asked.phases[0], mesh, self.options.formulation, self.options.seed,
            lambda *_: None, deadline,
        )  # fmt: skip

    def _ready(
        self, asked: Scenario, time_s: float, last: _Certified
    ) -> tuple[QuickSolver, Motion, Answer | None]:
        """A solver for what is left, where to begin, and multipliers if the mesh is the same."""
        old = last.answer.problem
        if time_s == last.begins_s:
            if self._solver is None or self._solver[1].problem is not old:
                self._solver = (time_s, QuickSolver(old, "warm", falls_back=False))
            return self._solver[1], last.answer.outcome.motion, last.answer
        done = (time_s - last.begins_s) / (last.ends_s - last.begins_s)
        mesh = remaining(old.mesh, done)
        sites = remaining_sites(old.mesh, list(old.separation.sites), mesh, done)
        within = SWEEP_NODES / old.mesh.control_count / (1.0 - done)
        problem = build(
            asked, asked.phases[0], mesh, sites, self.options.formulation, sweep_within=within
        )
        motion = shifted(last.plan, mesh, time_s - last.begins_s, last.ends_s - last.begins_s)
        return QuickSolver(problem, "near", falls_back=False), motion, None


def remaining(mesh: Mesh, done: float) -> Mesh:
    """The segments after the fraction ``done`` of the phase, as a mesh of their own."""
    later = [b for b in mesh.breaks if b > done]
    degrees = mesh.degrees[-len(later) :]
    if len(later) > 1 and later[0] - done < SLIVER * (later[1] - later[0]):
        later, degrees = later[1:], degrees[1:]
    breaks = [0.0, *((b - done) / (1.0 - done) for b in later[:-1]), 1.0]
    return Mesh(mesh.scheme, tuple(breaks), degrees)


def remaining_sites(old: Mesh, sites: list[Site], mesh: Mesh, done: float) -> list[Site]:
    """The sites after ``done``, at the same instants on the mesh that remains."""
    out = []
    for site in sites:
        at = (old.fraction(site.segment, site.s) - done) / (1.0 - done)
        if at > 0.0:
            segment, s = mesh.locate(min(at, 1.0))
            points = mesh.node_set(segment).points
            nearest = float(points[np.argmin(np.abs(points - s))])
            # What was a node of the old mesh is one of the new, but for rounding.
            s = nearest if abs(nearest - s) < 1e-9 else s
            out.append(Site(segment, s, site.pair))
    return sorted(set(out))


def shifted(plan: Plan, mesh: Mesh, from_s: float, to_s: float) -> Motion:
    """The plan's motion from one time of its clock to another, on ``mesh``."""
    (phase,) = plan.phases
    points = from_s + (to_s - from_s) * mesh.point_fractions()
    nodes = from_s + (to_s - from_s) * np.array(
        [mesh.fraction(k, float(s)) for k in range(mesh.segments)
         for s in mesh.node_set(k).control_points]
    )  # fmt: skip
    return Motion(
        to_s - from_s,
        {own.vehicle: own.state(points).T for own in phase.vehicles},
        {own.vehicle: own.control(nodes).T for own in phase.vehicles},
    )
