"""Which sites a problem needs: near things at the nodes, and where the last answer dipped."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.refine.sampling import SampledClearance
from berthing.transcription.elements import Index
from berthing.transcription.mesh import Mesh
from berthing.transcription.sites import Site, node_sites

PEAK_GAP = 0.03
"""Of the spacing asked for: a site at a dip's bottom is left out only if one stands this near."""

FILL_GAP = 0.33
"""Of the spacing: a site around a dip is left out if one stands this near already."""


def near_sites(mesh: Mesh, pairs: int, sampled: SampledClearance, within_m: float) -> list[Site]:
    """Node sites of pairs whose shortfall comes within ``within_m`` around the node.

    What is left out is caught by the next sampling, if the solution moves there.
    """
    t0, t1 = float(sampled.times_s[0]), float(sampled.times_s[-1])
    widest = float(np.max(np.diff(mesh.breaks))) * (t1 - t0)
    close = sampled.shortfall_m > -within_m
    kept = []
    for site in node_sites(mesh, pairs):
        if not close[site.pair].any():
            continue
        t = t0 + (t1 - t0) * mesh.fraction(site.segment, site.s)
        if np.any(close[site.pair, np.abs(sampled.times_s - t) <= 0.5 * widest]):
            kept.append(site)
    return kept


def peaks(shortfall: Array, allowed_m: float) -> Index:
    """Indices of the local maxima of ``shortfall`` (k,) above ``allowed_m``."""
    before = np.concatenate([[-np.inf], shortfall[:-1]])
    after = np.concatenate([shortfall[1:], [-np.inf]])
    return np.flatnonzero((shortfall > allowed_m) & (shortfall >= before) & (shortfall >= after))


def dips_of(sampled: SampledClearance, allowed_m: float) -> list[tuple[int, float]]:
    """(pair, time) of every local maximum of a pair's shortfall above ``allowed_m``."""
    return [
        (pair, float(sampled.times_s[i]))
        for pair, shortfall in enumerate(sampled.shortfall_m)
        for i in peaks(shortfall, allowed_m)
    ]


def dip_sites(
    mesh: Mesh,
    sites: list[Site],
    sampled: SampledClearance,
    allowed_m: float,
    spacing_s: float,
    reach_s: float,
) -> list[Site]:
    """``sites``, and around every dip more of them, ``spacing_s`` apart out to ``reach_s``.

    A single site at the bottom only moves the dip: between two sites the solution steps through a
    corner wherever that is cheapest. So the neighbourhood is filled at once.
    """
    dips = dips_of(sampled, allowed_m)
    span = float(sampled.times_s[0]), float(sampled.times_s[-1])
    return sites_around(mesh, sites, dips, span, spacing_s, reach_s)


def sites_around(
    mesh: Mesh,
    sites: list[Site],
    dips: list[tuple[int, float]],
    span_s: tuple[float, float],
    spacing_s: float,
    reach_s: float,
) -> list[Site]:
    """``sites`` and more of them around each (pair, time) of ``dips``."""
    t0, t1 = span_s
    times: dict[int, list[float]] = {}
    for site in sites:
        fraction = mesh.fraction(site.segment, site.s)
        times.setdefault(site.pair, []).append(t0 + (t1 - t0) * fraction)
    out = list(sites)
    steps = round(reach_s / spacing_s)
    for pair, centre in dips:
        known = times.setdefault(pair, [])
        for j in sorted(range(-steps, steps + 1), key=abs):
            t = centre + j * spacing_s
            gap = spacing_s * (PEAK_GAP if j == 0 else FILL_GAP)
            if t0 < t < t1 and all(abs(t - other) > gap for other in known):
                segment, s = mesh.locate((t - t0) / (t1 - t0))
                out.append(Site(segment, s, pair))
                known.append(t)
    return sorted(out)
