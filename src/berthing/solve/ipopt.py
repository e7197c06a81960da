"""IPOPT through CasADi: options, the call, and what its answers mean."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.scenario import Scenario
from berthing.solve.outcome import NOT_CONVERGED, STATUS, Outcome
from berthing.transcription.problem import Motion, Problem
from berthing.transcription.separation import Normals

TOLERANCE = 1e-8
"""Of the scaled optimality conditions: it leaves costs right to about 1e-8 of themselves."""

COLD = {"mu_strategy": "adaptive"}
"""From a guess: the barrier follows the progress made, which survives poor guesses best."""

NEAR = {"mu_strategy": "monotone", "mu_init": 1e-5}
"""From an answer on another mesh: close in the states, no multipliers. With 1e-3 the answer hops
from one way through a corner to the next and takes half as long again."""

WARM: dict[str, Any] = {
    "warm_start_init_point": "yes",
    "mu_init": 1e-6,
    "warm_start_bound_push": 1e-8,
    "warm_start_bound_frac": 1e-8,
    "warm_start_slack_bound_push": 1e-8,
    "warm_start_slack_bound_frac": 1e-8,
    "warm_start_mult_bound_push": 1e-8,
}
"""From an answer with multipliers."""

SHARP = {**NEAR, "tol": 1e-10}
"""Near, and down to a barrier a hundred times lower: what it leaves on rows that are not active
adds up over a hundred of them, and costates show it first."""

PRESETS: dict[str, dict[str, Any]] = {"cold": COLD, "near": NEAR, "warm": WARM, "sharp": SHARP}


@dataclass(frozen=True)
class Budget:
    """What a solve may spend."""

    iterations: int = 500
    wall_time_s: float = 1e6


@dataclass(frozen=True)
class Start:
    """Where a solve begins.

    Attributes:
        motion: states, controls, duration.
        normals: how to part the pairs at its poses.
        patient: whether IPOPT is to take it, who gives up later than our own method.
    """

    motion: Motion
    normals: Normals
    patient: bool = False

    def vector(self, problem: Problem, scenario: Scenario, eps: float | None = None) -> Array:
        """The variables of ``problem`` there, at a stage of its homotopy or the last."""
        return problem.start_vector(scenario, self.motion, self.normals, eps)


@dataclass(frozen=True)
class Answer:
    """A solve with the problem that it answers."""

    problem: Problem
    outcome: Outcome

    def carried(self, other: Problem, x0: Array) -> dict[str, Array]:
        """Start and multipliers for another problem on the same mesh, ``x0`` where it differs."""
        mine, theirs = self.problem.layout, other.layout
        return {
            "x0": mine.variables.carry(self.outcome.x, theirs.variables, x0),
            "lam_x0": mine.variables.carry(
                self.outcome.bound_multipliers, theirs.variables, np.zeros(len(x0))
            ),
            "lam_g0": mine.rows.carry(self.outcome.multipliers, theirs.rows),
        }


@dataclass(frozen=True)
class Solver:
    """One problem with its solver, built once and called many times."""

    problem: Problem
    function: Any
    build_time_s: float

    @staticmethod
    def build(problem: Problem, preset: str = "cold", budget: Budget | None = None) -> Solver:
        """Derivatives and solver of ``problem``."""
        budget = budget or Budget()
        began = time.perf_counter()
        ipopt: dict[str, Any] = {
            "print_level": 0, "sb": "yes", "tol": TOLERANCE, "max_iter": budget.iterations,
            # No early stop at a level that nobody asked for.
            "acceptable_iter": 0,
            # Bounds are kept as they are: relaxed ones would be missed by that much at the goal.
            "bound_relax_factor": 0.0,
            "max_wall_time": budget.wall_time_s, "linear_solver": "mumps",
            # The rows are scaled already; AMD orders small systems as well as METIS, sooner.
            "mumps_scaling": 0, "mumps_permuting_scaling": 0, "mumps_pivot_order": 0,
            **PRESETS[preset],
        }  # fmt: skip
        # Derivatives come with the problem; those of the parameters are nobody's business.
        options: dict[str, Any] = {
            "print_time": False, "error_on_fail": False, "calc_lam_p": False, "no_nlp_grad": True,
        }  # fmt: skip
        options |= {f"ipopt.{key}": value for key, value in ipopt.items()}
        derivatives = {key: problem.nlp[key] for key in ("grad_f", "jac_g", "hess_lag")}
        expressions = {key: problem.nlp[key] for key in "xpfg"}
        function = ca.nlpsol("berthing", "ipopt", expressions, options | derivatives)
        return Solver(problem, function, time.perf_counter() - began)

    def solve(
        self,
        scenario: Scenario,
        start: Start,
        *,
        backoff_m: float,
        previous: Answer | None = None,
        eps: float | None = None,
        bounds: tuple[Array, Array] | None = None,
    ) -> Outcome:
        """Solve from ``start``, or from ``previous`` on the same mesh, with its multipliers.

        Rows and variables that ``previous`` does not have begin as ``start`` says. ``eps`` is the
        stage of the problem's homotopy, the last one where None. ``bounds`` stand in for those of
        the problem's variables, stored units.

        Raises:
            KeyboardInterrupt: Ctrl-C during the solve, which IPOPT itself swallows.
        """
        problem = self.problem
        motion = start.motion
        parameters = problem.parameter_vector(scenario, backoff_m, motion.duration_s, eps)
        x0 = start.vector(problem, scenario, eps)
        lower, upper = bounds or problem.layout.variables.bounds()
        row_lower, row_upper = problem.layout.rows.bounds()
        arguments = {
            "x0": x0, "p": parameters, "lbx": lower, "ubx": upper,
            "lbg": row_lower, "ubg": row_upper,
        }  # fmt: skip
        if previous is not None:
            arguments |= previous.carried(problem, x0)
        began = time.perf_counter()
        answer = self.function(**arguments)
        elapsed = time.perf_counter() - began
        stats = self.function.stats()
        if stats["return_status"] in ("NonIpopt_Exception_Thrown", "User_Requested_Stop"):
            raise KeyboardInterrupt
        return self._outcome(answer, parameters, motion.duration_s, stats, elapsed)

    def _outcome(
        self, answer: Any, parameters: Array, duration_s: float, stats: Any, elapsed: float
    ) -> Outcome:
        problem = self.problem
        x, rows = _vector(answer["x"]), _vector(answer["g"])
        motion = problem.motion(x, duration_s)
        return Outcome(
            status=STATUS.get(stats["return_status"], NOT_CONVERGED),
            x=x,
            multipliers=_vector(answer["lam_g"]),
            bound_multipliers=_vector(answer["lam_x"]),
            parameters=parameters,
            motion=motion,
            cost=problem.cost(motion),
            iterations=int(stats["iter_count"]),
            wall_time_s=elapsed,
            worst_row=problem.layout.rows.worst(rows),
        )


def _vector(value: Any) -> Array:
    return np.asarray(value, dtype=np.float64).ravel()
