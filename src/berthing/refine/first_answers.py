"""The coarse problem and its answers, one round of all the guesses after the other."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Literal

from berthing.guess.continuation import Continuation
from berthing.guess.first_motions import DEFAULT, ROUTES, FirstMotions, first_motions
from berthing.guess.nearby import ROOM, near_pairs
from berthing.guess.normals import exact_normals
from berthing.guess.search import EFFORTS, Effort, Search
from berthing.refine.begin_with import beginning
from berthing.refine.refiner import BACKOFF_M
from berthing.scenario.options import SolverOptions
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.solve.convex_steps import ConvexSteps, takes_steps
from berthing.solve.ipopt import Budget, Start
from berthing.solve.outcome import Outcome
from berthing.solve.parallel import SolvePool
from berthing.solve.quick import QuickSolver
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Problem, build
from berthing.transcription.scaling import phase_scale
from berthing.transcription.sites import node_sites
from berthing.transcription.sweeps import longest_step
from berthing.transcription.turning import resolved, too_fast

COARSE_TOLERANCE = 1e-6
"""Of guesses' answers, which are solved again on another mesh."""

COARSE_ITERATIONS = 150
"""Guesses that lead anywhere converge in 40 to 110; the rest wander."""

PATIENT_ITERATIONS = 300
"""Of a patient wave: with planes shared between the nodes answers come in 90 to 280."""


@dataclass(frozen=True)
class Wave:
    """One round of all the guesses.

    Attributes:
        suffix: of the guesses' names.
        patient: whether IPOPT solves it, who gives up later than our own method, and neighbouring
            nodes share planes, so that no answer steps through a wall between them.
        routed: whether its guesses are routes alone.
        steps: whether planes are held and convex steps taken; in crowded scenes alone, or in the
            others alone.
    """

    suffix: str = ""
    patient: bool = True
    routed: bool = False
    steps: Literal["crowded", "other"] | None = None


WAVES = (
    Wave(patient=False, steps="crowded"), Wave(patient=False),
    Wave(", in steps", patient=False, steps="other"), Wave(routed=True), Wave(", again"),
)  # fmt: skip
"""Each is for what those before it find no certified plan for."""

PATIENT_ANSWERS = 2
"""Enough of a patient wave, in which each takes many times as long."""


@dataclass(frozen=True)
class Round:
    """The coarse problem of a wave and its guesses, the first of them solved.

    Attributes:
        problem: the coarse problem.
        search: its guesses and answers.
        slow: whether rates are limited to what meshes resolve.
    """

    problem: Problem
    search: Search
    slow: bool


