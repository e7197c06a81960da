"""Curvature of the Lagrangian at an answer: whether it is a minimum, and not a saddle.

    [H   Jᵀ]
    [J  -E ]        E = d/z of every inequality: next to none where it is active, huge where not

H is the exact Hessian of the Lagrangian. The matrix has as many negative eigenvalues as rows and no
zero, the inertia (n, m, 0), exactly where its Schur complement H + Jᵀ E⁻¹ J is positive definite
(Haynsworth), and then H is positive definite on the null space of what is active. That complement
is factorised: where it is positive definite an LDLᵀ without pivoting is stable for it, which that
of the whole matrix is not with E this small. Its least eigenvalue is a lower bound on those of the
reduced Hessian.

Planes that pull on nothing may turn as they like: their variables and rows are left out, for they
are no part of the motion and would show as flat.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import qdldl
from scipy import sparse

from berthing.clearance.signed_distance import Flags
from berthing.geometry.arrays import Array
from berthing.solve.barrier import Bounds
from berthing.solve.evaluation import Evaluation
from berthing.solve.ipopt import Answer
from berthing.transcription.elements import Index
from berthing.transcription.problem import Problem
from berthing.verify.second_order import SecondOrder

NONE: Index = np.empty(0, dtype=np.int64)

Idle = Callable[[Array], tuple[list[int], list[int]]]

FLAT = 1e-7
"""Of a cost and variables of order one: above what solves to 1e-8 leave undecided."""

DECADES = tuple(10.0**k for k in range(-7, 3))

WEAK = 1e-4
"""Of the largest multiplier: a plane that pulls by less is not held by its pull, for curvature
against turning it is as small. Without its row more moves are allowed, not fewer."""

TIGHT, LOOSE = 1e-7, 1e12
"""Between which E stays. Equalities have the first: springs of 1e7 in place of rows, whose rounding
is a hundredth of ``FLAT``. What is a minimum with springs is one with rows."""


def second_order(answer: Answer) -> SecondOrder | None:
    """The condition at an answer; None where no factorisation exists."""
    problem, outcome = answer.problem, answer.outcome
    below, above = problem.layout.variables.bounds()
    bounded = [int(i) for i in np.flatnonzero(np.isfinite(below) | np.isfinite(above))]
    lower, upper = problem.layout.rows.bounds()
    bounds = Bounds.of(np.append(lower, below[bounded]), np.append(upper, above[bounded]))
    evaluation = Evaluation(problem.nlp, bounded)
    evaluation.at(outcome.parameters)
    y = np.append(outcome.multipliers, outcome.bound_multipliers[bounded])
    blocks = problem.layout.variables.blocks
    instants = np.array([blocks[own.place].offset for own in problem.instants], dtype=np.int64)
    return curvatures(
        evaluation, bounds, outcome.x, y, lambda corner: _idle(answer, corner), instants
    )


def curvatures(
    evaluation: Evaluation, bounds: Bounds, x: Array, y: Array, idle: Idle,
    instants: Index = NONE,
) -> SecondOrder | None:  # fmt: skip
    """The condition at x with the multipliers y of rows.

    Args:
        idle: from E (m,) the variables and rows to leave out.
        instants: variables at which clearances are least, and not the cost: each adds a negative
            eigenvalue, and the others are those of the cost with the instants following.
    """
    corner = _corner(bounds, evaluation.value(x)[1], y)
    variables, rows = idle(corner)
    corner[rows] = LOOSE
    kept = np.setdiff1d(np.arange(evaluation.variables), variables)
    complement = _complement(evaluation, x, y, corner, kept)
    cost = ~np.isin(kept, instants)
    small = _below(complement, FLAT, cost)
    negative = 0 if small == 0 else _below(complement, -FLAT, cost)
    if negative is None or small is None:
        return None
    least = None if small else _least(complement, cost)
    own = len(corner) - len(rows)
    return SecondOrder(int(np.count_nonzero(cost)), own, negative, small - negative, FLAT, least)


def _complement(
    evaluation: Evaluation, x: Array, y: Array, corner: Array, kept: Index
) -> sparse.csc_matrix:
    """H + Jᵀ E⁻¹ J of the variables that are kept."""
    _, jacobian, hessian = evaluation.derivatives(x, y)
    n, m = evaluation.variables, evaluation.rows
    rows, columns = (np.asarray(v) for v in evaluation.hessian.get_triplet())
    upper = sparse.csc_matrix((hessian, (rows, columns)), shape=(n, n))
    whole = upper + sparse.triu(upper, 1).T
    rows, columns = (np.asarray(v) for v in evaluation.jacobian.get_triplet())
    slopes = sparse.csc_matrix((jacobian, (rows, columns)), shape=(m, n))
    total = whole + slopes.T @ sparse.diags(1.0 / corner) @ slopes
    return sparse.csc_matrix(total[kept][:, kept])


def _least(matrix: sparse.csc_matrix, cost: Flags) -> float:
    """The highest of the decades, the first of which is, that all eigenvalues are above."""
    low, high = 0, len(DECADES)
    while high - low > 1:
        middle = (low + high) // 2
        if _below(matrix, DECADES[middle], cost) == 0:
            low = middle
        else:
            high = middle
    return DECADES[low]


def _below(matrix: sparse.csc_matrix, level: float, cost: Flags | None = None) -> int | None:
    """How many eigenvalues are below a level, those of variables that are not the cost's left out;
    None where a pivot is zero."""
    cost = np.ones(matrix.shape[0], dtype=bool) if cost is None else cost
    shifted = sparse.triu(matrix - level * sparse.diags(cost.astype(np.float64)), format="csc")
    try:
        pivots = qdldl.Solver(shifted, upper=True).factors()[1]
    except RuntimeError:
        return None
    # One too few where a clearance is greatest: as wrong as one too many.
    return abs(int(np.count_nonzero(pivots < 0.0)) - int(np.count_nonzero(~cost)))


def _corner(bounds: Bounds, values: Array, y: Array) -> Array:
    """E (m,): the distance to the nearer bound over its multiplier."""
    z = np.maximum(bounds.multiplier(y), 0.0)
    d = np.maximum(bounds.distance(values), 0.0)
    stiffness = bounds.gather(np.divide(z, np.maximum(d, 1e-300)))
    soft = np.clip(1.0 / np.maximum(stiffness, 1.0 / LOOSE), TIGHT, LOOSE)
    return np.where(bounds.equal, TIGHT, soft)


def _idle(answer: Answer, corner: Array) -> tuple[list[int], list[int]]:
    """Variables and rows of planes that pull on nothing: their distance row is further from its
    margin than its multiplier is from zero, or its multiplier next to none."""
    variables, rows = list[int](), list[int]()
    places = {own.gap: own.place for own in answer.problem.instants}
    problem, planes = answer.problem, _planes(answer.problem)
    force = np.abs(answer.outcome.multipliers[[row for row, _ in planes]])
    least = WEAK * float(np.max(force, initial=0.0))
    pulling = {
        name
        for (row, names), own in zip(planes, force, strict=True)
        if corner[row] < 1.0 and own >= least
        for name in names
    }
    for row, names in planes:
        if names[-1] not in pulling:
            block = problem.layout.rows.block_of(row)
            rows += range(block.offset, block.offset + block.size)
            for name in (names[-1], *([places[row]] if row in places else [])):
                variables += problem.layout.variables.blocks[name].indices.ravel().tolist()
    return variables, rows


def _planes(problem: Problem) -> list[tuple[int, tuple[str, ...]]]:
    """Separation rows with the blocks of variables they are of, their own last."""
    separation = problem.separation
    own: list[tuple[int, tuple[str, ...]]] = [
        (row, (name,)) for row, name in zip(separation.rows, separation.blocks, strict=True)
    ]
    return own + [(s.row, (separation.blocks[s.first], s.block)) for s in problem.sweeps]
