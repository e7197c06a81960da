"""Where separation is asked for: a pair of parts at a time of the mesh."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.transcription.mesh import Mesh

SAME_PLACE = 1e-6
"""Sites of one pair nearer than this in local coordinates would make dependent rows."""


@dataclass(frozen=True, order=True)
class Site:
    """Pair ``pair`` (index in the scenario's list) at the local coordinate s of a segment."""

    segment: int
    s: float
    pair: int


def node_sites(mesh: Mesh, pairs: int) -> list[Site]:
    """Every pair at every collocated node but the first, which the start decides, and the last
    point, which the goal may leave open."""
    sites = [
        Site(k, float(mesh.node_set(k).points[c]), pair)
        for k in range(mesh.segments)
        for c in mesh.node_set(k).collocated
        for pair in range(pairs)
        if not (k == 0 and mesh.node_set(k).points[c] == -1.0)
    ]
    closing = {(site.segment, site.s) for site in sites}
    last = mesh.segments - 1
    if (last, 1.0) not in closing:
        sites += [Site(last, 1.0, pair) for pair in range(pairs)]
    return sites


def merge(sites: list[Site], more: list[Site]) -> list[Site]:
    """Both, sorted, without two of one pair in the same place."""
    out: list[Site] = []
    for site in sorted([*sites, *more], key=lambda a: (a.pair, a.segment, a.s)):
        last = out[-1] if out else None
        twin = last is not None and (last.pair, last.segment) == (site.pair, site.segment)
        if twin and last is not None and site.s - last.s < SAME_PLACE:
            continue
        out.append(site)
    return sorted(out)


def site_times(sites: list[Site], mesh: Mesh, t0_s: float, duration_s: float) -> np.ndarray:
    """Times (n,) of the sites on the scenario's clock."""
    return np.array([t0_s + duration_s * mesh.fraction(site.segment, site.s) for site in sites])


def site_margins(
    scenario: Scenario, phase: Phase, sites: list[Site], times_s: np.ndarray
) -> list[float | None]:
    """The margin in force at each site; None where the pair may touch."""
    pairs: tuple[Pair, ...] = scenario.pairs(phase)
    return [
        scenario.margins.margin(pairs[site.pair].ref_a, pairs[site.pair].ref_b, float(t))
        for site, t in zip(sites, times_s, strict=True)
    ]
