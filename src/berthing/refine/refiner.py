"""From a coarse answer to a certified plan: rows where it dips, segments where it is not resolved.

The fine problem has separation rows only where things are near, and is solved from the coarse
answer with a small barrier, so that it stays in the same passage. Each answer is sampled densely;
dips get rows until none is left, and then the certificate decides.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from berthing.guess.normals import exact_normals
from berthing.guess.path import resample
from berthing.refine.astray import astray
from berthing.refine.margin_cost import cost_per_margin
from berthing.refine.place import dip_sites, dips_of, near_sites, sites_around
from berthing.refine.remesh import split_unresolved
from berthing.refine.sampling import SampledClearance, sample_clearance, sample_times
from berthing.result import Attempt
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.solve.homotopy import solve_by_stages
from berthing.solve.ipopt import Answer, Budget, Solver, Start
from berthing.solve.outcome import Outcome
from berthing.solve.quick import QuickSolver
from berthing.trajectory import Plan
from berthing.transcription.extract import nodes, trajectories
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion, Problem, ShapesOf, build, planned_shapes
from berthing.transcription.scaling import phase_scale
from berthing.transcription.separation_costates import separation_costates
from berthing.transcription.sites import Site, node_sites
from berthing.transcription.sweeps import longest_step
from berthing.transcription.turning import resolved
from berthing.verify.verdict import UNDECIDED, VIOLATED
from berthing.verify.verification import Verification, verify

BACKOFF_M = 5e-4
"""Added to every margin: a plan exactly at its margin cannot be proven to keep it. On Scenario A
half a millimetre costs 0.02 %."""

CLEAR_M = 5e-5
"""Samples must clear the margin by this before the certificate is asked."""

NEAR_M = 0.2
"""Rows start where the coarse answer comes within this of its margin."""

GUARDED = 0.2
"""Of the scenario's length: likewise where a refinement is guarded, if that is more."""

LOOK_M = 2.0
"""Distances are exact up to this beyond the margin; further out a lower bound will do."""

SAMPLES = 64
"""To a segment. Dips that hide between samples are found by the certificate."""

CARRY_M = 5e-3
"""Multipliers are carried to the next round where the dips are shallower than this: after deep
ones other rows are active, and old multipliers mislead."""

SPACING, REACH, SHRINK = 0.35, 1.3, 0.6
"""Sites around a dip: their spacing and reach in units of the mean distance of two nodes, and the
factor by which the spacing shrinks from round to round."""

SWEEP = 1.2
"""Sites that follow each other within this many spacings share planes."""

ROUGH = 1e-3
"""Tolerance of an answer that is to be solved on."""

FINISH_M = 0.03
"""Rough answers that dip less than this are solved on."""

FEW, FEW_M = 4, 0.01
"""Least clearances with no more room than the second in a coarse answer that is solved on: in
crowded scenes touches come and go, and Newton's method finds none of the ways it was tried on."""

ROUNDS = 14
ITERATIONS = 250


@dataclass
class Refinement:
    """What came of refining one candidate.

    Attributes:
        answer: the last solve that ended well, whether its plan is certified or not.
        astray: whether an answer stepped through something, so that there was no point in going on.
        finished: the solve with rows at its touches that the plan came from, if it did.
        stepped: whether planes were held, so that separation has no multipliers.
    """

    answer: Answer | None = None
    plan: Plan | None = None
    verification: Verification | None = None
    outcome: Outcome | None = None
    attempts: list[Attempt] = field(default_factory=list)
    astray: bool = False
    finished: Answer | None = None
    stepped: bool = False

    @property
    def certified(self) -> bool:
        """Whether there is a plan and it is certified."""
        return self.verification is not None and self.verification.certified

    @property
    def cost(self) -> float:
        """Of the plan; infinite where there is none."""
        return float("inf") if self.plan is None else self.plan.cost


@dataclass(frozen=True)
class Step:
    """One solve with the clearance along its answer; None where it has not solved."""

    problem: Problem
    outcome: Outcome
    sampled: SampledClearance | None


Finish = Callable[[Scenario, Step], Answer | None]
"""An answer solved on in some other way; None where that fails."""


