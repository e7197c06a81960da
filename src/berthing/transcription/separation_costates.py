"""Multipliers of the separation rows, and what they do to the costates."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.trajectory import SeparationCostate
from berthing.transcription.problem import Problem
from berthing.transcription.sites import Site

NEGLIGIBLE = 1e-9
"""Of the largest multiplier: rows below are not listed."""


def separation_costates(
    problem: Problem, x: Array, parameters: Array, multipliers: Array, duration_s: float
) -> tuple[SeparationCostate, ...]:
    """Every separation row with its multiplier, in order of time.

    The rows of one site act on the motion through the pose there, by the multipliers of all of them
    (the distance's and those of its support functions) times their gradients.
    """
    sites = problem.separation.sites
    rows = list(zip(problem.separation.rows, sites, strict=True))
    rows += [(sweep.row, sites[sweep.last]) for sweep in problem.sweeps]
    if not rows:
        return ()
    cost, length = problem.layout.scale.cost, problem.layout.scale.length_m
    jacobian = problem.nlp["jac_g"](x, parameters)[1].sparse().tocsr()
    force = -multipliers[[row for row, _ in rows]]
    found = []
    for (row, site), value in zip(rows, force, strict=True):
        if abs(value) <= NEGLIGIBLE * np.max(np.abs(force)):
            continue
        block = problem.layout.rows.block_of(row)
        own = slice(block.offset, block.offset + block.size)
        pull = np.asarray(jacobian[own].T @ multipliers[own])
        fraction = problem.mesh.fraction(site.segment, site.s)
        found.append(
            SeparationCostate(
                problem.phase.name,
                problem.pairs[site.pair].name,
                problem.layout.t0_s + duration_s * fraction,
                float(value) * cost / length,
                {name: cost * jump for name, jump in _jumps(problem, site, pull).items()},
            )
        )
    return tuple(sorted(found, key=lambda own: own.time_s))


def _jumps(problem: Problem, site: Site, pull: Array) -> dict[str, Array]:
    """``pull`` on the native state of every vehicle at a site, in the programme's cost."""
    points, _ = problem.layout.interpolation(site.segment, site.s)
    out = {}
    for name, owner in problem.layout.vehicles.items():
        jump = np.zeros(owner.nx)
        columns = list(owner.pose_columns)
        if len(points) == 1:
            indices = owner.state.indices[columns, points[0]]
        elif (name, site.segment, site.s) in problem.separation.lifted:
            block = problem.separation.lifted[(name, site.segment, site.s)]
            indices = problem.layout.variables.blocks[block].indices.ravel()
        else:
            continue
        jump[columns] = pull[indices] / owner.scale.state[columns]
        if np.any(jump):
            out[name] = jump
    return out
