"""The bounds that claimed intervals prove, from their normals and the motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.verify.body_motion import Index
from berthing.verify.bounds import Bounds
from berthing.verify.claims import PairClaim
from berthing.verify.leaves import Intervals, Leaves, Status

# Intervals whose bounds are computed at a time, which keeps memory below 200 MB.
BLOCK = 8192

# Parts that intervals over several cells may be cut into, in all. Those that berthing writes need
# not be cut.
MOST_CUTS = 500_000


def joined(claims: Sequence[tuple[int, PairClaim]]) -> Leaves:
    """Claims of several pairs in one; ``bound`` is what is claimed."""
    parts = [no_leaves()]
    for pair, claim in claims:
        k = len(claim.t0)
        status = np.full(k, int(Status.CERTIFIED))
        lengths = np.maximum(np.linalg.norm(claim.normals, axis=2), 1.0)[..., None]
        parts.append(
            Leaves(
                np.full(k, pair), claim.t0, claim.t1, np.zeros(k), claim.bound,
                claim.normals / lengths, status,
            )
        )  # fmt: skip
    return Leaves.join(parts)


def proven_bounds(bounds: Bounds, said: Leaves) -> tuple[Array, Array]:
    """The bounds (k,) that intervals prove, and values (k, 2) at their ends.

    An interval over which a motion is not smooth is cut where it is not; the least bound of its
    parts is its own.

    Raises:
        InputError: more parts than any sound certificate has.
    """
    edges = bounds.bodies.edges_s
    inside = (edges[0] <= said.t0) & (said.t0 < said.t1) & (said.t1 <= edges[-1])
    rows = np.flatnonzero(inside & np.all(np.isfinite(said.normals), axis=(1, 2)))
    row, t0, t1 = _cut(said.t0[rows], said.t1[rows], edges)
    row = rows[row]
    share = [(t - said.t0[row]) / (said.t1[row] - said.t0[row]) for t in (t0, t1)]
    n0, n1 = said.normals[row, 0], said.normals[row, 1]
    normals = np.stack([(1.0 - s)[:, None] * n0 + s[:, None] * n1 for s in share], axis=1)
    asked = Intervals.unasked(said.pair[row], t0, t1, np.zeros(len(row)))
    pieces = replace(asked, normals=normals)
    bound, values = np.full(len(said.t0), np.inf), np.full((len(said.t0), 2), np.inf)
    start = 0
    for block in pieces.blocks(BLOCK):
        here = row[start : start + len(block)]
        found, ends = _bounds_of(bounds, block)
        np.minimum.at(bound, here, found)
        np.minimum.at(values, here, ends)
        start += len(block)
    # What was not bounded is not proven.
    return np.where(bound < np.inf, bound, -np.inf), values


def _cut(t0: Array, t1: Array, edges: Array) -> tuple[Index, Array, Array]:
    """Rows and ends of the parts of intervals (k,) between the edges that lie inside them."""
    first = np.searchsorted(edges, t0, side="right")
    inner = np.maximum(np.searchsorted(edges, t1, side="left") - first, 0)
    if np.sum(inner) > MOST_CUTS:
        raise InputError("certificate.json", "has intervals over too many segments", "shorter ones")
    row = np.repeat(np.arange(len(t0)), inner + 1)
    step = np.arange(len(row)) - np.repeat(np.cumsum(inner + 1) - inner - 1, inner + 1)
    cut = edges[np.minimum(first[row] + step, len(edges) - 1)]
    before = edges[np.maximum(first[row] + step - 1, 0)]
    return row, np.where(step == 0, t0[row], before), np.where(step == inner[row], t1[row], cut)


def _bounds_of(bounds: Bounds, pieces: Intervals) -> tuple[Array, Array]:
    """Bounds (k,) over the pieces, each in one cell of each body, and values (k, 2) at the ends."""
    cells = bounds.bodies.cells(pieces.middle)
    n0, n1 = pieces.normals[:, 0], pieces.normals[:, 1]
    values = [
        bounds.plane(pieces.pair, bounds.bodies.pose(t, cells), n)
        for t, n in ((pieces.t0, n0), (pieces.t1, n1))
    ]
    known = replace(pieces, values=np.stack(values, axis=1))
    return bounds.over(known, *bounds.motion(known)), known.values


def no_leaves() -> Leaves:
    """Of length 0."""
    empty, none = np.empty(0), np.empty(0, dtype=np.intp)
    return Leaves(none, empty, empty, empty, empty, np.empty((0, 2, 3)), none)
