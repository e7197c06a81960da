"""Where a solution touches its margins, and the mesh that resolves it.

At a touch the costate jumps. Inside a segment a jump spoils the whole polynomial: on Scenario A
the lower Hamiltonian then drifts by a tenth. With breaks where touches begin and end, and sites
ever closer about them, it settles: the jumps of H, multiplier times rate of the clearance, cancel
as the sites close in on the instant at which that rate vanishes.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.solve.outcome import Outcome
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Problem
from berthing.transcription.sites import Site

ACTIVE = 0.01
"""Share of the largest multiplier from which a row counts as active; the barrier leaves about a
thousandth of it on rows that are merely near."""

ONE_BREAK = 1.5e-4
"""Touches shorter than this fraction of the phase get one break, longer ones one at each end."""

CROWDED = 0.35
"""A uniform break nearer to a touch than this share of a uniform segment is left out."""


@dataclass(frozen=True)
class Touch:
    """A stretch of active rows of one pair, as fractions of the phase."""

    pair: int
    begin: float
    end: float


def active(problem: Problem, outcome: Outcome) -> list[Touch]:
    """Every site and sweep whose multiplier is not small."""
    sites = problem.separation.sites
    at = [problem.mesh.fraction(site.segment, site.s) for site in sites]
    force = -outcome.multipliers[list(problem.separation.rows)]
    shared = -outcome.multipliers[[sweep.row for sweep in problem.sweeps]]
    least = ACTIVE * max(np.max(force, initial=0.0), np.max(shared, initial=0.0))
    if least <= 0.0:
        return []
    found = [Touch(s.pair, at[i], at[i]) for i, s in enumerate(sites) if force[i] > least]
    found += [
        Touch(sites[sweep.first].pair, at[sweep.first], at[sweep.last])
        for sweep, value in zip(problem.sweeps, shared, strict=True)
        if value > least
    ]
    return sorted(found, key=lambda touch: (touch.begin, touch.end))


def joined(touches: list[Touch], within: float) -> list[Touch]:
    """Touches of one pair that follow each other within a fraction of the phase, as one."""
    out: list[Touch] = []
    for touch in touches:
        near = [o for o in out if o.pair == touch.pair and touch.begin - o.end < within]
        if near:
            old = near[-1]
            out[out.index(old)] = Touch(old.pair, old.begin, max(old.end, touch.end))
        else:
            out.append(touch)
    return out


def aligned(uniform: Mesh, touches: list[Touch]) -> Mesh:
    """``uniform`` with breaks at the touches, in place of its own where these are too near."""
    at: set[float] = set()
    for touch in touches:
        brief = touch.end - touch.begin < ONE_BREAK
        at |= {0.5 * (touch.begin + touch.end)} if brief else {touch.begin, touch.end}
    inner = [b for b in sorted(at) if 0.0 < b < 1.0]
    room = CROWDED / uniform.segments
    kept = [b for b in uniform.breaks if b in (0.0, 1.0) or all(abs(b - t) > room for t in inner)]
    breaks = sorted({*kept, *inner})
    return Mesh(uniform.scheme, tuple(breaks), (uniform.degrees[0],) * (len(breaks) - 1))


def halved(problem: Problem, touches: list[Touch], mesh: Mesh, least: float) -> list[Site]:
    """The sites on another mesh, and one more in the middle of each touch longer than ``least``."""
    places = [(s.pair, problem.mesh.fraction(s.segment, s.s)) for s in problem.separation.sites]
    for touch in touches:
        middle = 0.5 * (touch.begin + touch.end)
        clear = all(p != touch.pair or abs(middle - at) > 0.25 * least for p, at in places)
        if touch.end - touch.begin > least and clear:
            places.append((touch.pair, middle))
    return sorted(Site(*mesh.locate(at), pair) for pair, at in places)
