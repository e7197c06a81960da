"""Flying the exported controls: an adaptive integration beside the interpolant."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.integrate import DOP853

from berthing.geometry.arrays import Array
from berthing.scenario.native_state import Model
from berthing.trajectory import Segment, VehicleTrajectory, evaluate
from berthing.verify.chebyshev import at_start
from berthing.verify.equations import Derivative, derivative, knots_s
from berthing.verify.settings import (
    REPLAY_ABSOLUTE,
    REPLAY_ATTITUDE_TOLERANCE_RAD,
    REPLAY_POSITION_TOLERANCE_M,
    REPLAY_RATE_TOLERANCE,
    REPLAY_RELATIVE,
)

# Steps over one segment before the replay is given up: a sound segment takes fewer than ten.
MAX_STEPS = 2000

# Beyond this the integrator's own norms overflow, and its step control never returns.
LARGEST_RATE = 1e100

RightHandSide = Callable[[float, Array], Array]


@dataclass(frozen=True)
class Replay:
    """Distance of the replay from the interpolant, of one vehicle over one phase.

    Attributes:
        vehicle: its name.
        position_error_m, attitude_error_rad: the largest at the integrator's steps and at more
            instants of each segment than its polynomials have coefficients.
        velocity_error_m_s, rate_error_rad_s: likewise of the velocity and the angular rate.
        end_position_error_m, end_attitude_error_rad: at the end.
        time_s: of the largest position error.
    """

    vehicle: str
    position_error_m: float
    attitude_error_rad: float
    velocity_error_m_s: float
    rate_error_rad_s: float
    end_position_error_m: float
    end_attitude_error_rad: float
    time_s: float

    @property
    def reasons(self) -> list[str]:
        """Empty where what flies is what was checked."""
        where = f"replay[{self.vehicle}, t = {self.time_s:.6g} s]"
        found = []
        if not self.position_error_m <= REPLAY_POSITION_TOLERANCE_M:
            found.append(f"{where} is off by {self.position_error_m:.3g} m")
        if not self.attitude_error_rad <= REPLAY_ATTITUDE_TOLERANCE_RAD:
            found.append(f"{where} is off by {self.attitude_error_rad:.3g} rad at most")
        if not self.velocity_error_m_s <= REPLAY_RATE_TOLERANCE:
            found.append(f"{where} is off by {self.velocity_error_m_s:.3g} m/s at most")
        if not self.rate_error_rad_s <= REPLAY_RATE_TOLERANCE:
            found.append(f"{where} is off by {self.rate_error_rad_s:.3g} rad/s at most")
        return found


def replay(model: Model, trajectory: VehicleTrajectory) -> Replay:
    """Integrate the equations of motion under the exported controls from the interpolant's start.

    DOP853 (Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, II.10) is
    started anew on each segment, where controls may jump, and at the kinks of known wrenches.
    Errors are infinite where the integration fails.

    Raises:
        CapabilityError: a model without independent equations.
    """
    rates, kinks = derivative(model), knots_s(model)
    start = at_start(trajectory.segments[0].state)
    times, flown, said = [np.array([trajectory.t0_s])], [start[None]], [start[None]]
    with np.errstate(all="ignore"):
        for segment in trajectory.segments:
            f, samples = _under_control(rates, segment), _samples(segment)
            inside = np.unique(kinks[(kinks > segment.t0_s) & (kinks < segment.t1_s)])
            for t0, t1 in pairwise([segment.t0_s, *inside.tolist(), segment.t1_s]):
                for t, x in _steps(f, t0, t1, flown[-1][-1], samples):
                    if not np.all(np.isfinite(x)):
                        return Replay(trajectory.vehicle, *(np.inf,) * 6, float(t[-1]))
                    times.append(t)
                    flown.append(x)
                    said.append(evaluate(segment.state, segment.local(t)))
    position, attitude, velocity, rate = _errors(model, np.concatenate(flown), np.concatenate(said))
    return Replay(
        trajectory.vehicle,
        float(np.max(position)),
        float(np.max(attitude)),
        float(np.max(velocity)),
        float(np.max(rate)),
        float(position[-1]),
        float(attitude[-1]),
        float(np.concatenate(times)[int(np.argmax(position))]),
    )


def _samples(segment: Segment) -> Array:
    """Times at which to compare: more than the coefficients, so that no difference can hide."""
    count = 2 * len(segment.state) + 1
    s = np.cos(np.pi * (np.arange(count) + 0.5) / count)[::-1]
    return 0.5 * (segment.t0_s + segment.t1_s + (segment.t1_s - segment.t0_s) * s)


def _steps(
    f: RightHandSide, t0: float, t1: float, x: Array, samples: Array
) -> Iterator[tuple[Array, Array]]:
    """Times (k,) and states (k, nx), step by step: the samples passed and the step's end.

    The last state is NaN where the integration fails.
    """
    t = t0
    try:
        solver = DOP853(f, t0, x, t1, rtol=REPLAY_RELATIVE, atol=REPLAY_ABSOLUTE)
        for _ in range(MAX_STEPS):
            solver.step()
            if solver.status == "failed":
                break
            passed = samples[(samples > t) & (samples < solver.t)]
            t = float(solver.t)
            inner = solver.dense_output()(passed).T
            yield np.append(passed, t), np.vstack([inner, solver.y])
            if solver.status == "finished":
                return
    except OverflowError:
        pass
    yield np.array([t]), np.full((1, len(x)), np.nan)


def _under_control(rates: Derivative, segment: Segment) -> RightHandSide:
    def right_hand_side(t: float, x: Array) -> Array:
        found = rates(t, x, _at(segment.control, _local(segment, t)))
        # Written so that NaN fails too.
        if not np.max(np.abs(found)) <= LARGEST_RATE:
            raise OverflowError
        return found

    return right_hand_side


def _local(segment: Segment, t: float) -> float:
    return (2.0 * t - segment.t0_s - segment.t1_s) / (segment.t1_s - segment.t0_s)


def _at(coefficients: Array, s: float) -> Array:
    """The value (n,) at s by Clenshaw's recurrence."""
    ahead = after = np.zeros(coefficients.shape[1])
    for row in coefficients[:0:-1]:
        ahead, after = row + 2.0 * s * ahead - after, ahead
    return np.asarray(coefficients[0] + s * ahead - after)


def _errors(model: Model, a: Array, b: Array) -> tuple[Array, Array, Array, Array]:
    """Distances (k,) between two states (k, nx) in m, rad, m/s and rad/s."""
    first, second = model.pose(a), model.pose(b)
    # ‖R₁ − R₂‖_F = 2√2 sin(θ/2), which keeps small angles, unlike the trace.
    chord = np.linalg.norm(first.rotation - second.rotation, axis=(1, 2))
    rates = zip(_rates(model, a), _rates(model, b), strict=True)
    return (
        np.linalg.norm(first.position - second.position, axis=1),
        2.0 * np.arcsin(np.clip(chord / np.sqrt(8.0), 0.0, 1.0)),
        *(np.linalg.norm(one - other, axis=1) for one, other in rates),
    )


def _rates(model: Model, x: Array) -> tuple[Array, Array]:
    """Velocity and rate; of a model that does not tell them there is nothing to compare."""
    return model.velocity(x) if model.tells_rates else (np.zeros((len(x), 3)),) * 2