@dataclass(frozen=True)
class Refiner:
    """Refines candidates of one phase.

    Attributes:
        mesh: to begin with.
        report: is told (detail, iterations of the round, best sampled clearance).
        deadline: on the monotonic clock.
        shapes_of: what stands for the parts of a pair.
        slow: whether rates are limited to what each mesh resolves.
        guarded: whether rows reach further, and all neighbouring nodes share planes: it holds an
            answer in its passage, at the price of larger problems.
        finish: tried on a rough answer of the first round, before the rounds as they are.
    """

    scenario: Scenario
    phase: Phase
    mesh: Mesh
    formulation: str
    seed: int
    report: Callable[[str, int, float | None], None]
    deadline: float
    shapes_of: ShapesOf = planned_shapes
    slow: bool = False
    guarded: bool = False
    finish: Finish | None = None

    def run(self, name: str, coarse: Problem, motion: Motion) -> Refinement:
        """Refine ``motion``, the answer of ``coarse``, until certified or out of rounds."""
        mesh = self.mesh
        sampled = self.sample(coarse, motion)
        if not self.guarded and astray(coarse.pairs, sampled):
            return Refinement(astray=True)
        further_m = GUARDED * phase_scale(self.scenario, self.phase).length_m
        near_m = max(NEAR_M, further_m) if self.guarded else NEAR_M
        sites = near_sites(mesh, len(coarse.pairs), sampled, near_m)
        motion = resample(motion, self.phase, coarse.mesh, mesh)
        spacing = SPACING * motion.duration_s / mesh.control_count
        reach = REACH * motion.duration_s / mesh.control_count
        sites = dip_sites(mesh, sites, sampled, 0.0, spacing, reach)
        few = len(dips_of(sampled, -FEW_M)) <= FEW
        refiner = self if few else replace(self, finish=None)
        return refiner._rounds(name, mesh, sites, motion, (spacing, reach), None)

    def once(self, name: str, coarse: Problem, motion: Motion) -> Refinement:
        """The answer with rows at every node, checked, and left as it is."""
        result = Refinement()
        motion = resample(motion, self.phase, coarse.mesh, self.mesh)
        sites = node_sites(self.mesh, len(coarse.pairs))
        problem = build(self.scenario, self.phase, self.mesh, sites, self.formulation)
        step = self.step(f"{name}, as it is", problem, motion, None, result.attempts)
        result.outcome = step.outcome
        if step.sampled is not None:
            result.answer = Answer(problem, step.outcome)
            self.verify(result, step)
        return result

    def follow(self, name: str, answer: Answer, rounds: int = ROUNDS) -> Refinement:
        """Refine an answer come by otherwise: on its mesh, at its sites, from its point."""
        problem, motion = answer.problem, answer.outcome.motion
        node_s = motion.duration_s / problem.mesh.control_count
        sites = list(problem.separation.sites)
        around = SPACING * SHRINK * node_s, REACH * node_s
        return self._rounds(name, problem.mesh, sites, motion, around, answer, rounds)

    def _rounds(
        self, name: str, mesh: Mesh, sites: list[Site], motion: Motion,
        around_s: tuple[float, float], previous: Answer | None, rounds: int = ROUNDS,
    ) -> Refinement:  # fmt: skip
        """Solve, sample, add sites ``around_s`` (spacing, reach) dips, until certified."""
        result = Refinement()
        spacing, reach = around_s
        for round_ in range(rounds):
            problem = self._build(mesh, sites)
            label = f"{name}, round {round_ + 1}"
            if previous is None and round_ == 0 and self._roughly(label, problem, motion, result):
                break
            step = self.step(label, problem, motion, previous, result.attempts)
            outcome, sampled = step.outcome, step.sampled
            if sampled is None:
                result.outcome = result.outcome or outcome
                break
            result.outcome, motion = outcome, outcome.motion
            result.answer = Answer(problem, outcome)
            if not self.guarded and astray(problem.pairs, sampled):
                result.astray = True
                break
            close = sampled.worst_m < CARRY_M
            previous = result.answer if close else None
            spacing *= SHRINK
            if sampled.worst_m > -CLEAR_M:
                before = sites
                allowed = -0.5 * BACKOFF_M
                sites = dip_sites(mesh, sites, sampled, allowed, spacing, reach)
                if len(sites) > len(before):
                    continue
            self.verify(result, step)
            if result.certified:
                break
            mesh, motion, sites = self._after(result, problem, motion, spacing, reach)
            if mesh == problem.mesh and len(sites) == len(problem.separation.sites):
                # A mesh of one segment cannot be cut: the plan stays what it is.
                break
            previous = previous if mesh == problem.mesh else None
        return result

    def _roughly(
        self, label: str, problem: Problem, motion: Motion, result: Refinement
    ) -> bool:
        """Whether a rough answer, solved on, gives a certified plan: half the steps of a fine one,
        and as good to begin from."""
        budget = Budget(ITERATIONS, max(self.deadline - time.monotonic(), 0.1))
        solver = QuickSolver(problem, "near", budget, ROUGH, falls_back=False)
        if self.finish is None or not solver.quick:
            return False
        start = Start(motion, exact_normals(problem.pairs))
        outcome = solver.solve(self.scenario, start, backoff_m=BACKOFF_M)
        result.attempts.append(attempt(f"{label}, roughly", problem, outcome))
        if not outcome.solved:
            return False
        sampled = self.sample(problem, outcome.motion)
        self.report(label, outcome.iterations, _least(sampled))
        if not self._finish(label, Step(problem, outcome, sampled), result):
            return False
        result.answer = Answer(problem, outcome)
        return True

    def _finish(self, label: str, step: Step, result: Refinement) -> bool:
        """Whether the step, solved on, gives a certified plan, which ``result`` then takes."""
        shallow = step.sampled is not None and step.sampled.worst_m < FINISH_M
        answer = self.finish(self.scenario, step) if self.finish and shallow else None
        if answer is None:
            return False
        result.attempts.append(attempt(f"{label}, at touches", answer.problem, answer.outcome))
        trial = Refinement()
        self.verify(trial, Step(answer.problem, answer.outcome, step.sampled))
        if trial.certified:
            result.plan, result.verification = trial.plan, trial.verification
            result.finished, result.outcome = answer, answer.outcome
        return trial.certified

    def step(
        self, label: str, problem: Problem, motion: Motion, previous: Answer | None,
        attempts: list[Attempt], preset: str | None = None,
    ) -> Step:  # fmt: skip
        """Solve, record it, sample the answer, tell of it."""
        outcome = self.solve(label, problem, motion, previous, attempts, preset)
        if not outcome.solved:
            return Step(problem, outcome, None)
        sampled = self.sample(problem, outcome.motion)
        self.report(label, outcome.iterations, _least(sampled))
        return Step(problem, outcome, sampled)

    def solve(
        self, label: str, problem: Problem, motion: Motion, previous: Answer | None,
        attempts: list[Attempt], preset: str | None = None,
    ) -> Outcome:  # fmt: skip
        """Solve and record it."""
        outcome = self._solve(problem, motion, previous, preset)
        attempts.append(attempt(label, problem, outcome))
        return outcome

    def _build(self, mesh: Mesh, sites: list[Site]) -> Problem:
        within = SWEEP * SPACING / self.mesh.control_count
        if self.guarded:
            within = max(within, longest_step(mesh))
        phase = resolved(self.scenario, self.phase, mesh) if self.slow else self.phase
        return build(
            self.scenario, phase, mesh, sites, self.formulation,
            shapes_of=self.shapes_of, sweep_within=within,
        )  # fmt: skip

    def _solve(
        self, problem: Problem, motion: Motion, previous: Answer | None, preset: str | None
    ) -> Outcome:
        left = max(self.deadline - time.monotonic(), 0.1)
        budget = Budget(ITERATIONS, left)
        solver = (
            QuickSolver(problem, "near" if previous is None else "warm", budget)
            if preset is None
            else Solver.build(problem, preset, budget)
        )
        start = Start(motion, exact_normals(problem.pairs))
        outcome = solver.solve(self.scenario, start, backoff_m=BACKOFF_M, previous=previous)
        if outcome.solved:
            return outcome
        if len(problem.homotopy) < 2:
            return outcome if preset is not None else self._again(problem, start, outcome)
        budget = Budget(ITERATIONS, max(self.deadline - time.monotonic(), 0.1))
        return solve_by_stages(
            problem, self.scenario, start, preset="near", budget=budget, backoff_m=BACKOFF_M
        )

    def _again(self, problem: Problem, start: Start, failed: Outcome) -> Outcome:
        """From the same motion with a barrier that begins high: slower, and of longer breath."""
        left = max(self.deadline - time.monotonic(), 0.1)
        solver = Solver.build(problem, "cold", Budget(ITERATIONS, left))
        outcome = solver.solve(self.scenario, start, backoff_m=BACKOFF_M)
        return replace(
            outcome,
            iterations=failed.iterations + outcome.iterations,
            wall_time_s=failed.wall_time_s + outcome.wall_time_s,
        )

    def sample(
        self, problem: Problem, motion: Motion, look_m: float = LOOK_M
    ) -> SampledClearance:
        """Clearance along ``motion``, a motion of ``problem``: exact up to ``look_m`` beyond the
        margin."""
        trajectory = trajectories(problem, motion)
        times = sample_times(trajectory, SAMPLES)
        margin = self.scenario.margins.default_m
        return sample_clearance(self.scenario, problem.pairs, trajectory, times, margin + look_m)

    def verify(self, result: Refinement, step: Step) -> None:
        """Make a plan of a solved step and check it; ``result`` takes both."""
        plan = make_plan(self.scenario, step.problem, step.outcome, self.formulation, self.seed)
        if result.stepped:
            plan = without_multipliers(plan)
        result.plan, result.verification = plan, verify(self.scenario, plan)

    def _after(
        self, result: Refinement, problem: Problem, motion: Motion, spacing: float, reach: float
    ) -> tuple[Mesh, Motion, list[Site]]:
        """Mesh, motion and sites of the next round, after what the verification found."""
        assert result.plan is not None
        assert result.verification is not None
        mesh, sites = problem.mesh, list(problem.separation.sites)
        index = {pair.name: i for i, pair in enumerate(problem.pairs)}
        dips = [
            (index[verdict.pair], t)
            for verdict in result.verification.pairs
            if verdict.verdict in (VIOLATED, UNDECIDED) and not verdict.lost_to_tube
            for t in (*verdict.violations_s, verdict.time_s)
        ]
        if dips:
            span = problem.layout.t0_s, problem.layout.t0_s + motion.duration_s
            return mesh, motion, sites_around(mesh, sites, dips, span, spacing, reach)
        finer = split_unresolved(mesh, self.phase, result.plan.phases[0])
        moved = [
            Site(*finer.locate(mesh.fraction(site.segment, site.s)), site.pair) for site in sites
        ]
        return finer, resample(motion, self.phase, mesh, finer), sorted(moved)


