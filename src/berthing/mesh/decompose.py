"""A solid as a union of convex pieces that provably contain it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.polytope import Polytope
from berthing.mesh.choose import chosen
from berthing.mesh.coacd_run import nearly_convex
from berthing.mesh.coverage import Coverage, coverage
from berthing.mesh.fit import Fit, fits
from berthing.mesh.hull import hull_volume
from berthing.mesh.merge import joined
from berthing.mesh.piece import Piece
from berthing.mesh.settings import LARGEST_PUSH, DecomposeSettings
from berthing.mesh.solid import Solid
from berthing.mesh.subtract import SLACK

# CoACD's thresholds, tried in turn until the hulls leave room in the budget of volume.
THRESHOLDS = (0.05, 0.025, 0.0125)
# Hulls may use this part of the volume that pieces may add; joining parts and simplifying them
# use the rest, half each.
HULL_SHARE = 0.6
# A solid whose hull adds less than this part of its volume is convex.
CONVEX = 1e-9
# The least push, of the size of the solid: CoACD's cuts are rounded by about 1e-8 of it.
LEAST_PUSH = 1e-7
# The push takes volume too, and is known only once the pieces are chosen.
BUDGET_ROUNDS = 4
# By which a push grows that was not enough.
PUSH_GROWTH = 1.5


@dataclass(frozen=True, eq=False)
class Cover:
    """Pieces that were proven to contain a solid.

    Attributes:
        pieces: in the frame of the solid.
        push_m: by how much their faces were moved out for the sake of the proof.
        coverage: what the proof found: nothing left.
        threshold: of CoACD; 0 where it was not needed.
    """

    pieces: tuple[Piece, ...]
    push_m: float
    coverage: Coverage
    threshold: float

    @property
    def volume(self) -> float:
        """Sum of the pieces' volumes in m³; what they share counts twice."""
        return sum(piece.volume for piece in self.pieces)


def decompose(solid: Solid, settings: DecomposeSettings) -> Cover:
    """Pieces that contain the solid, few and simple ones.

    Raises:
        InputError: CoACD is missing or failed, or no push that is allowed makes the pieces cover.
    """
    parts, threshold = _parts(solid, settings)
    options = [found for points in parts if (found := fits(points, settings.volume_ratio))]
    pieces, push = _within_budget(solid, options, settings.volume_ratio * solid.volume)
    return _pushed_out(solid, pieces, push, threshold, settings)


def _parts(solid: Solid, settings: DecomposeSettings) -> tuple[list[Array], float]:
    """Clouds of points whose hulls nearly cover the solid, and CoACD's threshold."""
    if hull_volume(solid.vertices) <= (1.0 + CONVEX) * solid.volume:
        return [solid.vertices], 0.0
    allowed = (1.0 + HULL_SHARE * (settings.volume_ratio - 1.0)) * solid.volume
    best, best_total, best_threshold = list[Array](), np.inf, 0.0
    for threshold in THRESHOLDS:
        parts = nearly_convex(solid, threshold, settings.seed)
        total = sum(map(hull_volume, parts))
        if total < best_total:
            best, best_total, best_threshold = parts, total, threshold
        if total <= allowed:
            break
    spare = settings.volume_ratio * solid.volume - best_total
    return joined(best, 0.5 * spare), best_threshold


def _within_budget(
    solid: Solid, options: Sequence[Sequence[Fit]], volume_m3: float
) -> tuple[list[Piece], float]:
    """Pieces that keep to the budget of volume when pushed, if any do, and the least push."""
    spend = volume_m3
    for _ in range(BUDGET_ROUNDS):
        pieces = [fit.build() for fit in chosen(options, spend)]
        push = max(LEAST_PUSH * solid.size, _short(solid, [p.core for p in pieces]))
        excess = sum(piece.pushed(push).volume for piece in pieces) - volume_m3
        if excess <= 0.0:
            break
        spend -= 1.1 * excess
    return pieces, push


def _pushed_out(
    solid: Solid,
    pieces: Sequence[Piece],
    push: float,
    threshold: float,
    settings: DecomposeSettings,
) -> Cover:
    largest = settings.largest_push_m or LARGEST_PUSH * solid.size
    while True:
        push = min(push, largest)
        # As they will be read from a file: the proof is of what is written.
        moved = [Piece.from_json(p.pushed(push).to_json(), solid.name) for p in pieces]
        found = coverage(solid, [piece.core for piece in moved])
        if found.proven:
            return Cover(tuple(moved), push, found, threshold)
        if push >= largest:
            raise _uncovered(solid, found, largest)
        push *= PUSH_GROWTH


def _short(solid: Solid, cores: Sequence[Polytope]) -> float:
    """How far the worst vertex is outside every core, in metres: no smaller push can do."""
    least = np.full(len(solid.vertices), np.inf)
    for core in cores:
        outside = np.max(solid.vertices @ core.A.T - core.b, axis=1)
        least = np.minimum(least, outside)
    return float(np.max(least)) + 2.0 * SLACK * solid.size


def _uncovered(solid: Solid, found: Coverage, push: float) -> InputError:
    if found.voids is None:
        left = f"{found.uncovered_triangles} triangles ({found.uncovered_area_m2:.3g} m²) stick out"
    else:
        left = f"they leave {found.voids} gaps inside the solid"
    what = f"could not be covered: with its pieces pushed out by {1e3 * push:.3g} mm, {left}"
    return InputError(solid.name, what, "a finer volume ratio, or a larger push allowed")
