"""Conic forms of sets made from others: moved, cut out of each other, padded."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm, SecondOrderBlock
from berthing.geometry.pose import Pose

Columns = npt.NDArray[np.int64]


def placed(form: ConicForm, pose: Pose) -> ConicForm:
    """The form of a set moved to a single pose: x_own = Rᵀ (x − r) put into every row."""

    def moved(rows: Array) -> Array:
        own, lifted = np.split(rows, [form.dim], axis=-1)
        return np.concatenate([own @ pose.rotation.T, lifted], axis=-1)

    def block(old: SecondOrderBlock) -> SecondOrderBlock:
        A = moved(old.A)
        b = old.b - A[:, : form.dim] @ pose.position
        if old.slope is None:
            return SecondOrderBlock(old.head, A, b)
        slope = moved(old.slope)
        return SecondOrderBlock(old.head - float(slope[: form.dim] @ pose.position), A, b, slope)

    linear_A = moved(form.linear_A)
    linear_b = form.linear_b + linear_A[:, : form.dim] @ pose.position
    return ConicForm(form.dim, linear_A, linear_b, tuple(map(block, form.blocks)), form.lift)


def intersected(forms: Sequence[ConicForm]) -> ConicForm:
    """The form of the points that lie in all of the sets: every row of all, lifts kept apart."""
    dim, lift = forms[0].dim, sum(form.lift for form in forms)
    rows, offsets, blocks = [np.zeros((0, dim + lift))], [np.zeros(0)], []
    before = 0
    for form in forms:
        columns = np.r_[0:dim, dim + before : dim + before + form.lift]
        rows.append(spread(form.linear_A, columns, dim + lift))
        offsets.append(form.linear_b)
        blocks += [spread_block(block, columns, dim + lift) for block in form.blocks]
        before += form.lift
    return ConicForm(dim, np.concatenate(rows), np.concatenate(offsets), tuple(blocks), lift)


def padded(form: ConicForm, radius: float) -> ConicForm:
    """The form of the points within ``radius`` of the set; the nearest member helps."""
    dim, size = form.dim, form.dim + form.size
    columns = np.arange(dim, size)
    away = np.concatenate([np.eye(dim), -np.eye(dim), np.zeros((dim, form.lift))], axis=1)
    blocks = [SecondOrderBlock(radius, away, np.zeros(dim))]
    blocks += [spread_block(block, columns, size) for block in form.blocks]
    rows = spread(form.linear_A, columns, size)
    return ConicForm(dim, rows, form.linear_b, tuple(blocks), form.size)


def joined(forms: Sequence[ConicForm], dim: int, lift: int) -> ConicForm:
    """The rows of several sets side by side, then ``lift`` more variables without rows.

    All variables of the first set come first, its helping ones included; ``dim`` of them count
    as the form's own.
    """
    size = sum(form.size for form in forms) + lift
    rows, offsets, blocks, before = [np.zeros((0, size))], [np.zeros(0)], [], 0
    for form in forms:
        columns = np.arange(before, before + form.size)
        rows.append(spread(form.linear_A, columns, size))
        offsets.append(form.linear_b)
        blocks += [spread_block(block, columns, size) for block in form.blocks]
        before += form.size
    return ConicForm(dim, np.concatenate(rows), np.concatenate(offsets), tuple(blocks), size - dim)


def spread(rows: Array, columns: Columns, size: int) -> Array:
    """Rows (..., k) as rows (..., size) that are zero but at ``columns`` (k,)."""
    wide = np.zeros((*rows.shape[:-1], size))
    wide[..., columns] = rows
    return wide


def spread_block(block: SecondOrderBlock, columns: Columns, size: int) -> SecondOrderBlock:
    """The block on the chosen ones of ``size`` variables."""
    slope = None if block.slope is None else spread(block.slope, columns, size)
    return SecondOrderBlock(block.head, spread(block.A, columns, size), block.b, slope)
