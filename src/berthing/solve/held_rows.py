"""Rows that hold apart what is near, by planes that may tilt a little.

A row n·(b - a) of two points serves where one of the sets touches its plane in one point. Where
both lie along it with several, the plane itself stands between: all points of A below it, all of B
above, m + n rows in place of m n.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy import sparse

from berthing.geometry.arrays import Array
from berthing.geometry.body import Part
from berthing.scenario.pair import Pair
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.solve.contacts import Side, contacts, sides_of
from berthing.solve.held_planes import Around, Near
from berthing.solve.samples import Samples
from berthing.transcription.elements import Index

FREE = np.inf
"""By how much a plane may shift: its rows bound it."""

NONE = -1


@dataclass(frozen=True)
class HeldRows:
    """Rows gap + slope (places δ) + plane (turns and shifts) + slack ≥ 0, in the programme's
    length.

    Attributes:
        gap: (m,). slope: (m, p) by what places bodies at the instants where they are near.
        places: (p, n) that, by the stored variables.
        group: (m,) rows of one pair at one instant share a slack, of ``groups``; -1 where none.
        plane: (m, t) slope by tilts and shifts of planes.
        most: (t,) of each, to either side.
    """

    gap: Array
    slope: sparse.csr_matrix
    places: sparse.csr_matrix
    group: Index
    groups: int
    plane: sparse.csr_matrix
    most: Array


def held_rows(samples: Samples, around: Around, tilt: float, tilted_m: float) -> HeldRows:
    """Rows for all that is near.

    Args:
        tilt: of the planes, at most, and of the normals that find further points, rad.
        tilted_m: planes of pairs that keep more than this beyond their margin do not tilt.
    """
    lines = _Lines(samples, around)
    first = 0
    for one in around.near:
        pair = samples.problem.pairs[one.pair]
        touching = contacts(*_sides(pair, one), tilt, one.short_m > -tilted_m)
        if len(touching.pairs[0]):
            lines.between(first, pair, one, *touching.pairs)
        if len(touching.of_a[0]):
            lines.below(first, pair, one, *touching.of_a)
            lines.above(first, pair, one, *touching.of_b)
        first += len(one.at)
    return lines.rows(first, tilt)


@dataclass
class _Lines:
    """Rows as they come."""

    samples: Samples
    around: Around
    count: int = 0
    gap: list[Array] = field(default_factory=list)
    owner: list[Index] = field(default_factory=list)
    slack: list[Index] = field(default_factory=list)
    reach: list[Array] = field(default_factory=list)
    shift: list[Array] = field(default_factory=list)
    entries: list[tuple[Index, Index, Array]] = field(default_factory=list)

    def between(
        self, first: int, pair: Pair, one: Near, which: Index, va: Array, vb: Array
    ) -> None:
        """A point of A and one of B, with nothing between them but the plane's normal."""
        reach = one.pose_b[which].apply(vb) - one.pose_a[which].apply(va)
        lines = self._add(first, one, which, reach, one.required_m[which], 0.0, slack=True)
        self._moves(pair.owner_a, pair.part_a, lines, one, which, -1.0, va)
        self._moves(pair.owner_b, pair.part_b, lines, one, which, 1.0, vb)

    def below(self, first: int, pair: Pair, one: Near, which: Index, va: Array) -> None:
        """A point of A, which the plane is above."""
        a = one.pose_a[which]
        reach = a.apply(one.point_a[which]) - a.apply(va)
        lines = self._add(first, one, which, reach, np.zeros(len(which)), 1.0, slack=False)
        self._moves(pair.owner_a, pair.part_a, lines, one, which, -1.0, va)

    def above(self, first: int, pair: Pair, one: Near, which: Index, vb: Array) -> None:
        """A point of B, above the plane by the margin."""
        reach = one.pose_b[which].apply(vb) - one.pose_a[which].apply(one.point_a[which])
        lines = self._add(first, one, which, reach, one.required_m[which], -1.0, slack=True)
        self._moves(pair.owner_b, pair.part_b, lines, one, which, 1.0, vb)

    def _add(
        self, first: int, one: Near, which: Index, reach: Array, required_m: Array, shift: float,
        *, slack: bool,
    ) -> Index:  # fmt: skip
        count = len(which)
        self.gap.append(np.sum(one.normal[which] * reach, axis=-1) - required_m)
        self.owner.append(first + which)
        self.slack.append(first + which if slack else np.full(count, NONE))
        self.reach.append(reach)
        self.shift.append(np.full(count, shift))
        self.count += count
        return np.arange(self.count - count, self.count)

    def _moves(
        self, owner: Vehicle | Structure, part: Part, lines: Index, one: Near, which: Index,
        sign: float, v: Array,
    ) -> None:  # fmt: skip
        """The slope of ± n·(point v of the part), where it can move."""
        if isinstance(owner, Structure):
            return
        at, n = one.at[which], sign * one.normal[which]
        body = part.placement.apply(v)
        by_turn = (body[:, :, None] * n[:, None, :]).reshape(len(n), -1)
        by_pose = np.concatenate([n, by_turn], axis=-1)
        slopes = self.around.placed.slopes[owner.name][at]
        slope = np.asarray(by_pose[:, None, :] @ slopes)[:, 0]
        columns = self.samples.places(owner.name, at)
        rows = np.broadcast_to(lines[:, None], columns.shape)
        self.entries.append((rows.ravel(), columns.ravel(), slope.ravel()))

    def rows(self, groups: int, tilt: float) -> HeldRows:
        length_m = self.samples.problem.layout.scale.length_m
        gap = np.concatenate([np.empty(0), *self.gap])
        slack = np.concatenate([np.empty(0, np.int64), *self.slack])
        slope = _matrix(self.entries, (self.count, self.samples.size), length_m)
        used = np.unique(slope.indices)
        plane, most = self._planes(groups, tilt, length_m)
        places = self.samples.interpolation[used]
        return HeldRows(gap / length_m, slope[:, used], places, slack, groups, plane, most)

    def _planes(self, groups: int, tilt: float, length_m: float) -> tuple[sparse.csr_matrix, Array]:
        """Slopes (m, t) by tilts and shifts of the planes that have more than one row; bounds."""
        if not self.count:
            return sparse.csr_matrix((0, 0)), np.empty(0)
        owner, shift = np.concatenate(self.owner), np.concatenate(self.shift)
        reach = np.concatenate(self.reach)
        several = np.bincount(owner, minlength=groups) > 1
        shifts = np.bincount(owner, np.abs(shift), minlength=groups) > 0.0
        sides = sides_of(np.concatenate([one.normal for one in self.around.near]))
        tilts = len(sides) * int(np.sum(several))
        entries = []
        lines = np.flatnonzero(several[owner])
        number = (np.cumsum(several) - 1)[owner[lines]]
        for k, side in enumerate(sides):
            value = np.sum(side[owner[lines]] * reach[lines], axis=-1)
            entries.append((lines, len(sides) * number + k, value))
        lines = np.flatnonzero(shift)
        number = (np.cumsum(shifts) - 1)[owner[lines]]
        entries.append((lines, tilts + number, length_m * shift[lines]))
        free = int(np.sum(shifts))
        plane = _matrix(entries, (self.count, tilts + free), length_m)
        return plane, np.concatenate([np.full(tilts, tilt), np.full(free, FREE)])


def _sides(pair: Pair, one: Near) -> tuple[Side, Side]:
    a, b = one.pose_a.unrotate(one.normal), one.pose_b.unrotate(-one.normal)
    return Side(pair.part_a.shape, a, one.point_a), Side(pair.part_b.shape, b, one.point_b)


def _matrix(
    entries: list[tuple[Index, Index, Array]], shape: tuple[int, int], length_m: float
) -> sparse.csr_matrix:
    if not entries:
        return sparse.csr_matrix(shape)
    rows, columns, values = (np.concatenate(v) for v in zip(*entries, strict=True))
    return sparse.csr_matrix((values / length_m, (rows, columns)), shape)
