"""Baselines that part balls or ellipsoids around the sets in place of the sets themselves.

They are safe and conservative, for what they forbid may be free; they stand here to be compared.
"""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.enclosing import Enclosure, enclosing_ball, enclosing_ellipsoid
from berthing.geometry.pose import Pose
from berthing.proximity.formulation import PairFormulation, Rows, SymPose
from berthing.proximity.plane import PlaneFormulation
from berthing.sym import Sym


class EnclosedFormulation(PairFormulation):
    """``plane`` between an enclosure of each set."""

    def __init__(
        self, a: ConvexSet, b: ConvexSet, enclose: Callable[[ConvexSet], Enclosure]
    ) -> None:
        for shape in (a, b):
            if not np.isfinite(shape.bounding_radius):
                raise CapabilityError(
                    f"nothing encloses a {type(shape).__name__}, which has no bounds; `plane` and "
                    "`kkt` take it, and this form any bounded set, such as a Box"
                )
        self.a, self.b = enclose(a), enclose(b)
        self.plane = PlaneFormulation(self.a.shape, self.b.shape)
        self.variables = self.plane.variables

    def rows(
        self, v: Sym, pose_a: SymPose, pose_b: SymPose, margin_m: Sym, length_m: float,
        eps: Sym = 0.0,
    ) -> Rows:  # fmt: skip
        return self.plane.rows(
            v, _placed(pose_a, self.a.placement), _placed(pose_b, self.b.placement),
            margin_m, length_m, eps,
        )  # fmt: skip

    def start(self, pose_a: Pose, pose_b: Pose, normal: Array, eps: float = 0.0) -> Array:
        return self.plane.start(
            pose_a.compose(self.a.placement), pose_b.compose(self.b.placement), normal, eps
        )


def bounding_sphere(a: ConvexSet, b: ConvexSet) -> EnclosedFormulation:
    """``bounding-sphere`` for one pair of sets."""
    return EnclosedFormulation(a, b, enclosing_ball)


def bounding_ellipsoid(a: ConvexSet, b: ConvexSet) -> EnclosedFormulation:
    """``bounding-ellipsoid`` for one pair of sets."""
    return EnclosedFormulation(a, b, enclosing_ellipsoid)


def _placed(pose: SymPose, placement: Pose) -> SymPose:
    position, rotation = pose
    return (
        position + ca.mtimes(rotation, ca.DM(placement.position)),
        ca.mtimes(rotation, ca.DM(placement.rotation)),
    )
