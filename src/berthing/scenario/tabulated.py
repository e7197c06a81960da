"""A motion given by a table of poses."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np
from scipy.interpolate import CubicSpline

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array, as_array
from berthing.geometry.pose import Pose
from berthing.scenario.attitude import UNIT_ROUNDING
from berthing.scenario.motion import Motion

# Between rows further apart than this the way round is a guess.
MAX_STEP_RAD = 0.5 * np.pi
# The quaternion spline must not come near zero, where its direction turns without bound. Evenly
# spaced rows within MAX_STEP_RAD keep it above 0.8; wild spacing makes a spline overshoot.
MIN_SPLINE_NORM = 0.5


@dataclass(frozen=True, eq=False)
class Tabulated(Motion):
    """The table joined by cubic splines (not-a-knot), so twice continuously differentiable.

    Positions are a spline; attitudes are the normalised spline of the quaternions, whose signs
    are first made to agree: R(t) = R(c(t)/‖c(t)‖). Outside the table the end poses hold, but a
    scenario refuses a table that does not cover its horizon.

    Attributes:
        times_s: strictly increasing (k,), k ≥ 2.
        positions_m: (k, dim).
        quaternions: (k, 4), scalar first; in the plane about z.
        coefficients: of position and quaternion on each interval, in powers of t − times_s[i],
            highest first (4, k − 1, dim + 4): what a symbolic form needs.

    Raises:
        InputError: wrong shapes, times that do not increase, quaternions not of unit norm, a
            turn out of the plane, or rows too far apart in attitude to join.
    """

    times_s: Array
    positions_m: Array
    quaternions: Array
    coefficients: Array = field(init=False, repr=False)

    kind: ClassVar[str] = "tabulated"

    def __post_init__(self) -> None:
        times = as_array(self.times_s, (None,), "times_s")
        if len(times) < 2 or np.any(np.diff(times) <= 0.0):
            raise InputError("times_s", "do not increase", "two or more increasing times")
        positions = as_array(self.positions_m, (len(times), None), "positions_m")
        if positions.shape[1] not in (2, 3):
            raise InputError("positions_m", f"have {positions.shape[1]} columns", "2 or 3")
        rows = _agreeing_signs(as_array(self.quaternions, (len(times), 4), "quaternions"))
        if positions.shape[1] == 2 and np.any(rows[:, 1:3] != 0.0):
            raise InputError("quaternions", "turn out of the plane", "turns about z only")
        spline = CubicSpline(times, np.hstack([positions, rows]), bc_type="not-a-knot")
        object.__setattr__(self, "times_s", times)
        object.__setattr__(self, "positions_m", positions)
        object.__setattr__(self, "quaternions", rows)
        object.__setattr__(self, "coefficients", np.asarray(spline.c, dtype=np.float64))
        self._check_turns()

    @property
    def dim(self) -> int:
        return int(self.positions_m.shape[1])

    @property
    def continuity(self) -> int:
        return 2

    @property
    def span_s(self) -> tuple[float, float]:
        return float(self.times_s[0]), float(self.times_s[-1])

    def pose(self, t: Array) -> Pose:
        value, _ = self._evaluate(t)
        rotation = quaternion.rotation_matrix(value[:, self.dim :])
        return Pose(value[:, : self.dim], rotation[:, : self.dim, : self.dim])

    def velocity(self, t: Array) -> tuple[Array, Array]:
        value, slope = self._evaluate(t)
        q, dq = value[:, self.dim :], slope[:, self.dim :]
        # ω_I = 2 vec(q̇ q*) for unit q; with q = c/‖c‖ the radial part of ċ adds to the scalar
        # only, so that dividing by ‖c‖² is all that normalising asks for.
        rate = 2.0 * quaternion.multiply(dq, quaternion.conjugate(q))[:, 1:]
        return slope[:, : self.dim], rate / np.sum(q * q, axis=1, keepdims=True)

    def speed_bound(self, t0: float, t1: float) -> tuple[float, float]:
        low, high = np.clip([t0, t1], self.times_s[0], self.times_s[-1])
        speed = rate = 0.0
        for i in range(*self._intervals(low, high)):
            start, end = max(low, self.times_s[i]), min(high, self.times_s[i + 1])
            control = self._bernstein(i, start, end)
            slope = self._slope_bernstein(i, start, end)
            # A Bernstein form stays in the hull of its coefficients and the norm is convex, so
            # the largest norm of a coefficient bounds it. ‖ω‖ ≤ 2‖ċ‖/‖c‖.
            speed = max(speed, _norm_ceiling(slope[:, : self.dim]))
            turn = _norm_ceiling(slope[:, self.dim :])
            rate = max(rate, 2.0 * turn / _norm_floor(control[:, self.dim :]))
        return speed, rate

    def _check_turns(self) -> None:
        steps = quaternion.angle_between(self.quaternions[:-1], self.quaternions[1:])
        for i, step in enumerate(steps):
            start, end = self.times_s[i], self.times_s[i + 1]
            between = f"between {start:g} and {end:g} s"
            if step > MAX_STEP_RAD:
                what = f"turn by {step:.4g} rad {between}"
                raise InputError("quaternions", what, "rows at most π/2 apart")
            if _norm_floor(self._bernstein(i, start, end)[:, self.dim :]) < MIN_SPLINE_NORM:
                what = f"make the spline overshoot {between}"
                raise InputError("quaternions", what, "rows more evenly spaced in time")

    def _intervals(self, low: float, high: float) -> tuple[int, int]:
        last = len(self.times_s) - 2
        first = int(np.clip(np.searchsorted(self.times_s, low, side="right") - 1, 0, last))
        final = int(np.clip(np.searchsorted(self.times_s, high, side="left") - 1, first, last))
        return first, final + 1

    def _evaluate(self, t: Array) -> tuple[Array, Array]:
        """Values and slopes (k, dim + 4) of the spline at t (k,), held at the ends."""
        t = np.clip(np.asarray(t, dtype=np.float64), self.times_s[0], self.times_s[-1])
        index = np.clip(np.searchsorted(self.times_s, t, side="right") - 1, 0, None)
        index = np.minimum(index, len(self.times_s) - 2)
        s = (t - self.times_s[index])[:, None]
        a, b, c, d = self.coefficients[:, index]
        return ((a * s + b) * s + c) * s + d, (3.0 * a * s + 2.0 * b) * s + c

    def _bernstein(self, i: int, t0: float, t1: float) -> Array:
        """Bernstein coefficients (4, dim + 4) of interval i restricted to [t0, t1]."""
        d, c, b, a = self._taylor(i, t0, t1 - t0)
        return np.stack([d, d + c / 3.0, d + 2.0 * c / 3.0 + b / 3.0, a + b + c + d])

    def _slope_bernstein(self, i: int, t0: float, t1: float) -> Array:
        """Likewise of the derivative (3, dim + 4)."""
        span = t1 - t0
        if span == 0.0:
            return self._evaluate(np.array([t0]))[1]
        _, c, b, a = self._taylor(i, t0, span)
        return np.stack([c, c + b, c + 2.0 * b + 3.0 * a]) / span

    def _taylor(self, i: int, t0: float, span: float) -> tuple[Array, Array, Array, Array]:
        """Coefficients about t0 in powers of (t − t0)/span, lowest first."""
        a, b, c, d = self.coefficients[:, i]
        s = t0 - self.times_s[i]
        return (
            ((a * s + b) * s + c) * s + d,
            ((3.0 * a * s + 2.0 * b) * s + c) * span,
            (3.0 * a * s + b) * span**2,
            a * span**3,
        )


def _agreeing_signs(rows: Array) -> Array:
    norms = np.linalg.norm(rows, axis=1)
    worst = int(np.argmax(np.abs(norms - 1.0)))
    if abs(norms[worst] - 1.0) > UNIT_ROUNDING:
        raise InputError(f"quaternions[{worst}]", f"has the norm {norms[worst]:.9g}", "1")
    rows = rows / norms[:, None]
    flips = np.where(np.sum(rows[1:] * rows[:-1], axis=1) < 0.0, -1.0, 1.0)
    return as_array(rows * np.cumprod([1.0, *flips])[:, None], (None, 4), "quaternions")


def _norm_ceiling(control: Array) -> float:
    return float(np.max(np.linalg.norm(control, axis=1)))


def _norm_floor(control: Array) -> float:
    """Lower bound on the norm of a Bernstein form: its smallest reach along its mean direction."""
    mean = control.mean(axis=0)
    length = float(np.linalg.norm(mean))
    return float(np.min(control @ mean)) / length if length > 0.0 else 0.0
