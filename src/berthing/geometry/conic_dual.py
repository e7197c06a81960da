"""Support values of conic forms from their duals: the multipliers that attain them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.conic_solver import minimise
from berthing.geometry.conic_standard import is_flat, standard
from berthing.geometry.convex_set import norm, unit


@dataclass(frozen=True, eq=False)
class SupportMultipliers:
    """The dual of ``ConicForm`` at k directions, as its docstring has it.

    Attributes:
        lines: λ (k, m).
        heads: τ (k, blocks).
        tails: u of each block (k, rows).
    """

    lines: Array
    heads: Array
    tails: tuple[Array, ...]


def support_multipliers(form: ConicForm, size: float, n: Array) -> SupportMultipliers:
    """Multipliers at directions n (k, dim) of any length, zero included; they sum to 1e-9 of n.

    Args:
        form: of a set with an interior.
        size: the set's bounding radius in metres; infinite for a half-space, whose directions are
            taken for their parts along its normal.
    """
    if not np.isfinite(size):
        return SupportMultipliers(
            np.maximum(n @ form.linear_A[:, : form.dim].T, 0.0), np.zeros((len(n), 0)), ()
        )
    problem, rays, lengths = standard(form, size), unit(n), norm(n)
    objective = np.zeros((len(n), form.size))
    objective[:, : form.dim] = -rays
    some = lengths > 0.0
    # A direction of no length has no optimum; any other stands in, and is taken times zero.
    objective[~some, 0] = -1.0
    best = minimise(problem, objective)
    lines = best.line_dual * (size / problem.line_scale) * lengths[:, None]
    cones = best.cone_dual * (size / problem.cone_scale)[:, None] * lengths[:, None, None]
    heads, tails = [], []
    slab, cone, own = 0, 0, len(form.linear_b)
    for block in form.blocks:
        if is_flat(block):
            upper, lower = lines[:, own + slab], lines[:, own + slab + 1]
            tails.append((upper - lower)[:, None])
            heads.append(upper + lower)
            slab += 2
        else:
            tails.append(-cones[:, cone, 1 : 1 + len(block.b)])
            heads.append(np.maximum(cones[:, cone, 0], norm(tails[-1])))
            cone += 1
    return SupportMultipliers(
        lines[:, :own], np.array(heads).T.reshape(len(n), len(form.blocks)), tuple(tails)
    )
