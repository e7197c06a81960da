"""What is known of the distance of two placed sets, with proof and gradient."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose

Flags = npt.NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class SignedDistance:
    """Of A and B at one pose or a batch of them; d is their dimension, all in the world frame.

    Attributes:
        distance: (...) in metres; negative for sets that overlap: the shortest translation that
            parts them, with a minus sign.
        normal: unit (..., d), from A to B.
        point_a, point_b: points of A and B (..., d) in metres, the second being the first and
            ``distance`` times the normal. Not unique, for example for parallel faces.
        lower_bound: (...) the plane bound of the normal: a proof, up to rounding.
        upper_bound: (...) the distance of the two points, for sets apart; for sets that overlap,
            what is proven from inside: they do not part by less than its negative.
        gradient_a, gradient_b: (..., 6), (..., 3) in the plane: of the distance, by the pose of A
            and by that of B. First d numbers per metre that the pose moves in the world; then per
            rad that it turns about its own origin, about the world's axes.

    The gradient is that of the value, by the envelope theorem: the bound n·(r_B − r_A) −
    h_A(R_Aᵀn) − h_B(−R_Bᵀn) is largest at the normal, so that only its explicit dependence counts,
    and no derivative of a normal or a point is taken. Where the distance has a kink, as for
    parallel faces that turn, it is one of the subgradients.
    """

    distance: Array
    normal: Array
    point_a: Array
    point_b: Array
    lower_bound: Array
    upper_bound: Array
    gradient_a: Array
    gradient_b: Array

    def __getitem__(self, index: Any) -> SignedDistance:
        """Of some of the poses: ``found[3]``, ``found[mask]``."""
        return SignedDistance(*(np.asarray(getattr(self, f.name)[index]) for f in fields(self)))

    def improved(self, where: Flags, other: SignedDistance) -> SignedDistance:
        """With those of ``other``, one for each true entry of ``where``, that prove more."""
        columns = {f.name: np.array(getattr(self, f.name)) for f in fields(self)}
        better = np.zeros(where.shape, dtype=bool)
        better[where] = other.lower_bound > self.lower_bound[where]
        for name, column in columns.items():
            column[better] = getattr(other, name)[better[where]]
        return SignedDistance(**columns)

    @staticmethod
    def joined(parts: list[SignedDistance], axis_shape: tuple[int, ...]) -> SignedDistance:
        """Single answers as one batch of this shape."""
        columns = {}
        for field in fields(SignedDistance):
            column = np.stack([getattr(part, field.name) for part in parts])
            columns[field.name] = np.reshape(column, (*axis_shape, *column.shape[1:]))
        return SignedDistance(**columns)


def pose_gradients(normal: Array, middle: Array, pose_a: Pose, pose_b: Pose) -> tuple[Array, Array]:
    """By the pose of A and of B, from the unit normal and any point of the line of both witnesses.

    The bound changes by n·δr_B − n·δr_A; and where B turns by θ, its support point x_B moves by
    θ × x_B, along n by θ·(x_B × n).
    """
    if normal.shape[-1] == 2:
        x, y = np.moveaxis(middle - pose_a.position, -1, 0)
        about_a = (x * normal[..., 1] - y * normal[..., 0])[..., None]
        x, y = np.moveaxis(middle - pose_b.position, -1, 0)
        about_b = (x * normal[..., 1] - y * normal[..., 0])[..., None]
    else:
        about_a = np.cross(middle - pose_a.position, normal)
        about_b = np.cross(middle - pose_b.position, normal)
    return (
        np.concatenate([-normal, -about_a], axis=-1),
        np.concatenate([normal, about_b], axis=-1),
    )
