"""The plane as a part of space, since pictures and quaternions know only space."""

from __future__ import annotations

import numpy as np

from berthing.geometry.pose import Pose


def in_space(pose: Pose) -> Pose:
    """Poses of the plane as poses of space at z = 0; those of space as they are."""
    if pose.dim == 3:
        return pose
    position = np.zeros((*pose.batch_shape, 3))
    position[..., :2] = pose.position
    rotation = np.zeros((*pose.batch_shape, 3, 3))
    rotation[..., :2, :2] = pose.rotation
    rotation[..., 2, 2] = 1.0
    return Pose(position, rotation)
