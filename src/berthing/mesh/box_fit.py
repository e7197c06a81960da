"""A small box around points, turned to fit."""

from __future__ import annotations

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.mesh.hull import outer_bound

# Hull faces whose normals differ by less are one direction to try.
SAME_DIRECTION_DEG = 5.0
# Half sizes (3,) in metres, and the pose of the box's frame.
PlacedBox = tuple[Array, Pose]


def box_around(points: Array) -> PlacedBox:
    """A box that contains points (n, 3), not all in one plane.

    One of its faces lies on a face of the hull, a second one along a hull edge seen that way. The
    smallest box of all need not be so (O'Rourke 1985), but that of a prism or a bar is.
    """
    bound = outer_bound(points, SAME_DIRECTION_DEG)
    normals = np.eye(3) if bound is None else np.concatenate([np.eye(3), bound.A])
    corners = points[ConvexHull(points).vertices]
    frames = [_frame(corners, normal) for normal in normals]
    sizes = [np.ptp(corners @ frame, axis=0) for frame in frames]
    frame = frames[int(np.argmin([np.prod(size) for size in sizes]))]
    # Over all points, not the hull's corners: Qhull leaves out those that are outside by rounding.
    local = points @ frame
    lower, upper = local.min(axis=0), local.max(axis=0)
    return 0.5 * (upper - lower), Pose(frame @ (0.5 * (lower + upper)), frame)


def _frame(corners: Array, normal: Array) -> Array:
    """Axes in columns (3, 3), right-handed: the normal, and those of the smallest rectangle."""
    first = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    first /= np.linalg.norm(first)
    second = np.cross(normal, first)
    angle = _best_angle(np.stack([corners @ first, corners @ second], axis=1))
    across = np.cos(angle) * first + np.sin(angle) * second
    return np.stack([normal, across, np.cross(normal, across)], axis=1)


def _best_angle(flat: Array) -> float:
    """Turn of the smallest rectangle around points (n, 2): one side lies along a hull edge."""
    try:
        outline = flat[ConvexHull(flat).vertices]
    except QhullError:
        return 0.0
    edges = np.roll(outline, -1, axis=0) - outline
    angles = np.unique(np.round(np.arctan2(edges[:, 1], edges[:, 0]) % (0.5 * np.pi), 9))
    c, s = np.cos(angles)[:, None], np.sin(angles)[:, None]
    x, y = outline[:, 0], outline[:, 1]
    areas = np.ptp(c * x + s * y, axis=1) * np.ptp(c * y - s * x, axis=1)
    return float(angles[int(np.argmin(areas))])
