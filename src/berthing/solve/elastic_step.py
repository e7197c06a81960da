"""One convex sub-problem: rows linearised, separation elastic, every pose within a trust region."""

from __future__ import annotations

from dataclasses import dataclass

import clarabel
import numpy as np
from scipy import sparse

from berthing.geometry.arrays import Array
from berthing.solve.held_rows import HeldRows

GAP, FEASIBILITY = 1e-4, 1e-6
"""Relative: the next step makes up for what this one leaves."""

HELD = 1e-6
"""Curvature of tilts: it holds those that nothing asks for."""

SOLVED = frozenset({"Solved", "AlmostSolved"})


@dataclass(frozen=True)
class Linearised:
    """A programme at a point: min gradient·δ + δᵀ H δ / 2, lower ≤ g + J δ ≤ upper.

    Attributes:
        curvature: (n,) the diagonal H, not negative.
        jacobian: (m, n). lower, upper: (m,) less g.
    """

    gradient: Array
    curvature: Array
    jacobian: sparse.csr_matrix
    lower: Array
    upper: Array


@dataclass(frozen=True)
class Step:
    """A step and what it promises.

    Attributes:
        change: δ (n,). descent: of the quadratic model along it. penalty: of the slacks it leaves.
        multipliers: (m,) of the rows, of f + yᵀ g.
    """

    change: Array
    descent: float
    penalty: float
    multipliers: Array


def elastic_step(
    at: Linearised, held: HeldRows, penalty: float, trust: Array, seconds: float
) -> Step | None:
    """The best step; None where the rows themselves allow none.

    Args:
        penalty: of a unit of slack.
        trust: (n,) by how much each variable may change; infinite where it may by any amount.
        seconds: wall time allowed.
    """
    n, slacks, tilts = len(at.gradient), held.groups, held.plane.shape[1]
    equal = np.flatnonzero(at.lower == at.upper)
    above = np.flatnonzero((at.lower < at.upper) & np.isfinite(at.upper))
    below = np.flatnonzero((at.lower < at.upper) & np.isfinite(at.lower))
    near = np.flatnonzero(np.isfinite(trust))
    J, m, p = at.jacobian, len(held.gap), held.places.shape[0]
    box, slack, tilt, place = (sparse.identity(k, format="csr") for k in (n, slacks, tilts, p))
    sharing, leaning = np.flatnonzero(held.group >= 0), np.flatnonzero(np.isfinite(held.most))
    entries = np.ones(len(sharing)), (sharing, held.group[sharing])
    group = sparse.csr_matrix(entries, (m, slacks))
    # What places a body at an instant stands for itself: many rows share it, and each is short.
    blocks = [
        [J[equal], None, None, None],
        [held.places, None, None, -place],
        [sparse.vstack([J[above], -J[below], box[near], -box[near]]), None, None, None],
        [None, -held.plane, -group, -held.slope],
        [None, sparse.vstack([tilt[leaning], -tilt[leaning]]), None, None],
        [None, None, -slack, None],
    ]
    matrix = sparse.bmat(blocks, format="csc")
    right = np.concatenate([
        at.lower[equal], np.zeros(p), at.upper[above], -at.lower[below], trust[near], trust[near],
        held.gap, held.most[leaning], held.most[leaning], np.zeros(slacks),
    ])  # fmt: skip
    cones = [
        clarabel.ZeroConeT(len(equal) + p),
        clarabel.NonnegativeConeT(len(right) - len(equal) - p),
    ]
    free = np.zeros(slacks + p)
    curvature = np.concatenate([at.curvature, np.full(tilts, HELD), free])
    hessian = sparse.diags(curvature, format="csc")
    linear = np.concatenate([at.gradient, np.zeros(tilts), np.full(slacks, penalty), np.zeros(p)])
    answer = clarabel.DefaultSolver(
        hessian, linear, matrix, right, cones, _settings(seconds)
    ).solve()
    if str(answer.status) not in SOLVED:
        return None
    x, z = np.array(answer.x), np.array(answer.z)
    multipliers = np.zeros(len(at.lower))
    ends = np.cumsum([len(equal) + p, len(above), len(below)])
    multipliers[equal] += z[: len(equal)]
    multipliers[above] += z[ends[0] : ends[1]]
    multipliers[below] -= z[ends[1] : ends[2]]
    change = x[:n]
    descent = -float(at.gradient @ change + 0.5 * at.curvature @ change**2)
    overlap = float(np.sum(x[n + tilts : n + tilts + slacks]))
    return Step(change, descent, penalty * overlap, multipliers)


def _settings(seconds: float) -> clarabel.DefaultSettings:
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    settings.max_threads = 1
    settings.time_limit = seconds
    settings.tol_gap_abs = settings.tol_gap_rel = GAP
    settings.tol_feas = FEASIBILITY
    # At these tolerances it takes a fifth of the time and gains nothing.
    settings.iterative_refinement_enable = False
    settings.presolve_enable = settings.chordal_decomposition_enable = False
    settings.direct_solve_method = "qdldl"
    return settings
