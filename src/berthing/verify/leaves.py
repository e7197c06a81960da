"""What the bisection ends with, and when it gives up."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from enum import IntEnum
from typing import Self

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.body_motion import Index, Mask
from berthing.verify.settings import CertificateSettings


class Status(IntEnum):
    """How an interval was closed."""

    CERTIFIED = 0
    SHORT = 1
    UNDECIDED = 2


@dataclass(frozen=True)
class Rows:
    """Arrays of one length, taken and joined together; a base of dataclasses."""

    def take(self, which: Mask | Index) -> Self:
        """The rows where ``which`` (k,) holds, or those of these numbers."""
        return type(self)(*(getattr(self, f.name)[which] for f in fields(self)))

    @classmethod
    def join(cls, parts: list[Self]) -> Self:
        """One after the other."""
        names = [f.name for f in fields(cls)]
        return cls(*(np.concatenate([getattr(p, name) for p in parts]) for name in names))


@dataclass(frozen=True)
class Intervals(Rows):
    """Intervals (k,) still open.

    Attributes:
        pair: index of the pair of parts.
        t0, t1: ends (s).
        required: clearance asked for (m).
        values: plane bounds at the ends (k, 2) in m, NaN where not asked yet.
        normals: unit normals at the ends (k, 2, 3), B's frame.
    """

    pair: Index
    t0: Array
    t1: Array
    required: Array
    values: Array
    normals: Array

    def __len__(self) -> int:
        return len(self.pair)

    @property
    def middle(self) -> Array:
        """Of each (k,)."""
        return 0.5 * (self.t0 + self.t1)

    def blocks(self, size: int) -> Iterator[Intervals]:
        """The same, at most ``size`` at a time."""
        for start in range(0, len(self), size):
            yield self.take(np.arange(start, min(start + size, len(self))))

    @staticmethod
    def unasked(pair: Index, t0: Array, t1: Array, required: Array) -> Intervals:
        """Intervals of whose ends nothing is known."""
        k = len(pair)
        return Intervals(pair, t0, t1, required, np.full((k, 2), np.nan), np.zeros((k, 2, 3)))


@dataclass(frozen=True)
class Leaves(Rows):
    """Closed intervals (k,), contiguous in time for each pair once sorted.

    Attributes:
        pair, t0, t1, required: as in ``Intervals``.
        bound: proven lower bound on the clearance of what flies over the whole interval (m).
        normals: those that prove it: n at both ends (k, 2, 3), B's frame, linear between; equal
            where one normal serves the whole interval.
        status: of ``Status``.
    """

    pair: Index
    t0: Array
    t1: Array
    required: Array
    bound: Array
    normals: Array
    status: Index


@dataclass(frozen=True)
class Samples(Rows):
    """Distances of the interpolant at instants (k,), and what was required then (m)."""

    pair: Index
    t: Array
    distance: Array
    required: Array

    @staticmethod
    def none() -> Samples:
        """No samples."""
        empty = np.empty(0)
        return Samples(np.empty(0, dtype=np.intp), empty, empty, empty)


class Collector:
    """Gathers leaves and samples of pairs, and knows by how much each pair falls short at worst.

    ``tubes_m``, one a pair, is how much nearer than a sample says may be what flies.
    """

    def __init__(self, tubes_m: Sequence[float], settings: CertificateSettings) -> None:
        self._settings = settings
        self._tubes = np.array(tubes_m)
        self._worst = np.full(len(self._tubes), np.inf)
        self._leaves: list[Leaves] = []
        self._samples: list[Samples] = []

    def close(
        self, open_: Intervals, which: Mask, bound: Array, normals: Array, status: Status
    ) -> None:
        """Close the intervals where ``which`` holds."""
        if np.any(which):
            here = open_.take(which)
            label = np.full(len(here), int(status))
            self._leaves.append(
                Leaves(
                    here.pair, here.t0, here.t1, here.required, bound[which], normals[which], label
                )
            )

    def add(self, samples: Samples) -> None:
        """Keep distances, and the worst of each pair against what is required."""
        self._samples.append(samples)
        shortest = samples.distance - self._tubes[samples.pair] - samples.required
        np.minimum.at(self._worst, samples.pair, shortest)

    def hopeless(self, open_: Intervals, bound: Array, lowest: Array) -> list[tuple[Status, Mask]]:
        """Which intervals further splitting would not decide, in order of precedence.

        Args:
            bound: proven (k,). lowest: least plane bound at an instant of the interval (k,), of
                what flies.
        """
        s = self._settings
        short = bound - open_.required
        worst = self._worst[open_.pair]
        # Not to be proven, by a violation or by a tube too wide: its depth will do.
        lost = worst < -s.violation_m
        tight = (lowest - open_.required <= s.undecided_m) & (short >= -s.undecided_m)
        brief = open_.t1 - open_.t0 <= s.undecided_s
        return [
            (Status.SHORT, lost & (short >= worst - s.depth_m)),
            (Status.UNDECIDED, (tight & ~lost) | brief),
        ]

    def leaves(self) -> Leaves:
        """All that were closed; empty arrays where there were none."""
        empty = np.empty(0)
        none = np.empty(0, dtype=np.intp)
        start = Leaves(none, empty, empty, empty, empty, np.empty((0, 2, 3)), none)
        return Leaves.join([start, *self._leaves])

    def samples(self) -> Samples:
        """All distances met."""
        return Samples.join([Samples.none(), *self._samples])
