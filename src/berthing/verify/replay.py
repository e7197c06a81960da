"""Flying the exported controls: an adaptive integration beside the interpolant.

On each step of the integrator the flown state is a polynomial, and so is the interpolant. Their
difference is fitted through more nodes than it has coefficients, so that the sum of the magnitudes
of its Chebyshev coefficients bounds it at every instant, not only at the nodes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.integrate import DOP853

from berthing.geometry.arrays import Array
from berthing.scenario.native_state import Model
from berthing.trajectory import Segment, VehicleTrajectory, evaluate
from berthing.verify.chebyshev import at_end, at_start, fitted, nodes, norm_ceiling, restrict
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

# Steps over all segments; at 0.4 ms each this is a minute. A sound plan takes some hundred.
MAX_TOTAL_STEPS = 150_000

# Degree of the polynomial that DOP853 gives for a step. With as many nodes as this and the
# coefficients of a segment, the product of two quaternions is fitted without error.
DENSE_DEGREE = 7

# Parts of a step whose differences are bounded apart: on Scenario A the bound is then 1.2 times the
# largest difference.
PIECES = 4

# Beyond this the integrator's own norms overflow, and its step control never returns.
LARGEST_RATE = 1e100

RightHandSide = Callable[[float, Array], Array]


@dataclass(frozen=True)
class Replay:
    """Distance of the replay from the interpolant, of one vehicle over one phase.

    Attributes:
        vehicle: its name.
        position_error_m, attitude_error_rad: bounds over all instants.
        velocity_error_m_s, rate_error_rad_s: of the velocity and the angular rate, the largest at
            more instants of each step than the polynomials have coefficients.
        end_position_error_m, end_attitude_error_rad: at the end.
        time_s: about when the position error is largest.
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
    state, left = at_start(trajectory.segments[0].state), MAX_TOTAL_STEPS
    steps: dict[int, list[_Step]] = {}
    with np.errstate(all="ignore"):
        for segment in trajectory.segments:
            f, count = _under_control(rates, segment), len(segment.state) + DENSE_DEGREE
            inside = np.unique(kinks[(kinks > segment.t0_s) & (kinks < segment.t1_s)])
            for t0, t1 in pairwise([segment.t0_s, *inside.tolist(), segment.t1_s]):
                for times, flown, end in _steps(f, t0, t1, state, count):
                    state, left = end, left - 1
                    if not np.all(np.isfinite(flown)) or left <= 0:
                        return Replay(trajectory.vehicle, *(np.inf,) * 6, float(times[-1]))
                    said = evaluate(segment.state, segment.local(times))
                    steps.setdefault(count, []).append(_Step(times, flown, said))
    found = [_largest(model, same) for same in steps.values()]
    last = at_end(trajectory.segments[-1].state)
    position, attitude, _, _ = _distances(model, state[None], last[None])
    return Replay(
        trajectory.vehicle,
        max(errors.position for errors in found),
        max(errors.attitude for errors in found),
        max(errors.velocity for errors in found),
        max(errors.rate for errors in found),
        float(position[0]),
        float(attitude[0]),
        max(found, key=lambda errors: errors.position).time_s,
    )


class _Step(NamedTuple):
    """Times (k,) of a step's Chebyshev nodes; states (k, nx) there, flown and said."""

    times: Array
    flown: Array
    said: Array


class _Errors(NamedTuple):
    """In m, rad, m/s and rad/s, and the time of the largest position error."""

    position: float
    attitude: float
    velocity: float
    rate: float
    time_s: float


def _steps(
    f: RightHandSide, t0: float, t1: float, x: Array, count: int
) -> Iterator[tuple[Array, Array, Array]]:
    """Of each step the times of ``count`` nodes, the states there, and the state at its end.

    The last states are NaN where the integration fails.
    """
    t, s = t0, nodes(count)
    try:
        solver = DOP853(f, t0, x, t1, rtol=REPLAY_RELATIVE, atol=REPLAY_ABSOLUTE)
        for _ in range(MAX_STEPS):
            solver.step()
            if solver.status == "failed":
                break
            times = 0.5 * (t + solver.t) + 0.5 * (solver.t - t) * s
            t = float(solver.t)
            yield times, solver.dense_output()(times).T, solver.y
            if solver.status == "finished":
                return
    except OverflowError:
        pass
    lost = np.full((1, len(x)), np.nan)
    yield np.array([t]), lost, lost[0]


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


def _largest(model: Model, steps: list[_Step]) -> _Errors:
    """Over steps with equally many nodes, bounds that hold between the nodes too.

    Positions are polynomials of fewer coefficients than there are nodes. The rotations of the
    normalised quaternions are not quite, but their fit errs by far less than its last terms,
    which are themselves small beside the first.
    """
    times, flown, said = (np.stack(rows) for rows in zip(*steps, strict=True))
    poses = [model.pose(x) for x in (flown, said)]
    apart = poses[0].position - poses[1].position
    turned = poses[0].rotation - poses[1].rotation
    rows = [x.reshape(-1, x.shape[-1]) for x in (flown, said)]
    _, _, velocity, rate = _distances(model, *rows)
    ceilings = _ceilings(apart)
    worst = int(np.argmax(ceilings))
    return _Errors(
        float(ceilings[worst]),
        float(_angle(np.max(_ceilings(turned.reshape(*times.shape, -1))))),
        float(np.max(velocity)),
        float(np.max(rate)),
        float(times[worst, int(np.argmax(np.linalg.norm(apart[worst], axis=1)))]),
    )


def _ceilings(values: Array) -> Array:
    """Bounds (n,) on the norms over n steps, from values (n, k, c) at their Chebyshev nodes."""
    coefficients = fitted(values)
    one = np.ones(len(values))
    edges = np.linspace(-1.0, 1.0, PIECES + 1)
    return np.asarray(
        np.max(
            [norm_ceiling(restrict(coefficients, a * one, b * one)) for a, b in pairwise(edges)],
            axis=0,
        )
    )


def _distances(model: Model, a: Array, b: Array) -> tuple[Array, Array, Array, Array]:
    """Distances (k,) between two states (k, nx) in m, rad, m/s and rad/s."""
    first, second = model.pose(a), model.pose(b)
    chord = np.linalg.norm(first.rotation - second.rotation, axis=(1, 2))
    rates = zip(_rates(model, a), _rates(model, b), strict=True)
    return (
        np.linalg.norm(first.position - second.position, axis=1),
        _angle(chord),
        *(np.linalg.norm(one - other, axis=1) for one, other in rates),
    )


def _rates(model: Model, x: Array) -> tuple[Array, Array]:
    """Velocity and rate; of a model that does not tell them there is nothing to compare."""
    return model.velocity(x) if model.tells_rates else (np.zeros((len(x), 3)),) * 2


def _angle(chord: Array | float) -> Array:
    """The angle θ between two rotations whose difference has this Frobenius norm.

    It is 2√2 sin(θ/2), in the plane as in space: the trace of RᵀR′ is 2 cos θ in the plane and
    one more in space. Unlike the trace it keeps small angles.
    """
    return np.asarray(2.0 * np.arcsin(np.clip(chord / np.sqrt(8.0), 0.0, 1.0)))
