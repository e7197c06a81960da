"""Control and state limits, and the norm of quaternions, at every instant.

A component on a segment lies between its constant coefficient plus and minus the sum of the other
magnitudes. Where that does not settle it, the segment is halved; since the range found shrinks to
the true one quadratically in the length, few halvings are needed.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.native_state import Model
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import VehicleTrajectory
from berthing.verify.chebyshev import padded, restrict
from berthing.verify.settings import LIMIT_RELATIVE_TOLERANCE, QUATERNION_NORM_TOLERANCE

# Doubtful pieces at one depth. The range of a piece is known to the square of its length, so that
# 1e4 pieces tell a value from a limit to eight digits of the component's own range.
MAX_PIECES = 10_000

QUATERNION = ("qw", "qx", "qy", "qz")


@dataclass(frozen=True)
class Excess:
    """A component beyond its limit.

    Attributes:
        vehicle, component: names, the unit in the component's.
        time_s: where it was found.
        value, limit: native units.
    """

    vehicle: str
    component: str
    time_s: float
    value: float
    limit: float

    @property
    def reason(self) -> str:
        return (
            f"limit[{self.vehicle}, {self.component}, t = {self.time_s:.6g} s]: "
            f"{self.value:.9g} is beyond {self.limit:g}"
        )


def excesses(vehicle: Vehicle, trajectory: VehicleTrajectory) -> list[Excess]:
    """Every limited component that leaves its limits by more than the tolerance, worst found."""
    limits, model = vehicle.limits, vehicle.model
    states = padded([s.state for s in trajectory.segments])
    controls = padded([s.control for s in trajectory.segments])
    found = [
        *_beyond(vehicle.name, trajectory, states, model.state_names,
                 limits.state_lower, limits.state_upper),
        *_beyond(vehicle.name, trajectory, controls, model.control_names,
                 limits.control_lower, limits.control_upper),
    ]  # fmt: skip
    return [*found, *_norm_excess(vehicle.name, model, trajectory, states)]


def _beyond(
    vehicle: str,
    trajectory: VehicleTrajectory,
    coefficients: Array,
    names: tuple[str, ...],
    lower: Array,
    upper: Array,
) -> list[Excess]:
    """Upper limits of f, and lower ones as upper limits of −f."""
    found = []
    for sign, bounds in ((1.0, upper), (-1.0, -lower)):
        for i in np.flatnonzero(np.isfinite(bounds)):
            limit = float(bounds[i])
            scale = max(abs(limit), _scale(lower[i], upper[i]))
            worst = first_beyond(
                trajectory.breaks_s,
                sign * coefficients[:, :, i],
                limit + LIMIT_RELATIVE_TOLERANCE * scale,
            )
            if worst is not None:
                time, value = worst
                found.append(Excess(vehicle, names[i], time, sign * value, sign * limit))
    return found


def first_beyond(
    breaks_s: Array, coefficients: Array, ceiling: float
) -> tuple[float, float] | None:
    """Time and value of the largest sample above ``ceiling``, or None where none can be.

    Args:
        breaks_s: ends of the segments (n + 1,).
        coefficients: Chebyshev coefficients (n, degree + 1) of one component.

    Where halving ends with neither, a piece that is undecided counts as beyond.
    """
    t0, t1, c = breaks_s[:-1], breaks_s[1:], coefficients
    while True:
        doubtful = ~(c[:, 0] + np.abs(c[:, 1:]).sum(axis=1) <= ceiling)
        t0, t1, c = t0[doubtful], t1[doubtful], c[doubtful]
        if not len(t0):
            return None
        if len(t0) > MAX_PIECES or not np.all(t0 < 0.5 * (t0 + t1)) or not np.all(np.isfinite(c)):
            return float(t0[0]), float(c[0, 0])
        # T_k(−1) = (−1)^k, T_k(1) = 1, T_k(0) = 1, 0, −1, 0, …
        signs = np.array([[(-1.0) ** k, np.cos(0.5 * np.pi * k), 1.0] for k in range(c.shape[1])])
        samples = c @ signs
        where = np.unravel_index(int(np.argmax(samples)), samples.shape)
        middle = 0.5 * (t0 + t1)
        if samples[where] > ceiling:
            times = np.stack([t0, middle, t1], axis=1)
            return float(times[where]), float(samples[where])
        one, c3 = np.ones(len(t0)), c[:, :, None]
        c = np.concatenate([restrict(c3, -one, 0.0 * one), restrict(c3, 0.0 * one, one)])[:, :, 0]
        t0, t1 = np.concatenate([t0, middle]), np.concatenate([middle, t1])


def _scale(lower: float, upper: float) -> float:
    """The larger magnitude of the finite limits of a component."""
    return max((abs(v) for v in (lower, upper) if np.isfinite(v)), default=1.0)


def _norm_excess(
    vehicle: str, model: Model, trajectory: VehicleTrajectory, states: Array
) -> list[Excess]:
    """Norms too far from 1, from the coefficients of |q|², a polynomial of twice the degree."""
    if not set(QUATERNION) <= set(model.state_names):
        return []
    columns = [model.state_names.index(name) for name in QUATERNION]
    square = _squared_norm(states[:, :, columns])
    found = []
    for sign in (1.0, -1.0):
        limit = 1.0 + sign * QUATERNION_NORM_TOLERANCE
        worst = first_beyond(trajectory.breaks_s, sign * square, sign * limit**2)
        if worst is not None:
            time, value = worst
            norm = float(np.sqrt(max(sign * value, 0.0)))
            found.append(Excess(vehicle, "quaternion norm", time, norm, limit))
    return found


def _squared_norm(q: Array) -> Array:
    """Coefficients (n, 2 degree + 1) of q·q, from T_i T_j = (T_{i+j} + T_{|i−j|})/2."""
    count = q.shape[1]
    gram = np.einsum("nic,njc->nij", q, q)
    out = np.zeros((len(q), 2 * count - 1))
    for i in range(count):
        for j in range(count):
            out[:, i + j] += 0.5 * gram[:, i, j]
            out[:, abs(i - j)] += 0.5 * gram[:, i, j]
    return out
