"""A vehicle's motion at chosen times, with everything that any format writes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.native_state import Model
from berthing.trajectory import VehicleTrajectory
from berthing.trajectory_io import MIN_SAMPLES, trajectory_columns
from berthing.trajectory_io.columns import POSITION, QUATERNION, RATE, VELOCITY

Microseconds = npt.NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Samples:
    """Motion of the body's reference point and axes at the times t (k,).

    Attributes:
        t_us: (k,) in whole microseconds, the nearest ones.
        t_s: (k,) in seconds.
        position_m, velocity_m_s: (k, 3), inertial.
        q_IB: (k, 4), unit, scalar first, without jumps of sign.
        rate_rad_s, rate_change_rad_s2: angular rate and its derivative (k, 3), body axes.
        columns: all columns of trajectory.csv that the vehicle has, by name.
    """

    t_us: Microseconds
    t_s: Array
    position_m: Array
    velocity_m_s: Array
    q_IB: Array
    rate_rad_s: Array
    rate_change_rad_s2: Array
    columns: Mapping[str, Array]

    @property
    def tells_rates(self) -> bool:
        """Whether velocities and rates are known."""
        return bool(np.all(np.isfinite(np.hstack([self.velocity_m_s, self.rate_rad_s]))))


def even_times(trajectory: VehicleTrajectory) -> Array:
    """Even times, and the breaks between segments, in seconds that are whole microseconds.

    Stamps of text formats then are exact: the motion is sampled at the very times that they say.
    With the breaks among the samples, no polynomial of a reader spans a jump of the control.
    """
    even = np.linspace(trajectory.t0_s, trajectory.t1_s, MIN_SAMPLES)
    times = np.concatenate([even, trajectory.breaks_s])
    return np.asarray(np.unique(np.rint(1e6 * times)) / 1e6)


def sample(model: Model, trajectory: VehicleTrajectory, t_s: Array) -> Samples:
    """The motion at the times t (k,), which may exceed the ends by rounding."""
    columns = trajectory_columns(model, trajectory, t_s)
    states = trajectory.state(t_s)
    _, rate_inertial = model.velocity(states)
    q = continuous(_stack(columns, QUATERNION))
    rate = np.einsum("kji,kj->ki", quaternion.rotation_matrix(q), rate_inertial)
    columns = {**columns, **dict(zip(QUATERNION, q.T, strict=True))}
    return Samples(
        np.rint(1e6 * t_s).astype(np.int64),
        t_s,
        _stack(columns, POSITION),
        _stack(columns, VELOCITY),
        q,
        rate,
        _rate_change(trajectory, t_s),
        columns,
    )


def _rate_change(trajectory: VehicleTrajectory, t_s: Array) -> Array:
    """Derivative of the native rates, which are in body axes; NaN for a model that has none.

    In body axes it is also that of the rate vector, since ω × ω = 0.
    """
    names = trajectory.state_names
    if not set(RATE) <= set(names):
        return np.full((len(t_s), 3), np.nan)
    return trajectory.state_rate(t_s)[:, [names.index(name) for name in RATE]]


def continuous(q: Array) -> Array:
    """q or −q in each row, whichever is nearer to the row before; q (k, 4)."""
    turned = np.einsum("ki,ki->k", q[1:], q[:-1]) < 0.0
    sign = np.where(np.cumsum(np.concatenate([[False], turned])) % 2, -1.0, 1.0)
    return np.asarray(q * sign[:, None])


def in_space(pose: Pose) -> tuple[Array, Array]:
    """Positions (k, 3) and quaternions q_IB (k, 4) of poses; planar ones lie at z = 0."""
    d = pose.dim
    position = np.zeros((*pose.batch_shape, 3))
    position[..., :d] = pose.position
    rotation = np.broadcast_to(np.eye(3), (*pose.batch_shape, 3, 3)).copy()
    rotation[..., :d, :d] = pose.rotation
    return position, quaternion.from_matrix(rotation)


def _stack(columns: Mapping[str, Array], names: tuple[str, ...]) -> Array:
    return np.stack([columns[name] for name in names], axis=-1)
