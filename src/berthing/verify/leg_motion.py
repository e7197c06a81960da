"""A frame that moves in straight legs: constant velocity, and constant rate about a fixed axis."""

from __future__ import annotations

import numpy as np

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.verify.body_motion import Ceilings, Index, Jet
from berthing.verify.pair_motion import cross, norm


class LegMotion:
    """r = r₀ + v t and R = exp(t ω^×) R₀ on each leg, which lasts one second.

    The attitude turns from that of one state to that of the next by the shorter way, at a constant
    rate, while the reference point moves straight on: linear and slerp. Leg i lasts from i to
    i + 1, so that the time since its start is exact in floating point; it need not begin where the
    one before ends.

    Args:
        starts, ends: states (n, 7), n ≥ 1: position in m and unit quaternion q_IB, scalar first.
    """

    def __init__(self, starts: Array, ends: Array) -> None:
        self._r, self._R = starts[:, :3], quaternion.rotation_matrix(starts[:, 3:])
        self._v = ends[:, :3] - self._r
        # Turned from q₀ to q₁ in inertial axes: q₁ = exp(ω) q₀.
        turned = quaternion.multiply(ends[:, 3:], quaternion.conjugate(starts[:, 3:]))
        self._w = quaternion.rotation_vector(turned)
        self._rate = norm(self._w)
        still = self._rate == 0.0
        self._axis = self._w / np.where(still, 1.0, self._rate)[:, None]
        self.edges_s = np.arange(len(starts) + 1, dtype=np.float64)
        self.turns = not bool(np.all(still))
        self.rests = not self.turns and not np.any(self._v)

    @property
    def ceilings(self) -> Ceilings:
        zero = np.zeros(len(self._rate))
        reach = norm(self._r) + norm(self._v)
        # Sine and cosine of the angle turned err by its rounding.
        return Ceilings(zero, zero, self._rate, zero, zero, (1.0 + self._rate) * reach)

    def jet(self, t: Array, cells: Index) -> Jet:
        since = t - self.edges_s[cells]
        still = np.zeros((len(t), 3))
        return Jet(
            self._r[cells] + since[:, None] * self._v[cells],
            self._v[cells],
            still,
            self._rotation(since, cells),
            self._w[cells],
            still,
        )

    def _rotation(self, since: Array, cells: Index) -> Array:
        """Rodrigues' formula on the columns of R₀: x + sin θ k × x + (1 − cos θ) k × (k × x)."""
        start, axis = self._R[cells], self._axis[cells]
        angle = since * self._rate[cells]
        sine, rest = np.sin(angle)[:, None], 2.0 * (np.sin(0.5 * angle) ** 2)[:, None]
        columns = []
        for i in range(3):
            swept = cross(axis, start[:, :, i])
            columns.append(start[:, :, i] + sine * swept + rest * cross(axis, swept))
        return np.stack(columns, axis=2)
