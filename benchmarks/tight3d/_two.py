"""Two vehicles through one opening, from opposite sides."""

from __future__ import annotations

import numpy as np

from benchmarks.tight3d._crafts import SIMPLE, craft
from benchmarks.tight3d._motion import At, Leg, first, last, through, wait
from benchmarks.tight3d._scene import (
    Case,
    Craft,
    Flight,
    along_x,
    case,
    random_frame,
    random_turn,
    ring,
    structure,
)

WALL_M = 16.0


def make(family: str, seed: int, rng: np.random.Generator) -> Case:
    """In the witness the first goes while the second waits, and then the second."""
    margin = round(float(rng.uniform(0.05, 0.1)), 3)
    spare = float(rng.uniform(0.03, 0.2))
    size = rng.uniform([1.2, 0.6, 0.6], [2.5, 1.3, 1.3], (2, 3))
    crafts = [craft(rng, own, SIMPLE) for own in size]
    hole = np.max(size[:, 1:], axis=0) + 2.0 * (margin + spare)
    thick = float(rng.uniform(0.2, 1.0))
    # Lanes beside the opening, on opposite sides: who waits in one leaves room in front of the
    # opening and in the other lane, at any attitude.
    lane = sum(c.radius for c in crafts) + margin + 0.1
    one = _passage(rng, crafts[0], (-1.0, lane), thick, margin, crafts[1].radius)
    other = _passage(rng, crafts[1], (1.0, -lane), thick, margin, crafts[0].radius)
    took = [sum(leg.duration_s for leg in legs) for legs in (one, other)]
    flights = [
        Flight(crafts[0], [*one, wait(last(one), took[1])], "alpha"),
        Flight(crafts[1], [wait(first(other), took[0]), *other], "beta"),
    ]
    frame = random_frame(rng)
    return case(
        family, seed, rng, margin, frame, flights,
        [structure("wall", ring("wall", hole, thick, np.full(2, WALL_M)), frame)],
        f"Two vehicles change sides through one opening that leaves them {spare:.3f} m or more "
        "beyond the margin.",
    )  # fmt: skip


def _passage(
    rng: np.random.Generator, own: Craft, side: tuple[float, float], thick: float, margin: float,
    other: float,
) -> list[Leg]:  # fmt: skip
    """From one side of the wall to the other and back into the lane it came from.

    The other vehicle waits in the other lane, beyond the place before the opening.
    """
    sign, lane = side
    clear = 0.5 * thick + own.radius + margin + 0.1
    # Beyond this nothing of this vehicle, before the opening in any attitude, is reached.
    far = clear + other + margin + 0.1 + own.radius
    ends = [
        At(np.array([s * (far + rng.uniform(0.0, 1.5)), lane, rng.uniform(-0.5, 0.5)]),
           random_turn(rng, 2.0))
        for s in (sign, -sign)
    ]  # fmt: skip
    mouths = [along_x(s * clear) for s in (sign, -sign)]
    return through(ends[0], *mouths, ends[1])
