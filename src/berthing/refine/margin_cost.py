"""What a wider margin costs, from the multipliers of an answer."""

from __future__ import annotations

import casadi as ca
import numpy as np

from berthing.scenario.scenario import Scenario
from berthing.solve.outcome import Outcome
from berthing.transcription.problem import Problem

STEP_M = 1e-3
"""Rows are linear in the margin, or nearly so over a millimetre."""


def cost_per_margin(
    scenario: Scenario, problem: Problem, outcome: Outcome, backoff_m: float
) -> float:
    """dJ/dd in units of the cost per metre, d added to every margin.

    At an optimum of f under rows g(x, p) with multipliers λ, df/dp = ∂f/∂p + λᵀ ∂g/∂p (Fiacco,
    Introduction to Sensitivity and Stability Analysis in Nonlinear Programming, 1983).
    """
    nlp = problem.nlp
    rows = ca.Function("rows", [nlp["x"], nlp["p"]], [nlp["g"]])
    at = [
        np.asarray(rows(outcome.x, _parameters(scenario, problem, outcome, d))).ravel()
        for d in (backoff_m, backoff_m + STEP_M)
    ]
    slope = float(outcome.multipliers @ (at[1] - at[0])) / STEP_M
    return slope * problem.layout.scale.cost


def _parameters(
    scenario: Scenario, problem: Problem, outcome: Outcome, backoff_m: float
) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    duration = outcome.motion.duration_s
    return np.asarray(problem.parameter_vector(scenario, backoff_m, duration)).ravel()
