"""The user's path constraints g(t, x, u) ≤ 0 at every instant, not only at the nodes.

On a piece of a segment g is enclosed three ways: by its values over the whole piece, by the value
at the middle and the slopes over the piece, and by value and slope at the middle and the second
derivatives over the piece; the least upper bound counts. Pieces that it leaves in doubt are
halved.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.path_constraint import PathConstraint
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import Segment, VehicleTrajectory
from berthing.verify.chebyshev import padded, split
from berthing.verify.enclosed_state import Polynomials, clock
from berthing.verify.limits import Excess
from berthing.verify.taylor import Taylor, constant
from berthing.verify.taylor_xp import TAYLOR

ORDER = 2

MAX_PIECES = 20_000
"""Doubtful pieces at one depth; where there are more, the first of them counts as a fault."""

SHORTEST_S = 1e-9
"""Nor is a piece halved below this: g then jumps there, or has no bound."""


def path_excesses(vehicle: Vehicle, trajectory: VehicleTrajectory) -> list[Excess]:
    """Every row of every constraint that goes above zero by more than its tolerance.

    Raises:
        InputError: the user's function fails.
    """
    found = []
    for constraint in vehicle.path_constraints:
        worst = _above(constraint, trajectory.segments)
        if worst is not None:
            row, time, value = worst
            name = f"path {constraint.name}" + (f" {row}" if row else "")
            found.append(Excess(vehicle.name, name, time, value, 0.0))
    return found


def _above(
    constraint: PathConstraint, segments: Sequence[Segment]
) -> tuple[int, float, float] | None:
    """Row, time and value of the largest sample beyond the tolerance, or of a piece in doubt."""
    t0, t1 = (np.array([getattr(s, end) for s in segments]) for end in ("t0_s", "t1_s"))
    nx = segments[0].state.shape[1]
    pieces = t0, t1, padded([_joined(s) for s in segments])
    while len(pieces[0]):
        whole = Polynomials.of(*pieces, ORDER)
        middle = 0.5 * (whole.t0_s + whole.t1_s)
        over = _values(constraint, clock(whole.t0_s, whole.t1_s, ORDER), whole.over(), nx)
        cells = np.arange(len(middle))
        at = _values(constraint, clock(middle, middle, ORDER), whole.at(middle, cells), nx)
        samples = at.terms[0].middle
        row, worst = np.unravel_index(int(np.argmax(samples)), samples.shape)
        # Written so that NaN fails too.
        if not samples[row, worst] <= constraint.tolerance:
            return int(row), float(middle[worst]), float(samples[row, worst])
        bound = _upper(over, at, 0.5 * (whole.t1_s - whole.t0_s))
        doubtful = ~(np.max(bound, axis=0) <= constraint.tolerance)
        left = [part[doubtful] for part in pieces]
        if np.count_nonzero(doubtful) > MAX_PIECES or np.any(left[1] - left[0] < SHORTEST_S):
            first = int(np.argmax(doubtful))
            high = int(np.argmax(bound[:, first]))
            return high, float(middle[first]), float(bound[high, first])
        pieces = split(left[0], left[1], left[2], np.full(len(left[0]), 2))
    return None


def _joined(segment: Segment) -> Array:
    """Coefficients of state and control side by side (degree + 1, nx + nu)."""
    count = max(len(segment.state), len(segment.control))
    columns = [np.pad(c, ((0, count - len(c)), (0, 0))) for c in (segment.state, segment.control)]
    return np.hstack(columns)


def _values(constraint: PathConstraint, t: Taylor, columns: Taylor, nx: int) -> Taylor:
    with np.errstate(all="ignore"):
        g = constraint.function(t, columns[:nx], columns[nx:], TAYLOR)
    # Adding zeros spreads rows that are the same at all times over all pieces.
    return constant(g, ORDER) + t * 0.0


def _upper(over: Taylor, at: Taylor, half: Array) -> Array:
    """Upper bounds (m, n) over pieces of half-lengths (n,)."""
    value, slope = (term.middle for term in at.terms[:2])
    slopes, bends = (term.size for term in over.terms[1:3])
    first = value + slopes * half
    second = value + np.abs(slope) * half + bends * half**2
    with np.errstate(invalid="ignore"):
        return np.asarray(np.fmin(np.fmin(over.terms[0].high, first), second))
