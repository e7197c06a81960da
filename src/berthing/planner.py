"""The whole pipeline: scenario → guesses → coarse answers → refinement → certified plan."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from berthing import result as outcomes
from berthing.errors import InputError
from berthing.guess.candidates import candidates
from berthing.guess.normals import exact_normals
from berthing.guess.path import motion_along
from berthing.refine.refiner import BACKOFF_M, Refinement, Refiner
from berthing.result import Attempt, ProgressEvent, Result
from berthing.scenario.options import SolverOptions
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Budget, Solver, Start
from berthing.solve.outcome import ADVICE, Outcome
from berthing.solve.parallel import solve_each
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Problem, build
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
        coarse, found = _coarse(work)
    best: Refinement | None = None
    with work.stage("refine"):
        for name, outcome in found:
            if best is not None and not _worth(outcome, best):
                continue
            refined = work.refiner().run(name, coarse, outcome.motion)
            work.attempts += refined.attempts
            best = _better(best, refined)
            if time.monotonic() > work.deadline:
                break
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
    def deadline(self) -> float:
        return self.began + (self.options.time_limit_s or float("inf"))

    def stage(self, name: str) -> _Stage:
        self.tell(name)
        return _Stage(self, name)

    def tell(self, stage: str, detail: str = "") -> None:
        self.progress(ProgressEvent(stage, detail, self.iterations, self.clearance_m))

    def mesh(self, segments: int) -> Mesh:
        """``segments`` of the default degree, or what the nodes asked for allow."""
        nodes = self.options.nodes
        if nodes is None:
            return Mesh.uniform(self.options.scheme, segments, DEGREE)
        degree = min(DEGREE, nodes)
        return Mesh.uniform(self.options.scheme, max(1, round(nodes / degree)), degree)

    def refiner(self) -> Refiner:
        return Refiner(
            self.scenario, self.phase, self.mesh(FINE_SEGMENTS), self.options.formulation,
            self.options.seed, self._round, self.deadline,
        )  # fmt: skip

    def _round(self, detail: str, iterations: int, clearance_m: float | None) -> None:
        self.iterations += iterations
        self.clearance_m = clearance_m
        self.tell("refine", detail)

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
        advice = "try another --seed or more --nodes; " + "; ".join(verification.reasons[:3])
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


def _coarse(work: _Work) -> tuple[Problem, list[tuple[str, Outcome]]]:
    """Answers on a coarse mesh from every guess, cheapest first, one of each passage."""
    scenario, phase = work.scenario, work.phase
    mesh = work.mesh(COARSE_SEGMENTS)
    pairs = scenario.pairs(phase)
    problem = build(
        scenario, phase, mesh, node_sites(mesh, len(pairs)), work.options.formulation
    )
    left = work.deadline - time.monotonic()
    solver = Solver.build(problem, "cold", Budget(COARSE_ITERATIONS, min(left, 1e6)))
    guesses = candidates(scenario, phase, work.options.seed)
    duration = phase.horizon.nominal_s
    normals = exact_normals(pairs)
    starts = [Start(motion_along(guess, phase, mesh, duration), normals) for guess in guesses]
    found: list[tuple[str, Outcome]] = []
    for i, outcome in solve_each(solver, scenario, starts, BACKOFF_M):
        work.iterations += outcome.iterations
        work.attempts.append(
            Attempt(
                guesses[i].name, outcome.status, mesh.control_count, outcome.iterations,
                outcome.wall_time_s, outcome.cost if outcome.solved else None,
                note="" if outcome.solved else outcome.worst_row,
            )
        )  # fmt: skip
        work.tell("guess", f"{guesses[i].name}: {outcome.status}")
        if outcome.solved:
            found.append((guesses[i].name, outcome))
            if len(found) == ENOUGH:
                break
    found.sort(key=lambda item: item[1].cost)
    return problem, _distinct(found, SAME_PASSAGE * problem.layout.scale.length_m, phase)


def _distinct(
    found: list[tuple[str, Outcome]], apart_m: float, phase: Phase
) -> list[tuple[str, Outcome]]:
    kept: list[tuple[str, Outcome]] = []
    for name, outcome in found:
        if all(_distance(outcome, other, phase) > apart_m for _, other in kept):
            kept.append((name, outcome))
    return kept


def _distance(a: Outcome, b: Outcome, phase: Phase) -> float:
    """Largest distance of two answers' positions over vehicles and nodes."""
    gaps = [
        a.motion.states[v.name][: v.dim] - b.motion.states[v.name][: v.dim] for v in phase.vehicles
    ]
    return max(float(np.max(np.linalg.norm(gap, axis=0))) for gap in gaps)


def _worth(outcome: Outcome, best: Refinement) -> bool:
    if best.plan is None or best.verification is None or not best.verification.certified:
        return True
    return outcome.cost < WORTH_TRYING * best.plan.cost


def _better(best: Refinement | None, new: Refinement) -> Refinement:
    if best is None or best.plan is None or best.verification is None:
        return new
    if new.plan is None or new.verification is None:
        return best
    ranks = [(not r.verification.certified, r.plan.cost)
             for r in (best, new) if r.verification and r.plan]  # fmt: skip
    return best if ranks[0] <= ranks[1] else new
