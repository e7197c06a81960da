"""Simple outer bounds of a cloud of points: polytopes of few faces, and a box."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.convex_set import norm
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.mesh.box_fit import PlacedBox, box_around
from berthing.mesh.hull import HalfSpaces, hull_volume, outer_bound
from berthing.mesh.piece import Piece

# Faces whose normals are within one of these angles are joined; the steps give a choice.
ANGLES_DEG = (45.0, 35.0, 28.0, 22.0, 17.0, 13.0, 10.0, 7.0, 5.0, 3.0, 1.0, 0.0)
# What a box costs the planner, in flat faces: its rows come in pairs.
BOX_FACES = 5
# No piece grows by more than this for the sake of simplicity, whatever the budget.
LARGEST_GROWTH = 1.3
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


def fits(points: Array) -> list[Fit]:
    """Outer bounds of points (n, 3), the tightest first, each cheaper than the one before.

    Empty where the points lie in one plane.
    """
    tight = hull_volume(points)
    if tight <= 0.0:
        return []
    spike = LARGEST_SPIKE * float(norm(np.ptp(points, axis=0)))
    bounds = [outer_bound(points, angle) for angle in ANGLES_DEG]
    found = [_as_polytope(b) for b in bounds if b is not None and b.spike <= spike]
    found.append(_as_box(box_around(points)))
    kept: list[Fit] = []
    for fit in sorted(found, key=lambda f: (f.volume, f.cost)):
        if fit.volume <= LARGEST_GROWTH * tight and (not kept or fit.cost < kept[-1].cost):
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
