"""The whole pipeline: scenario → guesses → coarse answers → refinement → certified plan."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from berthing import result as outcomes
from berthing.errors import InputError
from berthing.guess.continuation import Continuation
from berthing.guess.first_motions import first_motions
from berthing.guess.normals import exact_normals
from berthing.refine.begin_with import beginning, refine
from berthing.refine.refiner import BACKOFF_M, Refinement, Refiner, attempt
from berthing.result import Attempt, ProgressEvent, Result
from berthing.scenario.options import SolverOptions
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Budget, Solver, Start
from berthing.solve.outcome import ADVICE, Outcome
from berthing.solve.parallel import SolvePool, cores
from berthing.transcription.kinks import kink_fractions, through
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion, Problem, build
from berthing.transcription.sites import node_sites
from berthing.verify.endpoints import check_endpoints

DEGREE = 4
"""Collocated nodes a segment: ten segments of four beat one of forty in time and accuracy."""

COARSE_SEGMENTS, FINE_SEGMENTS = 10, 16

COARSE_ITERATIONS = 150
"""Guesses that lead anywhere converge in 40 to 110; the rest wander."""

ENOUGH = 6
"""Guesses solved before the search for more passages ends."""

WORTH_TRYING = 0.97
"""A further candidate is refined only if its coarse cost, which understates, is below this share
of the best certified one."""

PATIENCE = 2.5
"""Times as long as the first answer took: how long more answers are waited for before refining."""

SAME_PASSAGE = 0.25
"""Coarse answers nearer than this share of the scenario's length are one and the same."""

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
    work = _Work(scenario, options or scenario.solver, progress or (lambda event: None))
    with work.stage("check"):
        check_endpoints(scenario)
    with work.stage("guess"):
        search = _search(work)
    best: Refinement | None = None
    with search.pool:
        with work.stage("guess"):
            search.first_answers()
        with work.stage("refine"):
            # Further guesses are solved on the other core meanwhile.
            while (candidate := search.next_candidate(best)) is not None:
                refined = refine(work.refiner(search.poll), *candidate)
                work.attempts += refined.attempts
                best = _better(best, refined)
                if time.monotonic() > work.deadline or (work.smaller and best.plan is not None):
                    break
            if best is not None and work.options.tolerance is not None:
                polished = work.refiner(search.poll).polish("best", best, work.options.tolerance)
                work.attempts += polished
    return work.result(best)


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

    def refiner(self, meanwhile: Callable[[], None]) -> Refiner:
        """A refiner that calls ``meanwhile`` after every round."""

        def report(detail: str, iterations: int, clearance_m: float | None) -> None:
            self.iterations += iterations
            self.clearance_m = clearance_m
            self.tell("refine", detail)
            meanwhile()

        return Refiner(
            self.scenario, self.phase, self.mesh(FINE_SEGMENTS), self.options.formulation,
            self.options.seed, report, self.deadline,
        )  # fmt: skip

    def result(self, best: Refinement | None) -> Result:
        attempts = tuple(self.attempts)
        self.seconds["total"] = time.monotonic() - self.began
        if best is None or best.plan is None or best.verification is None:
            outcome, advice = self._failure()
            return Result(outcome, None, None, attempts, advice)
        made = replace(best.plan, iterations=self.iterations, wall_time_s=dict(self.seconds))
        verification = best.verification
        if verification.certified:
            return Result(outcomes.CERTIFIED, made, verification, attempts)
        outcome = outcomes.UNDECIDED if verification.undecided else outcomes.NOT_CERTIFIED
        advice = "try another --seed or more --nodes; "
        if self.smaller:
            inside = ", ".join(self.smaller)
            advice = f"planned by models inside the shapes of {inside}: take exact or outer ones; "
        advice += "; ".join(verification.reasons[:3])
        return Result(outcome, made, verification, attempts, advice)

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


def _search(work: _Work) -> _Search:
    """The coarse problem and its guesses, ready to be solved."""
    scenario, phase = work.scenario, work.phase
    mesh = work.mesh(COARSE_SEGMENTS)
    pairs = scenario.pairs(phase)
    sites = node_sites(mesh, len(pairs))
    first, normals = beginning(work.options.formulation, pairs), exact_normals(pairs)
    problem = build(scenario, phase, mesh, sites, first.formulation, shapes_of=first.shapes_of)
    budget = Budget(COARSE_ITERATIONS, min(work.deadline - time.monotonic(), 1e6))
    solver = Solver.build(problem, "cold", budget)
    whole = Continuation(
        scenario, phase, mesh, first.formulation, budget, BACKOFF_M, work.note, first.shapes_of
    )
    motions = first_motions(work.options.guess, whole, work.options.seed)
    starts = [Start(motion, normals) for _, motion in motions]
    pool = SolvePool(solver, scenario, starts, BACKOFF_M)
    return _Search(work, problem, [name for name, _ in motions], pool)


@dataclass
class _Search:
    """Coarse answers as they come in, and which of them to refine next."""

    work: _Work
    problem: Problem
    guesses: list[str]
    pool: SolvePool
    found: list[tuple[str, Outcome]] = field(default_factory=list)
    tried: list[Outcome] = field(default_factory=list)

    def first_answers(self) -> None:
        """Solve guesses until a few have answers, or the first of them has had time for more."""
        began, patience = time.monotonic(), float("inf")
        while self.pool.busy and len(self.found) < ENOUGH:
            self._take(self.pool.poll(cores(), max(began + patience - time.monotonic(), 0.0)
                                      if self.found else None))  # fmt: skip
            spent = time.monotonic() - began
            if self.found and patience == float("inf"):
                patience = spent * PATIENCE
            if spent >= patience:
                return

    def poll(self) -> None:
        """Keep one core on the guesses that are left."""
        self._take(self.pool.poll(cores() - 1, 0.0))

    def next_candidate(self, best: Refinement | None) -> tuple[str, Problem, Motion] | None:
        """The cheapest answer of a passage not tried yet, if it may beat ``best``."""
        certified = best is not None and best.certified
        while True:
            fresh = [item for item in self.found if self._is_new(item[1])]
            for name, outcome in sorted(fresh, key=lambda item: item[1].cost):
                if best is None or not certified or outcome.cost < WORTH_TRYING * best.cost:
                    self.tried.append(outcome)
                    return name, self.problem, outcome.motion
            if certified or not self.pool.busy or time.monotonic() > self.work.deadline:
                return None
            self._take(self.pool.poll(cores(), None))

    def _is_new(self, outcome: Outcome) -> bool:
        apart_m = SAME_PASSAGE * self.problem.layout.scale.length_m
        return all(_distance(outcome, old, self.work.phase) > apart_m for old in self.tried)

    def _take(self, answers: list[tuple[int, Outcome]]) -> None:
        for i, outcome in answers:
            name = self.guesses[i]
            self.work.note(name, self.problem, outcome)
            if outcome.solved:
                self.found.append((name, outcome))


def _distance(a: Outcome, b: Outcome, phase: Phase) -> float:
    """Largest distance of two answers' positions over vehicles and nodes."""
    gaps = [
        a.motion.states[v.name][: v.dim] - b.motion.states[v.name][: v.dim] for v in phase.vehicles
    ]
    return max(float(np.max(np.linalg.norm(gap, axis=0))) for gap in gaps)


def _better(best: Refinement | None, new: Refinement) -> Refinement:
    if best is None or best.plan is None:
        return new
    if new.plan is None:
        return best
    old_rank, new_rank = ((not r.certified, r.cost) for r in (best, new))
    return best if old_rank <= new_rank else new
