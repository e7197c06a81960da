"""Planning again while flying: from where things are, on what is left of the time.

The last certified plan is the start: its states, on its own mesh where the clock has not moved, on
what is left of it where it has. It is first solved with rows at its touches alone, a matter of
milliseconds; where that fails or does not do, with the rows of the last plan. What comes out is
verified like any plan; where it is not certified in time, the last certified plan goes on.
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
from berthing.refine.remaining import remaining, remaining_sites, shifted
from berthing.refine.touching import FORMULATION, Touched, Touching, touch_sites
from berthing.result import Result
from berthing.scenario.clock import begun_at
from berthing.scenario.margin import MarginPolicy
from berthing.scenario.options import POLYNOMIAL, SolverOptions
from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Answer, Budget, Start
from berthing.solve.quick import QuickSolver
from berthing.trajectory import Plan
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion, Problem, build
from berthing.transcription.sites import Site
from berthing.verify.endpoints import check_endpoints
from berthing.verify.verification import Verification, verify

ITERATIONS = 100
SWEEP_NODES = 0.42
"""Sites nearer than this many mean distances of nodes share planes, as in the refinement."""

TOUCHES, SITES = "touches", "sites"
"""Where rows stand."""

ALIKE = 0.01
"""By which costs of one plan with rows at sites and at touches may differ; where it is more, what
held the plan was no touch, and without it the answer is another."""

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
        seconds: what re-planning took; solving_s: the solves of it.
        iterations: of the solver.
        rows: where those of the last solve stood, ``touches`` or ``sites``; empty before any.
    """

    outcome: str
    begins_s: float
    scenario: Scenario
    plan: Plan
    verification: Verification
    seconds: float
    iterations: int
    solving_s: float = 0.0
    rows: str = ""

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
    """The last certified plan with what it came from.

    Attributes:
        mesh: of the plan; sites: where rows stand on it, where touches alone do not do.
        answer: the last solve with rows there, if there was one on this mesh.
        touched: the solve with rows at touches that the plan came from, if it did.
    """

    begins_s: float
    scenario: Scenario
    plan: Plan
    verification: Verification
    mesh: Mesh
    sites: tuple[Site, ...]
    answer: Answer | None
    touched: Touched | None = None

    @property
    def ends_s(self) -> float:
        return self.begins_s + self.plan.phases[0].t1_s

    def done(self, time_s: float) -> float:
        """The fraction of the plan that is over."""
        return (time_s - self.begins_s) / (self.ends_s - self.begins_s)


