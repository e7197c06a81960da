"""Where separation is asked for: a pair of parts at a time of the mesh."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.transcription.mesh import Mesh


@dataclass(frozen=True, order=True)
class Site:
    """Pair ``pair`` (index in the scenario's list) at the local coordinate s of a segment."""

    segment: int
    s: float
    pair: int


def node_sites(mesh: Mesh, pairs: int) -> list[Site]:
    """Every pair at every collocated node but the first, which the start decides, and the last
    point, which the goal may leave open.

    Where a scheme collocates both ends of a segment, neighbours share a site as they share a point.
    """
    sites = [
        Site(k, float(mesh.node_set(k).points[c]), pair)
        for k in range(mesh.segments)
        for c in mesh.node_set(k).collocated
        for pair in range(pairs)
        if not (mesh.node_set(k).points[c] == -1.0 and (k == 0 or _closes(mesh, k - 1)))
    ]
    closing = {(site.segment, site.s) for site in sites}
    last = mesh.segments - 1
    if (last, 1.0) not in closing:
        sites += [Site(last, 1.0, pair) for pair in range(pairs)]
    return sites


def _closes(mesh: Mesh, k: int) -> bool:
    """Whether the end of segment k is collocated."""
    nodes = mesh.node_set(k)
    return bool(nodes.points[nodes.collocated[-1]] == 1.0)


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
