"""Where the vehicles of a phase can be: states, strides between them, and samples.

A state is an array (V, 7), a row a vehicle: position in m and attitude q_IB, scalar first. What
lies in the plane is at z = 0 and turns about z; what does not turn keeps the identity. A stride
(V, 6) is a translation in inertial axes, and a rotation vector in inertial axes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from berthing.clearance.signed_distance import Flags
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.vehicle import Vehicle
from berthing.verify.frames import lifted

AXES = ("x_m", "y_m", "z_m")


@dataclass(frozen=True, eq=False)
class Space:
    """States of some vehicles.

    Attributes:
        free: which components of a stride there are (V, 6).
        arm_m: lengths (V,) that turns are weighed by: the reach of the body.
        lower_m, upper_m: limits of positions (V, 3), infinite where there are none.
    """

    free: Flags
    arm_m: Array
    lower_m: Array
    upper_m: Array

    @staticmethod
    def of(vehicles: Sequence[Vehicle]) -> Space:
        """With the limits on their positions."""
        limits = [_position_limits(own) for own in vehicles]
        return Space(
            np.array([_freedom(own) for own in vehicles]),
            np.array([own.body.bounding_radius for own in vehicles]),
            np.array([lower for lower, _ in limits]),
            np.array([upper for _, upper in limits]),
        )

    def within(self, x: Array) -> Flags:
        """Whether states (..., V, 7) keep the limits on positions."""
        r = x[..., :3]
        inside = (r >= self.lower_m) & (r <= self.upper_m)
        return np.asarray(np.all(inside, axis=(-2, -1)))

    def length(self, stride: Array) -> Array:
        """Of strides (..., V, 6), in metres: turns count by the arm, vehicles by their squares."""
        weighed = stride * np.where(np.arange(6) < 3, 1.0, self.arm_m[:, None])
        return np.asarray(np.sqrt(np.sum(weighed**2, axis=(-2, -1))))

    def sample(self, rng: np.random.Generator, lower_m: Array, upper_m: Array) -> Array:
        """A state with positions between the corners (3,), as far as limits allow, uniformly."""
        count = len(self.arm_m)
        x = np.zeros((count, 7))
        low, high = np.maximum(lower_m, self.lower_m), np.minimum(upper_m, self.upper_m)
        x[:, :3] = np.where(self.free[:, :3], rng.uniform(low, np.maximum(low, high)), 0.0)
        q = rng.normal(size=(count, 4)) * np.insert(self.free[:, 3:], 0, True, axis=1)
        x[:, 3:] = q / np.linalg.norm(q, axis=1)[:, None]
        return x


def stride(x: Array, y: Array) -> Array:
    """From the states x to the states y (..., V, 7), the shorter way around: (..., V, 6)."""
    turned = quaternion.multiply(y[..., 3:], quaternion.conjugate(x[..., 3:]))
    return np.concatenate([y[..., :3] - x[..., :3], quaternion.rotation_vector(turned)], axis=-1)


def moved(x: Array, by: Array) -> Array:
    """States (..., V, 7) after the strides (..., V, 6)."""
    turned = quaternion.multiply(quaternion.from_rotation_vector(by[..., 3:]), x[..., 3:])
    q = turned / np.linalg.norm(turned, axis=-1, keepdims=True)
    return np.concatenate([x[..., :3] + by[..., :3], q], axis=-1)


def between(x: Array, y: Array, fractions: Array) -> Array:
    """States (k, V, 7) at the fractions (k,) of the straight leg from x to y."""
    start = np.broadcast_to(x, (len(fractions), *x.shape))
    return moved(start, fractions[:, None, None] * stride(x, y))


def along(space: Space, path: Array, shares: Array) -> Array:
    """States (k, V, 7) at shares (k,) of the length of a path (n + 1, V, 7)."""
    way = stride(path[:-1], path[1:])
    lengths = space.length(way)
    ends = np.concatenate([[0.0], np.cumsum(lengths)])
    where = shares * ends[-1]
    leg = np.clip(np.searchsorted(ends, where, side="right") - 1, 0, len(lengths) - 1)
    fraction = (where - ends[leg]) / np.where(lengths[leg] > 0.0, lengths[leg], 1.0)
    return moved(path[leg], fraction[:, None, None] * way[leg])


def state_of(pose: Pose) -> Array:
    """Rows (..., 7) of poses (...)."""
    rotation = np.zeros((*pose.batch_shape, 3, 3))
    rotation[..., 2, 2] = 1.0
    rotation[..., : pose.dim, : pose.dim] = pose.rotation
    return np.concatenate([lifted(pose.position), quaternion.from_matrix(rotation)], axis=-1)


def _freedom(own: Vehicle) -> list[bool]:
    planar, turns = own.dim == 2, own.model.turns
    return [True, True, not planar, turns and not planar, turns and not planar, turns]


def _position_limits(own: Vehicle) -> tuple[Array, Array]:
    lower, upper = np.full(3, -np.inf), np.full(3, np.inf)
    for i, name in enumerate(AXES[: own.dim]):
        if name in own.model.state_names:
            column = own.model.state_names.index(name)
            lower[i], upper[i] = own.limits.state_lower[column], own.limits.state_upper[column]
    return lower, upper