@dataclass(frozen=True)
class Coarse:
    """The coarse problem of one phase.

    Attributes:
        note: is told (name, problem, outcome) of each solve.
        deadline: on the monotonic clock.
        drawn: guesses that were made for a wave, for those that ask for the same.
    """

    scenario: Scenario
    phase: Phase
    mesh: Mesh
    options: SolverOptions
    note: Callable[[str, Problem, Outcome], None]
    deadline: float
    drawn: dict[tuple[bool, bool], FirstMotions] = field(default_factory=dict)

    def first(self, wave: Wave) -> Round | None:
        """With rows for all that the first answers come near; None where the wave has nothing new
        for this form, which is IPOPT's from the start."""
        if (wave.routed or wave.steps) and self.options.guess != DEFAULT:
            return None
        if wave.steps:
            few = len(self.scenario.pairs(self.phase)) <= self._effort.exact
            return None if few and wave.steps == "crowded" else self._stepped(wave)
        guessed = self._guessed(wave)
        also: set[int] = set()
        slow = False
        while True:
            found = self._round(wave, guessed, also, slow)
            if found is None:
                return None
            _begin(found.search)
            motions, problem = found.search.motions, found.problem
            known = {site.pair for site in problem.separation.sites}
            near = near_pairs(self.scenario, problem.pairs, self.mesh, motions, 0.0)
            fast = not slow and too_fast(self.phase, self.mesh, motions)
            if near <= known and not fast:
                return found
            found.search.pool.close()
            also, slow = known | near, slow or fast

    @property
    def _effort(self) -> Effort:
        return EFFORTS[self.options.effort]

    def _stepped(self, wave: Wave) -> Round | None:
        """The coarse problem without separation rows, where convex steps are for it."""
        scenario, phase, pairs = self.scenario, self.phase, self.scenario.pairs(self.phase)
        first = beginning(self.options.formulation, pairs)
        length_m = phase_scale(scenario, phase).length_m
        guessed = self._guessed(wave)
        motions = [motion for _, motion in guessed]
        near = near_pairs(scenario, pairs, self.mesh, motions, ROOM * length_m)
        crowded = len(near) > self._effort.exact
        if crowded != (wave.steps == "crowded") or not near or first.formulation != "plane":
            return None
        problem = build(scenario, phase, self.mesh, [], first.formulation)
        if not takes_steps(problem):
            return None
        normals = exact_normals(pairs)
        starts = [Start(motion, normals) for motion in motions]
        search = Search(
            [f"{name}{wave.suffix}" for name, _ in guessed],
            SolvePool(ConvexSteps(problem, self._budget(wave)), scenario, starts, BACKOFF_M),
            self._effort, phase, length_m,
            lambda name, outcome: self.note(name, problem, outcome), self.deadline,
        )  # fmt: skip
        _begin(search)
        return Round(problem, search, slow=False)

    def _guessed(self, wave: Wave) -> FirstMotions:
        key = wave.patient, wave.routed
        if key not in self.drawn:
            self.drawn[key] = self._draw(wave)
        return self.drawn[key]

    def _draw(self, wave: Wave) -> FirstMotions:
        first = beginning(self.options.formulation, self.scenario.pairs(self.phase))
        whole = Continuation(
            self.scenario, self.phase, self.mesh, first.formulation, self._budget(wave), BACKOFF_M,
            self.note, first.shapes_of,
        )  # fmt: skip
        guess = ROUTES if wave.routed else self.options.guess
        own = self._effort
        return first_motions(guess, whole, self.options.seed, own.drawn, own.routes)

    def _budget(self, wave: Wave) -> Budget:
        iterations = PATIENT_ITERATIONS if wave.patient else COARSE_ITERATIONS
        return Budget(iterations, max(min(self.deadline - time.monotonic(), 1e6), 0.0))

    def _round(self, wave: Wave, guessed: FirstMotions, also: set[int], slow: bool) -> Round | None:
        """The coarse problem and its guesses, ready to be solved.

        Its rows are for the pairs that a guess comes near, and for those of ``also``.
        """
        scenario, mesh = self.scenario, self.mesh
        phase = resolved(scenario, self.phase, mesh) if slow else self.phase
        effort, pairs = self._effort, scenario.pairs(phase)
        if wave.patient and effort.answers < float("inf"):
            effort = replace(effort, answers=min(effort.answers, PATIENT_ANSWERS))
        first = beginning(self.options.formulation, pairs)
        length_m = phase_scale(scenario, phase).length_m
        motions = [motion for _, motion in guessed]
        near = also | near_pairs(scenario, pairs, mesh, motions, ROOM * length_m)
        problem = build(
            scenario, phase, mesh,
            [site for site in node_sites(mesh, len(pairs)) if site.pair in near],
            first.formulation, shapes_of=first.shapes_of,
            sweep_within=longest_step(mesh) if wave.patient else 0.0,
        )  # fmt: skip
        budget = self._budget(wave)
        solver = QuickSolver(problem, "cold", budget, COARSE_TOLERANCE, falls_back=False)
        if not motions or (wave.patient and not solver.quick):
            return None
        normals = exact_normals(pairs)
        starts = [Start(motion, normals, patient=wave.patient) for motion in motions]
        search = Search(
            [f"{name}{wave.suffix}" for name, _ in guessed],
            SolvePool(solver, scenario, starts, BACKOFF_M), effort, phase, length_m,
            lambda name, outcome: self.note(name, problem, outcome), self.deadline,
        )  # fmt: skip
        return Round(problem, search, slow)


def _begin(search: Search) -> None:
    """Solve its first guesses; nothing is left running where that is broken off."""
    try:
        search.first_answers()
    except BaseException:
        search.pool.close()
        raise
