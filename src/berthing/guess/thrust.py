"""Attitudes in which a body pushes hardest along its way: what least time asks for."""

from __future__ import annotations

import numpy as np

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.vehicle import Vehicle

PARALLEL = 1e-9
"""Sine of the angle below which two directions are one."""


def pushing_attitude(vehicle: Vehicle, q: Array, along: Array) -> Array | None:
    """The attitude least turned from ``q`` in which the largest force points ``along``.

    Thrust limited axis by axis is largest along a diagonal of the box of forces, √3 times that
    of one axis. None where the body cannot turn, or its force is not limited.
    """
    if not isinstance(vehicle.model, RigidBody):
        return None
    limits = vehicle.limits
    force = np.minimum(-limits.control_lower[:3], limits.control_upper[:3])
    if not np.all(np.isfinite(force)) or not np.any(force > 0.0):
        return None
    rotation = quaternion.rotation_matrix(q)
    # Of the box's corners the one that lies nearest the way already.
    signs = np.where(rotation.T @ along >= 0.0, 1.0, -1.0)
    now = rotation @ (signs * force / np.linalg.norm(force))
    return turned_onto(now, along, q)


def turned_onto(now: Array, target: Array, q: Array) -> Array:
    """``q`` (4,) turned by the shortest arc that takes the inertial unit vector ``now`` to
    ``target``; ``q`` itself where they are one, or opposite."""
    normal = np.cross(now, target)
    sine = float(np.linalg.norm(normal))
    if sine < PARALLEL:
        return q
    angle = np.asarray(np.arctan2(sine, now @ target))
    return np.asarray(quaternion.multiply(quaternion.from_axis_angle(normal / sine, angle), q))
