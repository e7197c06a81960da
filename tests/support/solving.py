"""From a scenario to an answer of the solver, without the planner."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

from berthing.guess.candidates import candidates
from berthing.guess.normals import exact_normals
from berthing.guess.path import motion_along
from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Budget, Solver, Start
from berthing.solve.outcome import Outcome
from berthing.trajectory import PhaseTrajectory, VehicleNodes
from berthing.transcription import extract
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion, Problem, build
from berthing.transcription.sites import Site, node_sites

BACKOFF_M = 1e-3


@dataclass(frozen=True)
class Solved:
    """An answer with what it answers."""

    problem: Problem
    outcome: Outcome

    @property
    def trajectory(self) -> PhaseTrajectory:
        return extract.trajectories(self.problem, self.outcome.motion)

    @property
    def nodes(self) -> tuple[VehicleNodes, ...]:
        return extract.nodes(self.problem, self.outcome.motion, self.outcome.multipliers)


def posed(
    scenario: Scenario,
    segments: int = 4,
    degree: int = 4,
    sites: list[Site] | None = None,
    scheme: str = "lgr",
) -> Problem:
    """The programme of the first phase, rows at all nodes where no ``sites`` are given."""
    phase = scenario.phases[0]
    mesh = Mesh.uniform(scheme, segments, degree)
    if sites is None:
        sites = node_sites(mesh, len(scenario.pairs(phase)))
    return build(scenario, phase, mesh, sites, "plane")


def guessed(problem: Problem, number: int = 0) -> Motion:
    """The motion of one of the guesses; the first is straight."""
    phase = problem.phase
    guess = candidates(problem.scenario, phase, 0)[number]
    return motion_along(guess, phase, problem.mesh, phase.horizon.nominal_s)


def start_of(problem: Problem, number: int = 0) -> Start:
    return Start(guessed(problem, number), exact_normals(problem.pairs))


def solved(
    scenario: Scenario,
    segments: int = 4,
    degree: int = 4,
    *,
    guess: int = 0,
    sites: list[Site] | None = None,
    iterations: int = 300,
    scheme: str = "lgr",
) -> Solved:
    """The solver's answer from a guess, whatever its status."""
    problem = posed(scenario, segments, degree, sites, scheme)
    solver = Solver.build(problem, "cold", Budget(iterations))
    outcome = solver.solve(scenario, start_of(problem, guess), backoff_m=BACKOFF_M)
    return Solved(problem, outcome)


def programme(x: Any, f: Any, g: Any) -> dict[str, Any]:
    """f(x) and rows g(x) of casadi's, with the functions of their derivatives."""
    p, lam_f, lam_g = ca.MX.sym("p", 0), ca.MX.sym("lam_f"), ca.MX.sym("lam_g", g.numel())
    hessian = ca.triu(ca.hessian(lam_f * f + ca.dot(lam_g, g), x)[0])
    return {
        "x": x, "p": p, "f": f, "g": g,
        "grad_f": ca.Function("grad_f", [x, p], [f, ca.gradient(f, x)]),
        "jac_g": ca.Function("jac_g", [x, p], [g, ca.jacobian(g, x)]),
        "hess_lag": ca.Function("hess_lag", [x, p, lam_f, lam_g], [hessian]),
    }  # fmt: skip
