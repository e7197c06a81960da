"""One convex sub-problem: rows linearised, separation elastic, every pose within a trust region."""

from __future__ import annotations

from dataclasses import dataclass

import clarabel
import numpy as np
from scipy import sparse

from berthing.geometry.arrays import Array
from berthing.solve.held_planes import HeldRows

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
    n, slacks, tilts = len(at.gradient), held.groups, held.tilt.shape[1]
    equal = np.flatnonzero(at.lower == at.upper)
    above = np.flatnonzero((at.lower < at.upper) & np.isfinite(at.upper))
    below = np.flatnonzero((at.lower < at.upper) & np.isfinite(at.lower))
    near = np.flatnonzero(np.isfinite(trust))
    box = sparse.csr_matrix((np.ones(len(near)), (np.arange(len(near)), near)), (len(near), n))
    m = len(held.gap)
    group = sparse.csr_matrix((-np.ones(m), (np.arange(m), held.group)), (m, slacks))
    J, eye = at.jacobian, sparse.identity(slacks, format="csr")
    tilt = sparse.identity(tilts, format="csr")
    plain = sparse.vstack([J[equal], J[above], -J[below], box, -box])
    blocks = [[plain, None, None], [-held.slope, -held.tilt, group], [None, None, -eye]]
    blocks += [[None, tilt, None], [None, -tilt, None]] if tilts else []
    matrix = sparse.bmat(blocks if slacks else [[plain]], format="csc")
    right = np.concatenate([
        at.lower[equal], at.upper[above], -at.lower[below], trust[near], trust[near],
        held.gap, np.zeros(slacks), np.full(2 * tilts, held.most),
    ])  # fmt: skip
    cones = [
        clarabel.ZeroConeT(len(equal)),
        clarabel.NonnegativeConeT(len(right) - len(equal)),
    ]
    curvature = np.concatenate([at.curvature, np.full(tilts, HELD), np.zeros(slacks)])
    hessian = sparse.diags(curvature, format="csc")
    linear = np.concatenate([at.gradient, np.zeros(tilts), np.full(slacks, penalty)])
    answer = clarabel.DefaultSolver(
        hessian, linear, matrix, right, cones, _settings(seconds)
    ).solve()
    if str(answer.status) not in SOLVED:
        return None
    x, z = np.array(answer.x), np.array(answer.z)
    multipliers = np.zeros(len(at.lower))
    ends = np.cumsum([len(equal), len(above), len(below)])
    multipliers[equal] += z[: ends[0]]
    multipliers[above] += z[ends[0] : ends[1]]
    multipliers[below] -= z[ends[1] : ends[2]]
    change = x[:n]
    descent = -float(at.gradient @ change + 0.5 * at.curvature @ change**2)
    return Step(change, descent, penalty * float(np.sum(x[n + tilts :])), multipliers)


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
