"""Conic forms put to Clarabel, a solver of its own kind."""

from __future__ import annotations

from typing import Any

import clarabel
import numpy as np
from scipy import sparse

from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm


def cone_rows(form: ConicForm, columns: int, first: int) -> tuple[Any, Any, list[Any]]:
    """Rows R, offsets o and cones K of the set {z : R z + o in K} among more variables."""
    rows, offsets, cones = [np.zeros((0, columns))], [np.zeros(0)], []

    def wide(A: Array) -> Array:
        spread = np.zeros((len(A), columns))
        spread[:, first : first + form.size] = A
        return spread

    if len(form.linear_b):
        rows.append(-wide(form.linear_A))
        offsets.append(form.linear_b)
        cones.append(clarabel.NonnegativeConeT(len(form.linear_b)))
    for block in form.blocks:
        slope = np.zeros(form.size) if block.slope is None else block.slope
        rows += [wide(slope[None]), wide(block.A)]
        offsets += [np.array([block.head]), block.b]
        cones.append(clarabel.SecondOrderConeT(1 + len(block.b)))
    return np.concatenate(rows), np.concatenate(offsets), cones


def solved(cost: Array, rows: Array, offsets: Array, cones: list[Any]) -> float:
    """min cost·z with R z + o in K, by Clarabel."""
    return solution(cost, rows, offsets, cones)[0]


def solution(
    cost: Array, rows: Array, offsets: Array, cones: list[Any], tolerance: float = 1e-8
) -> tuple[float, Array]:
    """min cost·z with R z + o in K and the z that attains it, by Clarabel."""
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    settings.tol_gap_abs = settings.tol_gap_rel = settings.tol_feas = tolerance
    count = len(cost)
    problem = sparse.csc_matrix(-rows), offsets, cones, settings
    answer = clarabel.DefaultSolver(sparse.csc_matrix((count, count)), cost, *problem).solve()
    assert answer.status == clarabel.SolverStatus.Solved
    return float(answer.obj_val), np.array(answer.x)
