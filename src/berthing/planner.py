"""The whole pipeline: scenario → guesses → coarse answers → refinement → certified plan."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass, field, replace
from functools import cached_property

from berthing import result as outcomes
from berthing.errors import InputError
from berthing.flight.flown import with_controls
from berthing.proximity.formulations import check_planned
from berthing.refine.begin_with import refine
from berthing.refine.curvature import second_order
from berthing.refine.first_answers import WAVES, Coarse, Wave
from berthing.refine.order import order_check
from berthing.refine.polish import polish
from berthing.refine.refiner import Finish, Refinement, Refiner, attempt
from berthing.refine.stepped import stepped
from berthing.refine.touching import FORMULATION, finished
from berthing.result import Attempt, ProgressEvent, Result
from berthing.scenario.options import POLYNOMIAL, SolverOptions
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Answer
from berthing.solve.outcome import ADVICE, Outcome
from berthing.transcription.kinks import kink_fractions, through
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Problem
from berthing.verify.endpoints import check_endpoints
from berthing.verify.extremal import Extremality, with_best_costates
from berthing.verify.observed_order import OrderCheck
from berthing.verify.second_order import SecondOrder
from berthing.verify.verification import verify, with_costates_of

DEGREE = 4
"""Collocated nodes a segment: ten segments of four beat one of forty in time and accuracy."""

COARSE_SEGMENTS, FINE_SEGMENTS = 10, 16

Progress = Callable[[ProgressEvent], None]


def plan(
    scenario: Scenario,
    *,
    options: SolverOptions | None = None,
    progress: Progress | None = None,
) -> Result:
    """Plan ``scenario`` from no guess and verify what comes out.

    Args:
        options: how to solve; the scenario's own where None.
        progress: is called with what is being done.

    Returns:
        The best certified plan; else the best uncertified one with what stands against it; else
        what was tried, with advice.

    Raises:
        InputError: an unknown formulation or scheme, or a start or goal that breaks a margin.
        CapabilityError: a shape that the formulation cannot take.
        KeyboardInterrupt: Ctrl-C; nothing is kept.
    """
    return plan_with_answer(scenario, options=options, progress=progress)[0]


def plan_with_answer(
    scenario: Scenario,
    *,
    options: SolverOptions | None = None,
    progress: Progress | None = None,
) -> tuple[Result, Answer | None]:
    """As ``plan``; and the solve that the plan came from, to go on from."""
    work = _Work(scenario, options or scenario.solver, progress or (lambda event: None))
    check_planned(work.options.formulation)
    with work.stage("check"):
        check_endpoints(scenario)
    best: Refinement | None = None
    for wave in WAVES:
        best = _from_guesses(work, wave, best)
        if work.is_done(best):
            break
    if best is not None and work.options.tolerance is not None:
        with work.stage("refine"):
            refiner = work.refiner()
            work.attempts += polish(refiner, "best", best, work.options.tolerance)
            if best.certified and best.answer is not None:
                work.order = order_check(refiner, "order", best.answer, work.attempts)
    if best is not None:
        with work.stage("optimality"):
            work.judge(best)
    if best is not None and work.options.controls != POLYNOMIAL:
        with work.stage("controls"):
            work.fly(best)
    return work.result(best), None if best is None else best.answer


@dataclass
class _Work:
    """One run of the pipeline."""

    scenario: Scenario
    options: SolverOptions
    progress: Progress
    attempts: list[Attempt] = field(default_factory=list)
    seconds: dict[str, float] = field(default_factory=dict)
    iterations: int = 0
    clearance_m: float | None = None
    began: float = field(default_factory=time.monotonic)
    order: OrderCheck | None = None
    extremality: Extremality | None = None
    second_order: SecondOrder | None = None

    @property
    def phase(self) -> Phase:
        if len(self.scenario.phases) != 1:
            count = len(self.scenario.phases)
            raise InputError("phases", f"are {count}", "one; several are not planned together yet")
        return self.scenario.phases[0]

    @property
    def smaller(self) -> list[str]:
        """Parts that are planned smaller than they are, in the order of the pairs."""
        pairs = self.scenario.pairs(self.phase)
        parts = [(p.ref_a, p.part_a) for p in pairs] + [(p.ref_b, p.part_b) for p in pairs]
        return list(dict.fromkeys(ref for ref, part in parts if part.planned_smaller))

    def is_done(self, best: Refinement | None) -> bool:
        """Whether ``best`` will do, or time is up; a thorough search goes through all waves."""
        certified = best is not None and best.certified and self.options.effort != "thorough"
        if certified or (self.smaller and best is not None and best.plan is not None):
            return True
        return time.monotonic() > self.deadline

    @property
    def deadline(self) -> float:
        return self.began + (self.options.time_limit_s or float("inf"))

    def stage(self, name: str) -> _Stage:
        self.tell(name)
        return _Stage(self, name)

    def tell(self, stage: str, detail: str = "") -> None:
        self.progress(ProgressEvent(stage, detail, self.iterations, self.clearance_m))

    def note(self, name: str, problem: Problem, outcome: Outcome) -> None:
        """Record a solve from a guess."""
        self.iterations += outcome.iterations
        self.attempts.append(attempt(name, problem, outcome))
        self.tell("guess", f"{name}: {outcome.status}")

    def mesh(self, segments: int) -> Mesh:
        """``segments`` of the default degree, or what the nodes asked for allow; and breaks where
        the dynamics have kinks."""
        plain = Mesh.of_nodes(self.options.scheme, self.options.nodes, segments, DEGREE)
        return through(plain, kink_fractions(self.phase))

    @cached_property
    def coarse(self) -> Coarse:
        """The coarse problem, whose solves are recorded here."""
        return Coarse(
            self.scenario, self.phase, self.mesh(COARSE_SEGMENTS), self.options, self.note,
            self.deadline,
        )  # fmt: skip

    def refiner(self, *, guarded: bool = False, slow: bool = False) -> Refiner:
        """A refiner that reports here."""

        def report(detail: str, iterations: int, clearance_m: float | None) -> None:
            self.iterations += iterations
            self.clearance_m = clearance_m
            self.tell("refine", detail)

        return Refiner(
            self.scenario, self.phase, self.mesh(FINE_SEGMENTS), self.options.formulation,
            self.options.seed, report, self.deadline, slow=slow, guarded=guarded,
            finish=self.finish,
        )  # fmt: skip

    @property
    def finish(self) -> Finish | None:
        """Rows at touches, for the form that they are for; to close in on touches, sites do."""
        plain = self.options.formulation == FORMULATION and self.options.tolerance is None
        return finished if plain and not self.smaller else None

    def judge(self, best: Refinement) -> None:
        """Give the plan the better of the costates at hand, and find how near it is to optimal;
        which multipliers tell that know of separation."""
        if best.stepped:
            return
        if best.plan is not None and best.verification is not None:
            best.plan, self.extremality = with_best_costates(self.scenario, best.plan)
            best.verification = with_costates_of(self.scenario, best.plan, best.verification)
        answer = best.finished or best.answer
        if answer is not None and answer.outcome is best.outcome:
            self.second_order = second_order(answer)

    def fly(self, best: Refinement) -> None:
        """In place of the plan the one that flies with the controls asked for, checked anew."""
        if best.plan is not None:
            kind, every = self.options.controls, self.options.sample_time_s
            best.plan = with_controls(self.scenario, best.plan, kind, every)
            best.verification = verify(self.scenario, best.plan)

    def result(self, best: Refinement | None) -> Result:
        attempts = tuple(self.attempts)
        self.seconds["total"] = time.monotonic() - self.began
        if best is None or best.plan is None or best.verification is None:
            outcome, advice = self._failure()
            return Result(outcome, None, None, attempts, advice)
        made = replace(best.plan, iterations=self.iterations, wall_time_s=dict(self.seconds))
        verification = best.verification
        if verification.certified:
            return self._shown(Result(outcomes.CERTIFIED, made, verification, attempts))
        outcome = outcomes.UNDECIDED if verification.undecided else outcomes.NOT_CERTIFIED
        advice = "try another --seed or more --nodes; "
        if self.options.controls != POLYNOMIAL:
            advice = "try a shorter --sample-time, or --controls polynomial; "
        if self.smaller:
            inside = ", ".join(self.smaller)
            advice = f"planned by models inside the shapes of {inside}: take exact or outer ones; "
        advice += "; ".join(verification.reasons[:3])
        return self._shown(Result(outcome, made, verification, attempts, advice))

    def _shown(self, result: Result) -> Result:
        """With what is known of its optimality; piecewise controls are the solver's no more."""
        if self.options.controls != POLYNOMIAL:
            return result
        return replace(
            result, extremality=self.extremality, order=self.order, second_order=self.second_order
        )

    def _failure(self) -> tuple[str, str]:
        """The commonest way in which the attempts failed, and what to try."""
        if time.monotonic() > self.deadline:
            return outcomes.TIME_LIMIT, ADVICE["time_limit"]
        known = [a.outcome for a in self.attempts if a.outcome in outcomes.OUTCOMES]
        outcome = max(known, key=known.count, default=outcomes.ITERATION_LIMIT)
        return outcome, ADVICE[outcome]


