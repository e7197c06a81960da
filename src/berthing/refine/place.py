"""Which sites a problem needs: near things at the nodes, and where the last answer dipped."""

from __future__ import annotations

import numpy as np

from berthing.refine.sampling import SampledClearance
from berthing.transcription.mesh import Mesh
from berthing.transcription.sites import Site, merge, node_sites


def near_sites(mesh: Mesh, pairs: int, sampled: SampledClearance, within_m: float) -> list[Site]:
    """Node sites of pairs whose shortfall comes within ``within_m`` around the node.

    What is left out is caught by the next sampling, if the solution moves there.
    """
    t0, t1 = float(sampled.times_s[0]), float(sampled.times_s[-1])
    widest = float(np.max(np.diff(mesh.breaks))) * (t1 - t0)
    kept = []
    for site in node_sites(mesh, pairs):
        t = t0 + (t1 - t0) * mesh.fraction(site.segment, site.s)
        around = np.abs(sampled.times_s - t) <= 0.5 * widest
        if np.any(sampled.shortfall_m[site.pair, around] > -within_m):
            kept.append(site)
    return kept


def dip_sites(
    mesh: Mesh, sites: list[Site], sampled: SampledClearance, allowed_m: float
) -> list[Site]:
    """``sites`` and one more wherever a pair's shortfall has a local maximum above ``allowed_m``."""
    t0, t1 = float(sampled.times_s[0]), float(sampled.times_s[-1])
    more = []
    for pair, shortfall in enumerate(sampled.shortfall_m):
        before = np.concatenate([[-np.inf], shortfall[:-1]])
        after = np.concatenate([shortfall[1:], [-np.inf]])
        peaks = (shortfall > allowed_m) & (shortfall >= before) & (shortfall >= after)
        for i in np.flatnonzero(peaks):
            segment, s = mesh.locate((float(sampled.times_s[i]) - t0) / (t1 - t0))
            more.append(Site(segment, s, pair))
    return merge(sites, more)
