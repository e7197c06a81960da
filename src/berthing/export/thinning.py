"""Attitudes far enough apart for Cesium to interpolate between them."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array

# Cesium interpolates rotation vectors, and takes the axis of a turn with 1 − cos(θ/2) < 1e-6, θ
# below 2.83e-3 rad, to be x (Quaternion.computeAxis). Denser samples than that make it jitter.
LEAST_TURN_RAD = 3.2e-3


def apart(q: Array) -> npt.NDArray[np.int64]:
    """Rows of unit q (k, 4) to keep: first, last, and those ``LEAST_TURN_RAD`` from the last."""
    # |p · q| = cos(θ/2), and one less that is some 1e-6, far above its rounding.
    most = np.cos(0.5 * LEAST_TURN_RAD)
    kept = [0]
    for i in range(1, len(q)):
        if abs(q[kept[-1]] @ q[i]) <= most:
            kept.append(i)
    last = len(q) - 1
    if kept[-1] != last:
        # The last row stands in for one that it is too near to.
        kept = [*kept[: max(1, len(kept) - 1)], last]
    return np.array(kept, dtype=np.int64)
