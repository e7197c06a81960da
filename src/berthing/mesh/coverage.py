"""Proof that pieces contain a solid: its surface, and everything inside it.

The surface: every triangle less all pieces leaves nothing.

The inside: suppose a point of the solid S lies in no piece. Follow the open set of uncovered points
around it. It cannot pass through the surface of S, for that is covered, so it stays within S and is
bounded; hence it ends at a face of some piece, in a place that no other piece covers. All such
places are found (every face of every piece less the other pieces), and each lies wholly in S or
wholly outside, since the surface of S passes through none of them; the winding number of S about
one of its points tells which. If all lie outside, there is no such point.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array
from berthing.geometry.polytope import Polytope
from berthing.mesh.faces import faces
from berthing.mesh.solid import Solid
from berthing.mesh.subtract import SLACK, area, remainder
from berthing.mesh.winding import winding_number

# Points and triangles that are compared at once.
CHUNK = 1 << 22
# For faces less other pieces, so that what remains of them keeps clear of the surface, which is
# covered with the whole slack.
FACE_SLACK = 0.25 * SLACK


@dataclass(frozen=True)
class Coverage:
    """What pieces leave of a solid.

    Attributes:
        uncovered_area_m2: of its surface.
        uncovered_triangles: that any is left of.
        voids: places where a gap inside the solid begins; None where the surface is not covered.
    """

    uncovered_area_m2: float
    uncovered_triangles: int
    voids: int | None

    @property
    def proven(self) -> bool:
        """Whether the pieces contain the solid."""
        return self.uncovered_triangles == 0 and self.voids == 0


def coverage(solid: Solid, cores: Sequence[Polytope]) -> Coverage:
    """What the polytopes, in the frame of the solid, leave of it."""
    slack = SLACK * solid.size
    halves = [(core.A, core.b) for core in cores]
    corners = solid.corners
    doubtful = np.flatnonzero(~_within_one(solid, halves, slack))
    spheres = [_Reach(core) for core in cores]
    lost_area, lost = 0.0, 0
    for i in doubtful:
        near = [half for half, reach in zip(halves, spheres, strict=True) if reach.of(corners[i])]
        left = remainder(corners[i], near, slack)
        lost += bool(left)
        lost_area += sum(map(area, left))
    voids = None if lost else _voids(solid, cores, spheres)
    return Coverage(lost_area, lost, voids)


def _within_one(
    solid: Solid, halves: Sequence[tuple[Array, Array]], slack: float
) -> npt.NDArray[np.bool_]:
    """Which triangles (m,) have all corners, hence all of them, in one and the same polytope."""
    found = np.zeros(len(solid.triangles), dtype=np.bool_)
    for A, b in halves:
        step = max(1, CHUNK // len(b))
        inside = np.concatenate(
            [
                np.all(solid.vertices[i : i + step] @ A.T <= b - 0.5 * slack, axis=1)
                for i in range(0, len(solid.vertices), step)
            ]
        )
        found |= np.all(inside[solid.triangles], axis=1)
    return found


class _Reach:
    """The axis-parallel box around a polytope."""

    def __init__(self, core: Polytope) -> None:
        self.lower, self.upper = core.corners.min(axis=0), core.corners.max(axis=0)

    def of(self, points: Array) -> bool:
        """Whether the box around points (k, 3) meets it."""
        apart = (points.min(axis=0) > self.upper) | (points.max(axis=0) < self.lower)
        return not np.any(apart)


def _voids(solid: Solid, cores: Sequence[Polytope], reaches: Sequence[_Reach]) -> int:
    slack = FACE_SLACK * solid.size
    places = []
    for i, core in enumerate(cores):
        near = [
            (other.A, other.b)
            for j, (other, reach) in enumerate(zip(cores, reaches, strict=True))
            if j != i and reach.of(core.corners)
        ]
        for face in faces(core):
            places += [part.mean(axis=0) for part in remainder(face, near, slack)]
    if not places:
        return 0
    return int(np.sum(winding_number(solid, np.array(places)) > 0.5))
