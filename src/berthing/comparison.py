"""One case by several formulations from the same guesses, rows at the nodes only.

Nothing is refined, so that each form shows what it is worth by itself; the clearance between the
nodes is then measured with the true shapes, whatever shapes the form kept apart.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median

import numpy as np

from berthing.errors import CapabilityError, InputError
from berthing.guess.candidates import candidates
from berthing.guess.normals import exact_normals
from berthing.guess.path import motion_along
from berthing.proximity.formulations import FORMULATIONS, SEQUENTIAL
from berthing.refine.sampling import sample_clearance, sample_times
from berthing.result import ProgressEvent
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.solve.homotopy import solve_by_stages
from berthing.solve.ipopt import Budget, Solver, Start
from berthing.solve.outcome import Outcome
from berthing.solve.sequential import SequentialSolver, linearised
from berthing.transcription.extract import trajectories
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion, Problem, build
from berthing.transcription.sites import node_sites
from berthing.verify.endpoints import check_endpoints

SEGMENTS, DEGREE = 10, 4
"""Those of the planner's first, coarse answers."""

ITERATIONS = 500

SAMPLES = 64
"""To a segment, between the nodes."""

KEPT_M = 1e-6
"""A margin counts as kept where it is missed by no more than the solver's tolerance."""

METHODS = (*FORMULATIONS, *SEQUENTIAL)
"""What can be compared."""


@dataclass(frozen=True)
class Trial:
    """One formulation from one guess.

    Attributes:
        status: ``solved``, or how the solver left it.
        seconds: of the solver, building not included.
        cost: in the scenario's units; None where it was not solved.
        spare_nodes_m, spare_between_m: least distance of the true shapes less their margin, at
            the nodes and on a fine grid between them; None likewise. Below zero: missed.
    """

    formulation: str
    guess: str
    status: str
    iterations: int
    seconds: float
    cost: float | None = None
    spare_nodes_m: float | None = None
    spare_between_m: float | None = None

    @property
    def solved(self) -> bool:
        return self.cost is not None


@dataclass(frozen=True)
class Summary:
    """Of one formulation's trials.

    Attributes:
        refused: why the form cannot take this case, or empty.
        solved, trials: how many.
        cost: the least of those that keep the margins at the nodes; None where there is none.
        iterations, seconds: medians over the solved.
        spare_nodes_m, spare_between_m: of the cheapest trial.
    """

    formulation: str
    refused: str
    solved: int
    trials: int
    cost: float | None
    iterations: float | None
    seconds: float | None
    spare_nodes_m: float | None
    spare_between_m: float | None


@dataclass(frozen=True)
class Comparison:
    """All trials of one case.

    Attributes:
        refused: formulation → why it cannot take this case.
    """

    scenario: str
    nodes: int
    seed: int
    trials: tuple[Trial, ...]
    refused: dict[str, str]
    formulations: tuple[str, ...]

    def summaries(self) -> list[Summary]:
        """One a formulation, in the order asked for."""
        return [self._summary(name) for name in self.formulations]

    def _summary(self, name: str) -> Summary:
        mine = [t for t in self.trials if t.formulation == name]
        good = [t for t in mine if t.solved]
        best = min(good, key=lambda t: t.cost or 0.0, default=None)
        return Summary(
            name, self.refused.get(name, ""), len(good), len(mine),
            best.cost if best else None,
            median(t.iterations for t in good) if good else None,
            median(t.seconds for t in good) if good else None,
            best.spare_nodes_m if best else None,
            best.spare_between_m if best else None,
        )  # fmt: skip


def compare(
    scenario: Scenario,
    formulations: Sequence[str] = METHODS,
    *,
    guesses: int | None = None,
    seed: int = 0,
    limit_s: float = 60.0,
    progress: Callable[[ProgressEvent], None] | None = None,
) -> Comparison:
    """Solve ``scenario`` by each formulation from the same guesses.

    Args:
        guesses: how many of the planner's own; all of them where None.
        limit_s: on the time of each solve.

    Raises:
        InputError: a name that is none, several phases, or a start or goal that breaks a margin.
    """
    for name in formulations:
        if name not in METHODS:
            raise InputError("formulation", f"there is no {name!r}", f"one of {', '.join(METHODS)}")
    if len(scenario.phases) != 1:
        raise InputError("phases", f"are {len(scenario.phases)}", "one")
    check_endpoints(scenario)
    tell = progress or (lambda event: None)
    (phase,) = scenario.phases
    mesh = Mesh.uniform("lgr", SEGMENTS, DEGREE)
    normals = exact_normals(scenario.pairs(phase))
    drawn = candidates(scenario, phase, seed)[:guesses]
    motions = [(g.name, motion_along(g, phase, mesh, phase.horizon.nominal_s)) for g in drawn]
    trials: list[Trial] = []
    refused: dict[str, str] = {}
    for name in formulations:
        try:
            solver = _Method(scenario, phase, mesh, name, Budget(ITERATIONS, limit_s))
        except CapabilityError as error:
            refused[name] = str(error)
            continue
        for guess, motion in motions:
            trials.append(solver.trial(guess, Start(motion, normals)))
            tell(ProgressEvent("compare", f"{name}, {guess}: {trials[-1].status}"))
    nodes = SEGMENTS * DEGREE
    return Comparison(scenario.name, nodes, seed, tuple(trials), refused, tuple(formulations))


class _Method:
    """One formulation, built once."""

    def __init__(
        self, scenario: Scenario, phase: Phase, mesh: Mesh, name: str, budget: Budget
    ) -> None:
        self.scenario, self.phase, self.name = scenario, phase, name
        if name in SEQUENTIAL:
            self.problem = linearised(scenario, mesh)
            stepping = SequentialSolver(self.problem, budget)
            self.solve: Callable[[Start], Outcome] = lambda start: stepping.solve(
                scenario, start, backoff_m=0.0
            )
            return
        sites = node_sites(mesh, len(scenario.pairs(phase)))
        self.problem = build(scenario, phase, mesh, sites, name)
        self.solve = _solved_by(self.problem, scenario, budget)

    def trial(self, guess: str, start: Start) -> Trial:
        outcome = self.solve(start)
        told = (self.name, guess, outcome.status, outcome.iterations, outcome.wall_time_s)
        if not outcome.solved:
            return Trial(*told)
        at_nodes, between = self._spare(outcome.motion)
        if at_nodes < -KEPT_M and self.name in SEQUENTIAL:
            return Trial(self.name, guess, "overlaps", outcome.iterations, outcome.wall_time_s)
        return Trial(*told, outcome.cost, at_nodes, between)

    def _spare(self, motion: Motion) -> tuple[float, float]:
        """Least distance less margin at the nodes, and on the fine grid (m)."""
        flown = trajectories(self.problem, motion)
        nodes = motion.duration_s * self.problem.mesh.point_fractions()
        out = []
        for times in (nodes, sample_times(flown, SAMPLES)):
            found = sample_clearance(self.scenario, self.problem.pairs, flown, times, np.inf)
            out.append(-found.worst_m)
        return out[0], min(out)


def _solved_by(problem: Problem, scenario: Scenario, budget: Budget) -> Callable[[Start], Outcome]:
    if len(problem.homotopy) > 1:
        stage = Budget(budget.iterations, budget.wall_time_s / len(problem.homotopy))
        return lambda start: solve_by_stages(
            problem, scenario, start, preset="cold", budget=stage, backoff_m=0.0
        )
    solver = Solver.build(problem, "cold", budget)
    return lambda start: solver.solve(scenario, start, backoff_m=0.0)
