"""From a vehicle's trajectory, or a structure's law, to the motion that the certificate bounds."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.motion import ConstantSpin, ConstantVelocity, Fixed, Motion
from berthing.scenario.native_state import Model
from berthing.scenario.point_mass import PointMass
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.tabulated import Tabulated
from berthing.scenario.user_model import UserModel
from berthing.trajectory import Segment, VehicleTrajectory
from berthing.verify.body_motion import BodyMotion, SteadyMotion
from berthing.verify.polynomial_motion import Piece, PolynomialMotion
from berthing.verify.user_motion import UserMotion

Span = tuple[float, float]


def vehicle_motion(model: Model, trajectory: VehicleTrajectory) -> BodyMotion:
    """The motion of a vehicle's frame, as its interpolant says.

    Raises:
        CapabilityError: the pose map of this model is not known here.
        InputError: the user's own pose map fails.
        UnboundedAttitudeError: the quaternion comes near zero.
    """
    if isinstance(model, UserModel):
        return UserMotion(model, trajectory.segments)
    read = _READERS.get(type(model))
    if read is None:
        raise CapabilityError(f"no certificate for the model {model.kind!r}")
    return PolynomialMotion([read(segment) for segment in trajectory.segments])


def structure_motion(motion: Motion, span_s: Span) -> BodyMotion:
    """The motion of a structure's frame over the span.

    Raises:
        CapabilityError: the law is not known here.
    """
    build = _LAWS.get(type(motion))
    if build is None:
        raise CapabilityError(f"no certificate for the motion {motion.kind!r}")
    return build(motion, span_s)


def lifted(vector: Array) -> Array:
    """(…, 2 or 3) → (…, 3), z = 0."""
    if vector.shape[-1] == 3:
        return vector
    return np.concatenate([vector, np.zeros((*vector.shape[:-1], 1))], axis=-1)


def lifted_rotation(rotation: Array) -> Array:
    """(d, d) → (3, 3), about z."""
    out = np.eye(3)
    d = len(rotation)
    out[:d, :d] = rotation
    return out


def _rigid_body(segment: Segment) -> Piece:
    return Piece(segment.t0_s, segment.t1_s, segment.state[:, 0:3], segment.state[:, 6:10])


def _point_mass(segment: Segment) -> Piece:
    d = segment.state.shape[1] // 2
    return Piece(segment.t0_s, segment.t1_s, lifted(segment.state[:, :d]), None)


_READERS: dict[type[Model], Callable[[Segment], Piece]] = {
    RigidBody: _rigid_body,
    PointMass: _point_mass,
}


def _steady(pose: Pose, velocity: Array, rate: Array, span_s: Span) -> SteadyMotion:
    return SteadyMotion(
        span_s, lifted(pose.position), lifted(velocity), lifted_rotation(pose.rotation), rate
    )


def _fixed(motion: Fixed, span_s: Span) -> BodyMotion:
    return _steady(motion.fixed_pose, np.zeros(3), np.zeros(3), span_s)


def _constant_velocity(motion: ConstantVelocity, span_s: Span) -> BodyMotion:
    return _steady(motion.pose0, motion.velocity_m_s, np.zeros(3), span_s)


def _constant_spin(motion: ConstantSpin, span_s: Span) -> BodyMotion:
    return _steady(motion.pose0, motion.velocity_m_s, motion.rate_inertial_rad_s, span_s)


def _tabulated(motion: Tabulated, span_s: Span) -> BodyMotion:
    """Cubics between the rows; outside the table the end poses hold."""
    start, end = span_s
    edges = [start, *(float(t) for t in motion.times_s if start < t < end), end]
    return PolynomialMotion([_tabulated_piece(motion, t0, t1) for t0, t1 in pairwise(edges)])


def _tabulated_piece(motion: Tabulated, t0: float, t1: float) -> Piece:
    times = motion.times_s
    held = np.clip(0.5 * (t0 + t1), times[0], times[-1])
    row = min(int(np.searchsorted(times, held, side="right")) - 1, len(times) - 2)
    a, b, c, d = motion.coefficients[:, row]
    inside = times[0] < 0.5 * (t0 + t1) < times[-1]
    h = 0.5 * (t1 - t0) if inside else 0.0
    s = (0.5 * (t0 + t1) if inside else held) - times[row]
    # Taylor coefficients about the middle in powers of x on [-1, 1]; then
    # x² = (T₀ + T₂)/2 and x³ = (3 T₁ + T₃)/4.
    e0 = ((a * s + b) * s + c) * s + d
    e1 = ((3.0 * a * s + 2.0 * b) * s + c) * h
    e2 = (3.0 * a * s + b) * h**2
    e3 = a * h**3
    rows = np.stack([e0 + 0.5 * e2, e1 + 0.75 * e3, 0.5 * e2, 0.25 * e3])
    return Piece(t0, t1, lifted(rows[:, : motion.dim]), rows[:, motion.dim :])


# Keys and builders of one law go together; a dictionary's type cannot say so.
_LAWS: dict[type[Motion], Callable[..., BodyMotion]] = {
    Fixed: _fixed,
    ConstantVelocity: _constant_velocity,
    ConstantSpin: _constant_spin,
    Tabulated: _tabulated,
}
