"""A point put back onto the equations by what costs least where bodies are."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from berthing.geometry.arrays import Array
from berthing.solve.evaluation import Evaluation
from berthing.solve.kkt_matrix import KktMatrix
from berthing.transcription.elements import Index
from berthing.transcription.problem import Problem

CHEAP = 1e-3
"""Weight of controls against states: controls give way, and bodies stay where a step put them."""

HELD, FREE = 1e-10, 1e12
"""What rows give way by: equations, and all others."""

STEPS, CLOSE = 3, 1e-10
"""Newton steps with one matrix at most, and the error of the equations that needs none."""


class Restoration:
    """Newton steps onto the equations of a problem, each the shortest by ``weight``.

    Args:
        bounded: variables whose bounds are the rows after the problem's own.

    Attributes:
        evaluation: of the problem, its parameters to be set.
        weight: (n,) of a unit of change.
    """

    def __init__(self, problem: Problem, bounded: Index) -> None:
        self.evaluation = Evaluation(problem.nlp, bounded.tolist())
        self.weight = np.ones(problem.layout.variables.size)
        for own in problem.layout.vehicles.values():
            self.weight[own.control.indices.ravel()] = CHEAP

    @cached_property
    def _matrix(self) -> KktMatrix:
        return KktMatrix(self.evaluation.hessian, self.evaluation.jacobian)

    def restored(self, x: Array, value: Array, equal: Array) -> Array:
        """``x`` (n,), moved until the rows flagged by ``equal`` (m,) have their ``value`` (m,); as
        far as that makes them better."""

        def missing(at: Array) -> Array:
            return np.where(equal, value - self.evaluation.value(at)[1], 0.0)

        short = missing(x)
        _, jacobian, hessian = self.evaluation.derivatives(x, np.zeros(len(short)))
        self._matrix.fill(0.0 * hessian, jacobian)
        if not self._matrix.factorise(self.weight, np.where(equal, HELD, FREE)):
            return x
        for _ in range(STEPS):
            error = float(np.max(np.abs(short)))
            if error <= CLOSE:
                break
            nearer = x + self._matrix.solve(np.concatenate([np.zeros(len(x)), short]))[: len(x)]
            left = missing(nearer)
            if not float(np.max(np.abs(left))) < error:
                break
            x, short = nearer, left
        return x
