"""The least distance met, also where balls alone have proven the clearance."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.body_motion import Index
from berthing.verify.leaves import Samples

# Queries at a time, and in all: this is a figure for the reader, not part of the proof.
CHUNK = 32
MAX_CHUNKS = 32


def with_nearest(
    samples: Samples, far: Samples, distances: Callable[[Index, Array], Array]
) -> Samples:
    """``samples``, and those instants of ``far`` asked that could be the closest of all.

    Args:
        samples: distances already known.
        far: instants with a lower bound in place of the distance.
        distances: the exact ones (k,) of pairs (k,) at times (k,).
    """
    best = float(np.min(samples.distance, initial=np.inf))
    rest = far.take(np.argsort(far.distance, kind="stable"))
    for _ in range(MAX_CHUNKS):
        rest = rest.take(np.flatnonzero(rest.distance < best))
        if not len(rest.pair):
            break
        count = np.arange(len(rest.pair))
        now, rest = rest.take(count[:CHUNK]), rest.take(count[CHUNK:])
        asked = Samples(now.pair, now.t, distances(now.pair, now.t), now.required)
        samples = Samples.join([samples, asked])
        best = min(best, float(np.min(asked.distance)))
    return samples
