"""Where a frame lies in another: x_outer = rotation @ x_own + position."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import DIMENSIONS

# Largest entry of RᵀR − 1 that is taken for rounding: it distorts a body of 100 m by 1e-7 m.
# A matrix from a quaternion is within 1e-15.
ORTHONORMALITY_TOLERANCE = 1e-9


@dataclass(frozen=True, eq=False)
class Pose:
    """One pose or a batch of them.

    Attributes:
        position: the origin of the own frame, (..., d) in metres, outer frame; d is 2 or 3.
        rotation: (..., d, d), v_outer = rotation @ v_own. Batch axes broadcast against those of
            ``position``.

    Raises:
        InputError: shapes that do not fit, entries that are not finite, or a matrix that is not
            a proper rotation.
    """

    position: Array
    rotation: Array

    def __post_init__(self) -> None:
        position, rotation = _broadcast(self.position, self.rotation)
        _check_rotation(rotation)
        object.__setattr__(self, "position", position)
        object.__setattr__(self, "rotation", rotation)

    @property
    def dim(self) -> int:
        """2 or 3."""
        return int(self.position.shape[-1])

    @property
    def batch_shape(self) -> tuple[int, ...]:
        """() for a single pose."""
        return self.position.shape[:-1]

    @staticmethod
    def identity(dim: int = 3) -> Pose:
        """The frame itself."""
        return Pose(np.zeros(dim), np.eye(dim))

    @staticmethod
    def from_quaternion(position: Array, q: Array) -> Pose:
        """From r (..., 3) and q_IB (..., 4), normalised here; InputError where q is zero."""
        return Pose(position, quaternion.rotation_matrix(q))

    @staticmethod
    def sound(position: Array, rotation: Array) -> Pose:
        """From floats (k, d) and (k, d, d) that are proper rotations by their making, unchecked.

        The checks of the constructor cost more than a query of 20 poses.
        """
        return _trusted(position, rotation)

    @staticmethod
    def planar(position: Array, angle: Array | float) -> Pose:
        """From r (..., 2) and the counter-clockwise angle (...) in rad."""
        angle = np.asarray(angle, dtype=np.float64)
        c, s = np.cos(angle), np.sin(angle)
        rows = [np.stack([c, -s], axis=-1), np.stack([s, c], axis=-1)]
        return Pose(position, np.stack(rows, axis=-2))

    def apply(self, points: Array) -> Array:
        """Points (..., d) of the own frame, in the outer frame; batch axes broadcast."""
        return self.rotate(points) + self.position

    def rotate(self, vectors: Array) -> Array:
        """Free vectors (..., d) of the own frame, in the outer frame."""
        return np.asarray(np.einsum("...ij,...j->...i", self.rotation, vectors))

    def unrotate(self, vectors: Array) -> Array:
        """Free vectors (..., d) of the outer frame, in the own frame."""
        return np.asarray(np.einsum("...ji,...j->...i", self.rotation, vectors))

    def compose(self, other: Pose) -> Pose:
        """self ∘ other: ``other`` is given in this pose's own frame."""
        if self.dim != other.dim:
            raise InputError(
                "Pose.compose", f"joins {self.dim} with {other.dim} dimensions", "the same"
            )
        return _trusted(self.apply(other.position), self.rotation @ other.rotation)

    def inverse(self) -> Pose:
        """The outer frame seen from the own frame."""
        return _trusted(-self.unrotate(self.position), np.swapaxes(self.rotation, -1, -2))

    def __getitem__(self, index: Any) -> Pose:
        """Index the batch axes: ``poses[3]``, ``poses[:, None]``, ``poses[mask]``."""
        key = index if isinstance(index, tuple) else (index,)
        whole = slice(None)
        return _trusted(self.position[(*key, whole)], self.rotation[(*key, whole, whole)])

    def __len__(self) -> int:
        """Length of the first batch axis; TypeError for a single pose."""
        if not self.batch_shape:
            raise TypeError("a single pose has no length")
        return self.batch_shape[0]


def _trusted(position: Array, rotation: Array) -> Pose:
    """A pose made of sound poses: no second check, and results that broadcast are spread out."""
    pose = object.__new__(Pose)
    if position.shape[:-1] != rotation.shape[:-2]:
        batch = np.broadcast_shapes(position.shape[:-1], rotation.shape[:-2])
        dim = position.shape[-1]
        position = np.broadcast_to(position, (*batch, dim))
        rotation = np.broadcast_to(rotation, (*batch, dim, dim))
    object.__setattr__(pose, "position", position)
    object.__setattr__(pose, "rotation", rotation)
    return pose


def _broadcast(position: Array, rotation: Array) -> tuple[Array, Array]:
    try:
        position = np.array(position, dtype=np.float64)
        rotation = np.array(rotation, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError("Pose", "position or rotation is not an array of numbers") from None
    dim = position.shape[-1] if position.ndim else 0
    if dim not in DIMENSIONS:
        raise InputError("Pose.position", f"has the shape {position.shape}", "(..., 2 or 3)")
    if rotation.shape[-2:] != (dim, dim):
        raise InputError("Pose.rotation", f"has the shape {rotation.shape}", f"(..., {dim}, {dim})")
    try:
        batch = np.broadcast_shapes(position.shape[:-1], rotation.shape[:-2])
    except ValueError:
        raise InputError(
            "Pose", f"batches {position.shape[:-1]} and {rotation.shape[:-2]} do not fit"
        ) from None
    if not np.all(np.isfinite(position)):
        raise InputError("Pose.position", "contains NaN or an infinite value", "finite numbers")
    return np.broadcast_to(position, (*batch, dim)), np.broadcast_to(rotation, (*batch, dim, dim))


def _check_rotation(rotation: Array) -> None:
    gram = np.swapaxes(rotation, -1, -2) @ rotation - np.eye(rotation.shape[-1])
    # Written so that NaN fails too.
    if not np.all(np.abs(gram) <= ORTHONORMALITY_TOLERANCE):
        raise InputError("Pose.rotation", "is not orthonormal", "a rotation matrix")
    if rotation.size and not np.all(np.linalg.det(rotation) > 0.0):
        raise InputError("Pose.rotation", "mirrors (determinant −1)", "a proper rotation")
