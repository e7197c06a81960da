"""Where a search looks, and how large its steps are."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.enclosing import extents
from berthing.routes.checker import Checker
from berthing.scenario.structure import Structure
from berthing.verify.frames import lifted

# Room beyond everything, in reaches of all vehicles: enough to pass on any side.
ROOM = 1.2

# A step of the search, and the pads that it keeps beyond margins, one after the other, in reaches
# of the largest vehicle: small steps slide well, and a pad wider than what a passage leaves closes
# it.
STEP = 0.04
PADS = (2e-3, 4e-4, 4e-5)

# What has less reach than this share of the region is taken for that large.
SMALLEST = 0.1


@dataclass(frozen=True, eq=False)
class Region:
    """Corners (3,) of the positions to look at in metres, and the lengths of a search.

    Attributes:
        step_m: of the search.
        pads_m: to be kept beyond margins, the widest first.
        span_m: the diagonal.
        detour: by which ways may be longer than the straight one, in lengths of that and reaches:
            all are in an ellipsoid. Infinite where any may be taken.
    """

    lower_m: Array
    upper_m: Array
    step_m: float
    pads_m: tuple[float, ...]
    detour: float = np.inf

    @property
    def span_m(self) -> float:
        return float(np.linalg.norm(self.upper_m - self.lower_m))

    @staticmethod
    def of(checker: Checker, start: Array, goal: Array) -> Region:
        """About both ends (V, 7) and all structures."""
        points = [start[:, :3], goal[:, :3], *_corners(checker.scenario.structures)]
        around = np.concatenate(points)
        arms = checker.space.arm_m
        margin = float(np.max(checker.margins_m, initial=0.0))
        room = ROOM * float(np.sum(arms)) + 2.0 * margin
        lower, upper = np.min(around, axis=0) - room, np.max(around, axis=0) + room
        size = max(float(np.max(arms)), SMALLEST * float(np.linalg.norm(upper - lower)))
        return Region(lower, upper, STEP * size, tuple(pad * size for pad in PADS))


def _corners(structures: tuple[Structure, ...]) -> list[Array]:
    """Least and largest coordinates (2, 3) of each bounded part, in inertial axes."""
    found = []
    for structure in structures:
        frame = structure.motion.pose(np.zeros(1))[0]
        for part in structure.body.parts:
            if np.isfinite(part.shape.bounding_radius):
                found.append(lifted(extents(part.shape, frame.compose(part.placement))))
    return found
