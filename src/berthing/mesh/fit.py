"""Simple outer bounds of a cloud of points: polytopes of few faces, a box, a cylinder."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.convex_set import norm
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.mesh.box_fit import PlacedBox, box_around
from berthing.mesh.hull import HalfSpaces, hull_volume, outer_bound
from berthing.mesh.piece import ROUNDING, Piece

# Faces whose normals are within one of these angles are joined; the steps give a choice.
ANGLES_DEG = (45.0, 35.0, 28.0, 22.0, 17.0, 13.0, 10.0, 7.0, 5.0, 3.0, 1.0, 0.0)
# What a piece costs the planner, in flat faces: a box has three multipliers, a cylinder two.
BOX_FACES, CYLINDER_FACES = 5, 3
# No piece adds more than so many times the share of its volume that all together may add.
LARGEST_SHARE = 2.0
# Nor do corners that appear where faces are joined stand out by more of its size than this.
LARGEST_SPIKE = 0.07


@dataclass(frozen=True, eq=False)
class Fit:
    """A way to contain certain points.

    Attributes:
        volume: in m³.
        cost: how much it makes the planner do, in faces.
        build: makes the piece.
    """

    volume: float
    cost: int
    build: Callable[[], Piece]


def fits(points: Array, volume_ratio: float) -> list[Fit]:
    """Outer bounds of points (n, 3), the tightest first, each cheaper than the one before.

    Empty where the points lie in one plane.

    Args:
        volume_ratio: that all pieces together are to keep.
    """
    growth = 1.0 + LARGEST_SHARE * (volume_ratio - 1.0)
    tight = hull_volume(points)
    if tight <= 0.0:
        return []
    spike = LARGEST_SPIKE * float(norm(np.ptp(points, axis=0)))
    bounds = [outer_bound(points, angle) for angle in ANGLES_DEG]
    found = [_as_polytope(b) for b in bounds if b is not None and b.spike <= spike]
    box = box_around(points)
    found += [_as_box(box), _as_cylinder(points, box)]
    kept: list[Fit] = []
    for fit in sorted(found, key=lambda f: (f.volume, f.cost)):
        if fit.volume <= growth * tight and (not kept or fit.cost < kept[-1].cost):
            kept.append(fit)
    return kept


def _as_polytope(bound: HalfSpaces) -> Fit:
    def build() -> Piece:
        return Piece(Polytope(bound.A, bound.b), Pose.identity())

    return Fit(bound.volume, len(bound.b), build)


def _as_box(box: PlacedBox) -> Fit:
    half, pose = box
    volume = float(np.prod(2.0 * half))
    return Fit(volume, BOX_FACES, lambda: Piece(Box(half), pose))


def _as_cylinder(points: Array, box: PlacedBox) -> Fit:
    """About the longest axis of the box; wide enough for its core to contain the points."""
    half, pose = box
    axes = np.roll(pose.rotation, -int(np.argmax(half)), axis=1)
    local = (points - pose.position) @ axes
    half_length = float(np.max(np.abs(local[:, 0])))
    radius = ROUNDING * float(np.max(norm(local[:, 1:])))
    placed = Pose(pose.position, axes)
    return Fit(
        float(np.pi * radius**2 * 2.0 * half_length),
        CYLINDER_FACES,
        lambda: Piece(Cylinder(radius, half_length, "x"), placed),
    )