@dataclass
class _Stage:
    """Times a stage."""

    work: _Work
    name: str
    began: float = 0.0

    def __enter__(self) -> None:
        self.began = time.monotonic()

    def __exit__(self, *_: object) -> None:
        spent = time.monotonic() - self.began
        self.work.seconds[self.name] = self.work.seconds.get(self.name, 0.0) + spent


def _from_guesses(work: _Work, wave: Wave, best: Refinement | None) -> Refinement | None:
    """``best``, or what is better among the refined answers of a wave."""
    with work.stage("guess"):
        found = work.coarse.first(wave)
    if found is None:
        return best
    search, refiner = found.search, work.refiner(guarded=wave.patient, slow=found.slow)
    astray = False
    with closing(search.pool), work.stage("refine"):
        while (
            candidate := search.next_candidate(_certified_cost(best), more=not astray)
        ) is not None:
            name, answer = candidate
            further = stepped if wave.steps else refine
            refined = further(refiner, name, found.problem, answer.motion)
            work.attempts += refined.attempts
            # Where the coarse answer itself steps through things others will: share planes.
            astray = astray or (refined.astray and not refined.attempts)
            best = _better(best, refined)
            if time.monotonic() > work.deadline or (work.smaller and best.plan is not None):
                break
    return best


def _certified_cost(best: Refinement | None) -> float | None:
    return best.cost if best is not None and best.certified else None


def _better(best: Refinement | None, new: Refinement) -> Refinement:
    if best is None or best.plan is None:
        return new
    if new.plan is None:
        return best
    old_rank, new_rank = ((not r.certified, r.cost) for r in (best, new))
    return best if old_rank <= new_rank else new