def make_plan(
    scenario: Scenario, problem: Problem, outcome: Outcome, formulation: str, seed: int
) -> Plan:
    """The plan of one solve."""
    return Plan(
        scenario_name=scenario.name,
        phases=(trajectories(problem, outcome.motion),),
        nodes=nodes(problem, outcome.motion, outcome.multipliers),
        formulation=formulation,
        scheme=problem.mesh.scheme,
        cost=outcome.cost,
        iterations=outcome.iterations,
        seed=seed,
        backoff_m=BACKOFF_M,
        cost_per_margin=cost_per_margin(scenario, problem, outcome, BACKOFF_M),
        separations=separation_costates(
            problem, outcome.x, outcome.parameters, outcome.multipliers, outcome.motion.duration_s
        ),
    )


def without_multipliers(plan: Plan) -> Plan:
    """The plan without costates and multipliers, where those at hand know of no separation."""
    nodes = tuple(
        replace(own, costates=np.full_like(own.costates, np.nan), multipliers={})
        for own in plan.nodes
    )
    return replace(plan, nodes=nodes, cost_per_margin=None)


def _least(sampled: SampledClearance) -> float | None:
    real = np.where(np.isnan(sampled.margins_m), np.inf, sampled.distances_m)
    return float(np.min(real)) if real.size else None


def attempt(name: str, problem: Problem, outcome: Outcome) -> Attempt:
    """The record of one solve."""
    return Attempt(
        guess=name,
        outcome=outcome.status,
        nodes=problem.mesh.control_count,
        iterations=outcome.iterations,
        wall_time_s=outcome.wall_time_s,
        cost=outcome.cost if outcome.solved else None,
        note="" if outcome.solved else outcome.worst_row,
    )
