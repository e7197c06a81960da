"""Where a solution touches its margins, and the mesh and sites that close in on the instants.

At a touch the costate jumps by the multiplier times the gradient of the clearance, and the lower
Hamiltonian by the multiplier times its rate, which vanishes at the touch itself. A row beside the
instant leaves a jump; a row inside a segment spoils the segment's polynomial besides. So each touch
gets two rows, at the ends of a short segment about it: while both are active the instant lies
between, the multipliers say where, and the segment shrinks onto it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.refine.sampling import SampledClearance
from berthing.solve.outcome import Outcome
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Problem
from berthing.transcription.sites import Site

ACTIVE = 0.01
"""Share of the largest multiplier from which a row counts as active; the barrier leaves about a
thousandth of it on rows that are merely near."""

SHRINK = 0.25
"""Of a segment that held its touch, or of the gap between the rows about it: the next width."""

MISSED = 2.0
"""Times the stretch between rows and least clearance, or the last width: the next after a miss."""

WIDEST, FIRST = 1.0, 0.25
"""Widths in units of the mean distance of two nodes: the most, and the least to begin with."""

NARROWEST = 1e-6
"""Fraction of the phase. Jumps of H shrink with the width; rounding in the derivatives grows."""

CLEAR = 0.5
"""Of the width: other sites of the pair keep this far from the segment of a touch."""

ROUNDING = 1e-3
"""Of the width: sites are found again through the mesh, which rounds their places."""

CROWDED = 0.35
"""A break of the mesh nearer to a touch than this share of its shorter segment is left out."""

Place = tuple[int, float]
"""A pair and a fraction of the phase."""


@dataclass(frozen=True)
class Touch:
    """A stretch, in fractions of the phase, in which a pair comes down to its margin."""

    pair: int
    begin: float
    end: float

    @staticmethod
    def about(pair: int, centre: float, width: float) -> Touch:
        """Of ``width`` where it fits into the phase."""
        return Touch(pair, max(centre - 0.5 * width, 0.0), min(centre + 0.5 * width, 1.0))

    @property
    def width(self) -> float:
        return self.end - self.begin

    def holds(self, begin: float, end: float) -> bool:
        """Whether another stretch lies within, but for rounding."""
        slack = ROUNDING * self.width
        return self.begin - slack <= begin and end <= self.end + slack

    def near(self, place: Place, within: float = 0.0) -> bool:
        """Whether a place of the pair is no further than ``within`` outside."""
        pair, at = place
        return pair == self.pair and self.begin - within <= at <= self.end + within


Settled = Callable[[Touch], bool]


@dataclass(frozen=True)
class Pull:
    """An active row: its pair, the fraction of the phase, the size of its multiplier."""

    pair: int
    at: float
    force: float


@dataclass(frozen=True)
class Bottom:
    """A least clearance of a pair at the fraction ``at``, and the active rows about it."""

    pair: int
    at: float
    pulls: tuple[Pull, ...]


def pulls(problem: Problem, outcome: Outcome) -> list[Pull]:
    """Every site and sweep whose multiplier is not small; a sweep pulls at its last site."""
    sites = problem.separation.sites
    at = [problem.mesh.fraction(site.segment, site.s) for site in sites]
    rows = [*problem.separation.rows, *(sweep.row for sweep in problem.sweeps)]
    last = [*range(len(sites)), *(sweep.last for sweep in problem.sweeps)]
    force = -outcome.multipliers[rows]
    least = ACTIVE * float(np.max(force, initial=0.0))
    return [
        Pull(sites[i].pair, at[i], float(value))
        for i, value in zip(last, force, strict=True)
        if value > least
    ]


def bottoms(
    found: Iterable[Pull],
    sampled: SampledClearance,
    fractions: Array,
    sharpen: Callable[[int, float, float], float],
) -> list[Bottom]:
    """The least clearances downhill of the active rows.

    Args:
        fractions: (k,) of the samples. sharpen: finds the least of a pair between two of them.
    """
    groups: dict[tuple[int, int], list[Pull]] = {}
    for pull in found:
        i = downhill(sampled.distances_m[pull.pair], int(np.argmin(np.abs(fractions - pull.at))))
        groups.setdefault((pull.pair, i), []).append(pull)
    last = len(fractions) - 1
    return [
        Bottom(
            pair,
            sharpen(pair, float(fractions[max(i - 1, 0)]), float(fractions[min(i + 1, last)])),
            tuple(group),
        )
        for (pair, i), group in sorted(groups.items())
    ]


def downhill(values: Array, i: int) -> int:
    """Index of the local minimum that a walk down from ``i`` ends at."""
    while True:
        low, high = max(i - 1, 0), min(i + 2, len(values))
        lowest = low + int(np.argmin(values[low:high]))
        if values[lowest] >= values[i]:
            return i
        i = lowest


def closed_in(before: Sequence[Touch], bottom: Bottom, node: float, settled: Settled) -> Touch:
    """The stretch to look for the touch of ``bottom`` in.

    Args:
        before: the stretches of the last round. node: a mean distance of nodes.
        settled: whether a stretch that holds its touch is narrow enough.
    """
    at = np.array([pull.at for pull in bottom.pulls])
    force = np.array([pull.force for pull in bottom.pulls])
    begin, end = float(np.min(at)), float(np.max(at))
    own = [touch for touch in before if touch.pair == bottom.pair]
    old = min(own, key=lambda t: abs(t.begin + t.end - 2.0 * bottom.at), default=None)
    if old is not None and begin < end and old.holds(begin, end):
        if settled(old):
            return old
        return Touch.about(
            bottom.pair, float(at @ force / np.sum(force)), max(SHRINK * old.width, NARROWEST)
        )
    if begin < bottom.at < end:
        centre, width = bottom.at, SHRINK * (end - begin)
    else:
        # Rows all to one side. As they move by a step, the least clearance moves by some share of
        # it, either way: the touch may lie between the two or beyond.
        low, high = min(begin, bottom.at), max(end, bottom.at)
        centre, width = 0.5 * (low + high), MISSED * (high - low)
        if old is not None and not old.near((bottom.pair, bottom.at)):
            width = max(width, MISSED * old.width)
    low_width = NARROWEST if old is not None else FIRST * node
    return Touch.about(bottom.pair, centre, float(np.clip(width, low_width, WIDEST * node)))


def cut(base: Mesh, touches: Sequence[Touch]) -> Mesh:
    """``base``, of one degree, with breaks at both ends of every touch; where these crowd breaks
    of its own, the base's make room."""
    ends: list[float] = []
    for t in sorted(e for touch in touches for e in (touch.begin, touch.end)):
        if 0.0 < t < 1.0 and (not ends or t - ends[-1] > 0.1 * NARROWEST):
            ends.append(t)
    gaps = np.diff(base.breaks)
    room = CROWDED * np.minimum(gaps[:-1], gaps[1:])
    kept = [
        b
        for b, least in zip(base.breaks[1:-1], room, strict=True)
        if all(abs(b - t) > least for t in ends)
    ]
    breaks = (0.0, *sorted({*kept, *ends}), 1.0)
    return Mesh(base.scheme, breaks, (base.degrees[0],) * (len(breaks) - 1))


def touch_sites(mesh: Mesh, touches: Sequence[Touch], guards: Iterable[Place]) -> list[Site]:
    """Rows at both ends of every touch, and at the guards that are clear of the touches."""
    places = {(touch.pair, t) for touch in touches for t in (touch.begin, touch.end)}
    places |= {
        guard
        for guard in guards
        if not any(touch.near(guard, CLEAR * touch.width) for touch in touches)
    }
    return sorted({Site(*mesh.locate(at), pair) for pair, at in places})
