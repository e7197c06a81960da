"""Newton's method on the conditions of optimality, from near by and with the rows that bind.

Rows that bind are equations, the others are left out; after each step rows are let go whose
multiplier pulls, and taken in where the step breaks them (the primal-dual active-set method,
Hintermüller, Ito and Kunisch, 10.1137/S1052623401383558). From an answer to a problem that has
moved a little that is three or four steps, where a barrier method needs twenty or more: it must
first leave the boundary that the answer lies on.

It is for programmes whose separation rows stand at instants that move: conditions taken as
equations do not ask which of the variables minimise. Whether an answer is one is asked at its end:
the matrix must have one negative eigenvalue for every row, and one for every instant that binds,
where the clearance is least, not greatest.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import casadi as ca
import numpy as np
import numpy.typing as npt

from berthing.clearance.signed_distance import Flags
from berthing.geometry.arrays import Array
from berthing.solve.evaluation import Evaluation
from berthing.solve.kkt_matrix import KktMatrix
from berthing.transcription.elements import Index

Sides = npt.NDArray[np.int8]

SOLVED, STUCK, ITERATIONS, SADDLE = "solved", "stuck", "iterations", "saddle"

AT_LOWER, FREE, AT_UPPER = -1, 0, 1
"""Where a row is held; the sign is that of its multiplier."""

SHIFT = 1e-7
"""δ and E of the matrix, for a factorisation without pivoting. Support functions are linear in
their multipliers, so that with a smaller δ two rows on one of these cancel to rounding; the
right-hand side takes E out again, and δ damps steps by as little."""

PINNED = 1.0
"""δ of variables that no row holds."""

SLACK = 1e-9
"""By which a row may be broken, or a multiplier pull, before the rows that bind change."""

LOST = 1e6
"""Error from which there is no way back."""

BINDS = 0.02
"""A row with no more room than this binds to begin with, where nothing better is known."""


@dataclass(frozen=True)
class Group:
    """Variables and rows that come and go with one row.

    Attributes:
        variables, rows: indices. gap: the row.
    """

    variables: Index
    rows: Index
    gap: int


@dataclass(frozen=True)
class Bearing:
    """A point with what holds it.

    Attributes:
        x: variables (n,). y: multipliers of the rows (m,), of f + yᵀ g.
        sides: (m,) where each row is held; equalities always are.
        out: (groups,) whether the group of that number is left out.
    """

    x: Array
    y: Array
    sides: Sides
    out: Flags


@dataclass(frozen=True)
class Reached:
    """Where the method ended."""

    status: str
    bearing: Bearing
    iterations: int
    error: float


class Newton:
    """One programme, to be solved as often as wanted.

    Args:
        evaluation: its functions. lower, upper: bounds of the rows (m,).
        groups: what is left out where its row pulls.
    """

    def __init__(
        self, evaluation: Evaluation, lower: Array, upper: Array, groups: Sequence[Group]
    ) -> None:
        self._evaluation, self._lower, self._upper = evaluation, lower, upper
        self._equal = lower == upper
        self._groups = tuple(groups)
        # Of the other rows, limits above all, few ever bind, and those fill the factors.
        kept = self._equal.copy()
        for group in groups:
            kept[group.rows] = True
        self._keep(kept)

    def begin(self, x: Array, parameters: Array) -> Bearing:
        """At x (n,): rows with hardly any room bind, with the multipliers of least squares.

        Every group's row counts as binding.
        """
        self._evaluation.at(parameters)
        g = self._evaluation.value(x)[1]
        sides = np.where(self._equal, AT_LOWER, FREE).astype(np.int8)
        sides[~self._equal & (g - self._lower < SLACK)] = AT_LOWER
        sides[~self._equal & (self._upper - g < SLACK)] = AT_UPPER
        for group in self._groups:
            near = g[group.rows] - self._lower[group.rows] < BINDS
            sides[group.rows[near]] = AT_LOWER
            sides[group.gap] = AT_LOWER
        bearing = Bearing(x, np.zeros(len(g)), sides, np.zeros(len(self._groups), bool))
        self._hold(bearing)
        gradient, jacobian, hessian = self._evaluation.derivatives(x, bearing.y)
        self._fill(bearing, 0.0 * hessian, jacobian)
        held = (sides != FREE)[self._kept]
        self._matrix.factorise(1.0, np.where(held, SHIFT, 1.0))
        return self._step(bearing, np.concatenate([-gradient, np.zeros(len(held))]), 0.0)

    def solve(
        self, bearing: Bearing, parameters: Array, *, tolerance: float, iterations: int
    ) -> Reached:
        """Solve from ``bearing``, an answer near by."""
        self._evaluation.at(parameters)
        self._hold(bearing)
        with np.errstate(all="ignore"):
            # What a poor step leads to is seen by its error.
            reached = self._solve(bearing, tolerance, iterations)
        if reached.status == STUCK:
            # Numbers that are not finite stay in the factors' memory.
            self._keep(self._kept)
        return reached

    def _solve(self, now: Bearing, tolerance: float, iterations: int) -> Reached:
        least: bool | None = None
        for iteration in range(iterations + 1):
            g = self._evaluation.value(now.x)[1]
            if iteration > 0:
                before, now = now, self._rebound(now, g)
                if np.any(before.sides != now.sides):
                    least = None
                    self._hold(now)
            right, error = self._system(now, g)
            if error <= tolerance and (pulling := self._pulling(now)).any():
                # An answer to the wrong question: without those rows, go on.
                now, least = self._without(now, pulling), None
                right, error = self._system(now, g)
            if error <= tolerance:
                # The matrix of the last step has the inertia of this one, if the rows are the same.
                least = self._factorise(now) if least is None else least
                return Reached(SOLVED if least else SADDLE, now, iteration, error)
            if not error < LOST:
                break
            least = self._factorise(now)
            if self._matrix.negative < 0:
                break
            now = self._step(now, right)
        else:
            return Reached(ITERATIONS, now, iterations, error)
        return Reached(STUCK, now, iteration, error)

    def _hold(self, now: Bearing) -> None:
        """See to it that every row that binds is in the matrix."""
        if np.any((now.sides != FREE) & ~self._kept):
            self._keep(self._kept | (now.sides != FREE))

    def _keep(self, rows: Flags) -> None:
        """Begin a new matrix with these rows (m,)."""
        pattern = self._evaluation.jacobian
        row, column = (np.asarray(v, np.int64) for v in pattern.get_triplet())
        self._kept, self._nonzeros = rows, np.flatnonzero(rows[row])
        place = np.cumsum(rows) - 1
        self._row = place[row[self._nonzeros]]
        kept = ca.Sparsity.triplet(
            int(np.count_nonzero(rows)), pattern.size2(),
            self._row.tolist(), column[self._nonzeros].tolist(),
        )  # fmt: skip
        self._matrix = KktMatrix(self._evaluation.hessian, kept)

    def _fill(self, now: Bearing, hessian: Array, jacobian: Array) -> None:
        held = (now.sides != FREE)[self._kept]
        self._matrix.fill(hessian, jacobian[self._nonzeros] * held[self._row])

    def _system(self, now: Bearing, g: Array) -> tuple[Array, float]:
        """Fill the matrix at ``now``; the right-hand side, and the error of the conditions."""
        gradient, jacobian, hessian = self._evaluation.derivatives(now.x, now.y)
        self._fill(now, hessian, jacobian)
        held = now.sides != FREE
        off = np.where(held, g - np.where(now.sides == AT_UPPER, self._upper, self._lower), 0.0)
        broken = np.maximum(self._lower - g, g - self._upper)[self._asked(now)]
        dual = gradient + self._matrix.transposed_times(now.y[self._kept])
        error = max(np.max(np.abs(v), initial=0.0) for v in (dual, off, np.maximum(broken, 0.0)))
        below = -off - np.where(held, SHIFT * now.y, 0.0)
        return np.concatenate([-gradient, below[self._kept]]), float(error)

    def _asked(self, now: Bearing) -> Flags:
        """Rows (m,) that are not left out with their groups."""
        asked = np.ones(len(self._lower), bool)
        for group, out in zip(self._groups, now.out, strict=True):
            asked[group.rows] = not out
        return asked

    def _factorise(self, now: Bearing) -> bool:
        """Whether the inertia is that of a least cost at least clearances."""
        shift = np.full(len(now.x), SHIFT)
        for group, out in zip(self._groups, now.out, strict=True):
            if out:
                shift[group.variables] = PINNED
        held = (now.sides != FREE)[self._kept]
        self._matrix.factorise(shift, np.where(held, SHIFT, 1.0))
        binding = int(np.count_nonzero(~now.out))
        return self._matrix.negative == len(held) + binding

    def _step(self, now: Bearing, right: Array, length: float = 1.0) -> Bearing:
        """A step of that share in x, with the multipliers of a whole one."""
        found, n = self._matrix.solve(right), len(now.x)
        y = np.zeros(len(now.y))
        y[self._kept] = found[n:]
        return replace(now, x=now.x + length * found[:n], y=np.where(now.sides != FREE, y, 0.0))

    def _rebound(self, now: Bearing, g: Array) -> Bearing:
        """Rows that pull are let go, those that are broken are held."""
        sides, loose = now.sides.copy(), ~self._equal & self._asked(now)
        for group, pulls in zip(self._groups, self._pulling(now), strict=True):
            # Its other multipliers have the wrong signs with it, and say nothing as yet.
            loose[group.gap] = False
            loose[group.rows] &= not pulls
        sides[loose & (now.sides != FREE) & (now.y * now.sides < -SLACK)] = FREE
        free = loose & (now.sides == FREE)
        sides[free & (g < self._lower - SLACK)] = AT_LOWER
        sides[free & (g > self._upper + SLACK)] = AT_UPPER
        return replace(now, sides=sides, y=np.where(sides != FREE, now.y, 0.0))

    def _pulling(self, now: Bearing) -> Flags:
        """The groups whose own row pulls."""
        gaps = np.array([group.gap for group in self._groups], dtype=np.int64)
        return ~now.out & (now.y[gaps] * now.sides[gaps] < -SLACK)

    def _without(self, now: Bearing, groups: Flags) -> Bearing:
        """Leave out these groups, for good."""
        sides = now.sides.copy()
        for group, out in zip(self._groups, groups, strict=True):
            if out:
                sides[group.rows] = FREE
        y = np.where(sides != FREE, now.y, 0.0)
        return Bearing(now.x, y, sides, now.out | groups)
