"""The largest ball in a set given by a conic form: a point well inside, or the lack of one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm, SecondOrderBlock
from berthing.geometry.conic_solver import minimise
from berthing.geometry.conic_standard import standard


def inscribed_ball(form: ConicForm, unit: float) -> tuple[Array, float]:
    """Centre x (dim,) and radius ρ of a ball inside the set, in metres; ρ < 0 for an empty set.

    Every row is to hold at x with ρ times its steepest slope to spare. That gives the largest
    ball for linear rows and round blocks, and a smaller one beside an elongated block.

    Args:
        form: of a bounded set, which may be flat or empty.
        unit: about the set's size, in metres.
    """
    steepest = np.linalg.norm(form.linear_A[:, : form.dim], axis=1)
    shrunk = replace(
        form,
        linear_A=np.column_stack([form.linear_A, steepest]),
        blocks=tuple(_shrunk(block, form.dim) for block in form.blocks),
        lift=form.lift + 1,
    )
    grow = np.zeros((1, shrunk.size))
    grow[0, -1] = -1.0
    best = minimise(standard(shrunk, unit), grow).point[0]
    return best[: form.dim], float(best[-1])


def _shrunk(block: SecondOrderBlock, dim: int) -> SecondOrderBlock:
    """The block with the ball's radius as its last variable."""
    slope = np.zeros(block.A.shape[1]) if block.slope is None else block.slope
    steepest = np.linalg.norm(block.A[:, :dim], 2) + np.linalg.norm(slope[:dim])
    A = np.column_stack([block.A, np.zeros(len(block.b))])
    return SecondOrderBlock(block.head, A, block.b, np.append(slope, -steepest))
