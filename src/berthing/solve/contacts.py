"""Points in which a plane touches a convex set, or may when it tilts a little."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.clearance.signed_distance import Flags
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet
from berthing.transcription.elements import Index

ROUND = 0.25
"""Of the tilt: a point that a tilted normal finds so far down, as a share of its distance, lies on
a round side; half the tilt is what balls have."""

SAME_POINT_M = 1e-6
"""Support points nearer than this to each other are one."""


@dataclass(frozen=True)
class Side:
    """One set of a pair at m instants, in its own frame.

    Attributes:
        normal: unit (m, d), towards the other set.
        point: (m, d), nearest to the other set.
    """

    shape: ConvexSet
    normal: Array
    point: Array

    def at(self, which: Index) -> Side:
        """The set at some of the instants."""
        return Side(self.shape, self.normal[which], self.point[which])


@dataclass(frozen=True)
class Contacts:
    """Points, in their own frames, that a plane between two sets has to part; none twice.

    Attributes:
        pairs: (which of the instants, points of A, points of B).
        of_a, of_b: (which of the instants, points), where both sides have several: all of A's are
            to be parted from all of B's.
    """

    pairs: tuple[Index, Array, Array]
    of_a: tuple[Index, Array]
    of_b: tuple[Index, Array]


def contacts(a: Side, b: Side, tilt: float, tilted: Flags) -> Contacts:
    """The nearest points, and where tilted normals find others, those in their place.

    Args:
        tilt: of the normals, at most, rad.
        tilted: (m,) where they are asked for.
    """
    whole, leaning = np.arange(len(tilted)), np.flatnonzero(tilted)
    none = whole[:0], a.point[:0]
    if not len(leaning) or tilt <= 0.0:
        return Contacts((whole, a.point, b.point), none, none)
    of_a, of_b = _touching(a.at(leaning), tilt), _touching(b.at(leaning), tilt)
    several_a, several_b = (np.sum([new for new, _ in side], axis=0) > 1 for side in (of_a, of_b))
    either, both = several_a ^ several_b, several_a & several_b
    single = np.ones(len(whole), dtype=bool)
    single[leaning[several_a | several_b]] = False
    pairs = [(whole[single], a.point[single], b.point[single])]
    if np.any(either):
        for new_a, va in of_a:
            for new_b, vb in of_b:
                which = np.flatnonzero(new_a & new_b & either)
                pairs.append((leaning[which], va[which], vb[which]))
    which, va, vb = (np.concatenate(each) for each in zip(*pairs, strict=True))
    if not np.any(both):
        return Contacts((which, va, vb), none, none)
    return Contacts((which, va, vb), _where(both, of_a, leaning), _where(both, of_b, leaning))


def _where(both: Flags, side: list[tuple[Flags, Array]], leaning: Index) -> tuple[Index, Array]:
    which = [np.flatnonzero(new & both) for new, _ in side]
    points = [v[at] for at, (_, v) in zip(which, side, strict=True)]
    return leaning[np.concatenate(which)], np.concatenate(points)


def _touching(side: Side, tilt: float) -> list[tuple[Flags, Array]]:
    """Points (m, d) in which a plane tilted by up to ``tilt`` may touch the shape, each with flags
    (m,) of where it is one more: corners of an edge or a face that lies along the plane.

    Of a round shape those move little across and drop as little: there the nearest point will do.
    """
    found: list[tuple[Flags, Array]] = []
    n, point = side.normal, side.point
    for lean in _across(n):
        v = side.shape.support(n + tilt * lean)[1]
        new = np.ones(len(n), dtype=bool)
        for old_new, old in found:
            new &= ~(old_new & (np.max(np.abs(v - old), axis=-1) <= SAME_POINT_M))
        found.append((new, v))
    apart = [np.linalg.norm(v - point, axis=-1) for _, v in found]
    drops = [np.sum(n * (point - v), axis=-1) for _, v in found]
    flat = np.zeros(len(n), dtype=bool)
    for far, drop in zip(apart, drops, strict=True):
        flat |= (far > SAME_POINT_M) & (drop <= ROUND * tilt * far)
    # Where the shape is round, or a corner touches, the point itself stands alone. Where it is
    # round to one side only, as a cylinder that lies on its side, none of those found is as near.
    lowest = np.min(drops, axis=0)
    found = [(new & flat, v) for new, v in found]
    found.append((~flat | (lowest > SAME_POINT_M), point))
    return found


def _across(n: Array) -> list[Array]:
    """Vectors (m, d) across unit vectors n to all sides: two in the plane, four in space."""
    sides = sides_of(n)
    if len(sides) == 1:
        return [sides[0], -sides[0]]
    u, w = sides
    return [u + w, u - w, w - u, -u - w]


def sides_of(n: Array) -> list[Array]:
    """Unit vectors (m, d) across unit vectors n and each other: one in the plane, two in space."""
    if n.shape[-1] == 2:
        return [np.stack([-n[:, 1], n[:, 0]], axis=-1)]
    other = np.where(np.abs(n[:, :1]) < 0.6, [[1.0, 0.0, 0.0]], [[0.0, 1.0, 0.0]])
    u = np.cross(n, other)
    u /= np.linalg.norm(u, axis=-1, keepdims=True)
    return [u, np.cross(n, u)]
