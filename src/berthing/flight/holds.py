"""What flies between two samples, and the commands that carry the same impulse as a plan's."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.trajectory import VehicleTrajectory

# Gauss points between two breaks: exact for the moments of controls of degree 10.
POINTS = 6


@dataclass(frozen=True)
class Hold:
    """A way to fly commands u_k between their samples.

    Attributes:
        interpolation: as ``VehicleTrajectory.control_interpolation`` says it.
        ends: whether the control at an interval's end is the next command; else it is held.
    """

    interpolation: str
    ends: bool

    def commands(self, own: VehicleTrajectory, times_s: Array) -> Array:
        """Commands (n + 1, nu) at n + 1 samples: means of the plan's controls.

        A held command is the mean over its interval, so that every interval has its impulse; of
        linear ones each is the mean weighted by its own share in what flies. Means of controls
        within their limits are within them too. Of held commands the last is the one before it.
        """
        t, w = _quadrature(np.union1d(times_s, own.breaks_s))
        u = own.control(t)
        cell = np.clip(np.searchsorted(times_s, t, side="right") - 1, 0, len(times_s) - 2)
        late = (t - times_s[cell]) / np.diff(times_s)[cell]
        share = np.stack([1.0 - late, late]) if self.ends else np.stack([late**0, 0.0 * late])
        total, weight = np.zeros((len(times_s), u.shape[1])), np.zeros(len(times_s))
        for k in (0, 1):
            np.add.at(total, cell + k, (w * share[k])[:, None] * u)
            np.add.at(weight, cell + k, w * share[k])
        if not self.ends:
            total[-1], weight[-1] = total[-2], weight[-2]
        return np.asarray(total / weight[:, None])

    def coefficients(self, first: Array, second: Array) -> Array:
        """Chebyshev coefficients (1 or 2, nu) between two values of the control."""
        if not self.ends:
            return first[None]
        return np.stack([0.5 * (first + second), 0.5 * (second - first)])


HOLDS: Mapping[str, Hold] = {
    "piecewise-constant": Hold("constant", ends=False),
    "piecewise-linear": Hold("linear", ends=True),
}


def sample_times(t0_s: float, t1_s: float, every_s: float) -> Array:
    """Samples (n + 1,) from t0 on, ``every_s`` apart; the last interval may be shorter."""
    # What is left over by rounding is no interval.
    count = max(1, int(np.ceil((t1_s - t0_s) / every_s - 1e-6)))
    return np.append(t0_s + every_s * np.arange(count), t1_s)


def _quadrature(breaks: Array) -> tuple[Array, Array]:
    """Gauss points (k,) and weights between breaks."""
    s, w = np.polynomial.legendre.leggauss(POINTS)
    half = 0.5 * np.diff(breaks)[:, None]
    middle = 0.5 * (breaks[1:] + breaks[:-1])[:, None]
    return (middle + half * s).ravel(), (half * w).ravel()