@dataclass
class _Spent:
    """What a call has spent on solves so far."""

    iterations: int = 0
    seconds: float = 0.0
    rows: str = ""

    def add(self, rows: str, iterations: int, seconds: float) -> None:
        self.rows = rows
        self.iterations += iterations
        self.seconds += seconds


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
        self._solver: tuple[Problem, QuickSolver] | None = None

    def plan(self) -> Result:
        """Plan from the scenario's own start, as ``berthing.plan`` does."""
        result, answer = plan_with_answer(self.scenario, options=self.options)
        if result.outcome == outcomes.CERTIFIED and answer is not None:
            assert result.plan is not None
            assert result.verification is not None
            problem = answer.problem
            made = _Certified(
                0.0, self.scenario, result.plan, result.verification, problem.mesh,
                problem.separation.sites, answer,
            )  # fmt: skip
            touched = self._with_rows_at_touches(self.scenario, 0.0, made)
            if touched is not None and abs(touched.outcome.cost / result.plan.cost - 1.0) < ALIKE:
                made = replace(made, touched=touched)
            self._last = made
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
            return self._result(last, INSIDE_MARGIN, began, _Spent())
        spent = _Spent()
        outcome, made = self._again(asked, time_s, last, began + deadline_s, spent)
        self._last = made or last
        return self._result(self._last, outcome, began, spent)

    def _result(self, kept: _Certified, outcome: str, began: float, spent: _Spent) -> Replanned:
        return Replanned(
            outcome, kept.begins_s, kept.scenario, kept.plan, kept.verification,
            time.monotonic() - began, spent.iterations, spent.seconds, spent.rows,
        )  # fmt: skip

    def _again(
        self, asked: Scenario, time_s: float, last: _Certified, deadline: float, spent: _Spent
    ) -> tuple[str, _Certified | None]:
        """With rows at the touches, and with the last plan's where that is not certified."""
        if time.monotonic() > deadline:
            return outcomes.TIME_LIMIT, None
        touched = self._with_rows_at_touches(asked, time_s, last)
        if touched is not None and time.monotonic() <= deadline:
            answer = touched.answer
            spent.add(TOUCHES, answer.outcome.iterations, answer.outcome.wall_time_s)
            made, found = self._checked(asked, answer)
            if found.certified:
                kept = self._on_its_mesh(time_s, last)
                return outcomes.CERTIFIED, replace(
                    kept, begins_s=time_s, scenario=asked, plan=made, verification=found,
                    touched=touched,
                )  # fmt: skip
        return self._with_rows_at_sites(asked, time_s, last, deadline, spent)

    def _checked(self, asked: Scenario, answer: Answer) -> tuple[Plan, Verification]:
        options = self.options
        made = make_plan(
            asked, answer.problem, answer.outcome, options.formulation, options.seed
        )
        return made, verify(asked, made)

    def _on_its_mesh(self, time_s: float, last: _Certified) -> _Certified:
        """``last`` with the mesh and sites that are left of it."""
        if time_s == last.begins_s:
            return last
        done = last.done(time_s)
        mesh = remaining(last.mesh, done)
        sites = remaining_sites(last.mesh, list(last.sites), mesh, done)
        return replace(last, mesh=mesh, sites=tuple(sites), answer=None)

    def _with_rows_at_touches(
        self, asked: Scenario, time_s: float, last: _Certified
    ) -> Touched | None:
        """From the last such solve where the clock has not moved, else from the plan."""
        if self.options.formulation != FORMULATION:
            return None
        if time_s == last.begins_s and last.touched is not None:
            return last.touched.touching.again(asked, last.touched)
        mesh, from_s = self._on_its_mesh(time_s, last).mesh, time_s - last.begins_s
        (flown,) = last.plan.phases
        touching = Touching.build(
            asked, asked.phases[0], mesh, touch_sites(last.scenario, flown, mesh, from_s)
        )
        return touching.first(asked, shifted(last.plan, mesh, from_s, flown.t1_s))

    def _with_rows_at_sites(
        self, asked: Scenario, time_s: float, last: _Certified, deadline: float, spent: _Spent
    ) -> tuple[str, _Certified | None]:
        """Solve, verify, and refine where that is not enough."""
        solver, motion, previous = self._ready(asked, time_s, last)
        left = deadline - time.monotonic()
        if left <= 0.0:
            return outcomes.TIME_LIMIT, None
        solver = solver.allowed("warm" if previous else "near", Budget(ITERATIONS, left))
        problem = solver.problem
        start = Start(motion, exact_normals(problem.pairs))
        outcome = solver.solve(asked, start, backoff_m=BACKOFF_M, previous=previous)
        spent.add(SITES, outcome.iterations, outcome.wall_time_s)
        if time.monotonic() > deadline:
            return outcomes.TIME_LIMIT, None
        if not outcome.solved:
            return outcome.status, None
        answer = Answer(problem, outcome)
        made, found = self._checked(asked, answer)
        if not found.certified and time.monotonic() < deadline:
            refined = self._refiner(asked, problem.mesh, deadline).follow("again", answer)
            for attempt in refined.attempts:
                spent.add(SITES, attempt.iterations, attempt.wall_time_s)
            if refined.certified and refined.answer is not None:
                assert refined.plan is not None
                assert refined.verification is not None
                made, found, answer = refined.plan, refined.verification, refined.answer
        if not found.certified:
            late = time.monotonic() > deadline
            return outcomes.TIME_LIMIT if late else outcomes.NOT_CERTIFIED, None
        sites = answer.problem.separation.sites
        return outcomes.CERTIFIED, _Certified(
            time_s, asked, made, found, answer.problem.mesh, sites, answer
        )

    def _refiner(self, asked: Scenario, mesh: Mesh, deadline: float) -> Refiner:
        return Refiner(
            asked, asked.phases[0], mesh, self.options.formulation, self.options.seed,
            lambda *_: None, deadline,
        )  # fmt: skip

    def _ready(
        self, asked: Scenario, time_s: float, last: _Certified
    ) -> tuple[QuickSolver, Motion, Answer | None]:
        """A solver for what is left, where to begin, and multipliers if the mesh is the same."""
        if time_s == last.begins_s and last.answer is not None:
            old = last.answer.problem
            if self._solver is None or self._solver[0] is not old:
                self._solver = (old, QuickSolver(old, "warm", falls_back=False))
            return self._solver[1], last.answer.outcome.motion, last.answer
        left = self._on_its_mesh(time_s, last)
        within = SWEEP_NODES / last.mesh.control_count / (1.0 - last.done(time_s))
        problem = build(
            asked, asked.phases[0], left.mesh, left.sites, self.options.formulation,
            sweep_within=within,
        )  # fmt: skip
        motion = shifted(
            last.plan, left.mesh, time_s - last.begins_s, last.ends_s - last.begins_s
        )
        return QuickSolver(problem, "near", falls_back=False), motion, None
