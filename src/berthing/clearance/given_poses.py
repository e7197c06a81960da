"""Poses as callers give them: objects, or plain arrays as planners have them."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose

# How far from 1 the length of a quaternion may be: rounding of a chain of products, or of seven
# printed digits.
UNIT_TOLERANCE = 1e-6
WIDTHS = {2: 3, 3: 7}
FORMS = {2: "(..., 3): x, y, angle", 3: "(..., 7): x, y, z and q_IB, scalar first"}

GivenPoses = Pose | npt.ArrayLike


def read_poses(given: GivenPoses, dim: int, where: str) -> Pose:
    """As ``Pose``.

    Args:
        given: a pose, or numbers (..., 7) of position and quaternion q_IB, scalar first; in the
            plane (..., 3) of position and angle in rad.
        dim: 2 or 3.
        where: the name used in errors.

    Raises:
        InputError: another dimension or shape, numbers that are not finite, a quaternion that is
            not of length 1.
    """
    if isinstance(given, Pose):
        if given.dim != dim:
            raise InputError(where, f"has {given.dim} dimensions", f"{dim}, as the sets have")
        return given
    numbers = _numbers(given, dim, where)
    if dim == 2:
        return Pose.planar(numbers[..., :2], numbers[..., 2])
    q = numbers[..., 3:]
    length = np.sqrt(np.sum(q * q, axis=-1))
    if not np.all(np.abs(length - 1.0) <= UNIT_TOLERANCE):
        worst = float(length.flat[np.argmax(np.abs(length - 1.0))])
        raise InputError(where, f"has a quaternion of length {worst:.6g}", "length 1")
    return Pose.from_quaternion(numbers[..., :3], q)


def _numbers(given: npt.ArrayLike, dim: int, where: str) -> Array:
    try:
        numbers = np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(where, "is neither a Pose nor an array of numbers", FORMS[dim]) from None
    if numbers.ndim == 0 or numbers.shape[-1] != WIDTHS[dim]:
        raise InputError(where, f"has the shape {numbers.shape}", f"a Pose, or {FORMS[dim]}")
    if not np.all(np.isfinite(numbers)):
        raise InputError(where, "contains NaN or an infinite value", "finite numbers")
    return numbers
