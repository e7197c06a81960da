"""Through a long corridor: square, or a tube of staves."""

from __future__ import annotations

import numpy as np

from benchmarks.tight3d._crafts import SIMPLE, craft
from benchmarks.tight3d._motion import At, through
from benchmarks.tight3d._scene import (
    Case,
    Craft,
    Flight,
    about,
    along_x,
    case,
    part,
    random_frame,
    random_turn,
    ring,
    rod,
    structure,
)
from support.documents import box

SPARE_M = (0.02, 0.2)
"""Room on each side beyond the margin."""

BULKHEAD_M = 14.0
"""Side of the wall that the corridor leads through: there is no time to go around it."""


def make(family: str, seed: int, rng: np.random.Generator) -> Case:
    """Start and goal lie off the axis, in any attitude."""
    margin = round(float(rng.uniform(0.05, 0.1)), 3)
    gap = margin + float(np.exp(rng.uniform(*np.log(SPARE_M))))
    kind = _tube if rng.random() < 0.4 else _square
    own, walls, length = kind(rng, gap)
    clear = 0.5 * length + own.radius + margin + 0.1
    ends = [
        At(np.array([side * (clear + rng.uniform(0.4, 2.0)), *rng.uniform(-2.0, 2.0, 2)]),
           random_turn(rng, 2.0))
        for side in (-1.0, 1.0)
    ]  # fmt: skip
    mouths = [along_x(side * clear) for side in (-1.0, 1.0)]
    frame = random_frame(rng)
    return case(
        family, seed, rng, margin, frame, [Flight(own, through(ends[0], *mouths, ends[1]))],
        [structure("corridor", walls, frame)],
        f"A corridor {length:.2f} m long that leaves {gap - margin:.3f} m on each side beyond the "
        "margin.",
    )  # fmt: skip


def _square(rng: np.random.Generator, gap: float) -> tuple[Craft, list[dict], float]:
    size = np.array([rng.uniform(1.5, 4.0), *rng.uniform(0.8, 2.0, 2)])
    length, wall = float(size[0] * rng.uniform(0.8, 2.0)), float(rng.uniform(0.1, 0.4))
    hole = size[1:] + 2.0 * gap
    walls = ring("wall", hole, length, hole + 2.0 * wall)
    at = along_x(rng.uniform(-0.3, 0.3) * length)
    walls += ring("bulkhead", hole, 0.3, np.full(2, BULKHEAD_M), at)
    return craft(rng, size, SIMPLE), walls, length


def _tube(rng: np.random.Generator, gap: float) -> tuple[Craft, list[dict], float]:
    radius, body = rng.uniform(0.5, 1.0), rng.uniform(1.5, 3.5)
    length, wall, count = float(body * rng.uniform(0.8, 2.0)), 0.2, int(rng.integers(6, 10))
    clear = radius + gap
    width = 2.0 * (clear + wall) * np.tan(np.pi / count)
    walls = []
    for i in range(count):
        turn = 2.0 * np.pi * i / count
        middle = (clear + 0.5 * wall) * np.array([0.0, np.cos(turn), np.sin(turn)])
        stave = box(length, wall, float(width))
        walls.append(part(f"stave-{i}", stave, At(middle, about("x", turn))))
    outside = np.full(2, 2.0 * (clear + wall))
    walls += ring("bulkhead", outside, 0.3, np.full(2, BULKHEAD_M))
    kind = "capsule" if rng.random() < 0.5 else "cylinder"
    straight = body - 2.0 * radius if kind == "capsule" else body
    if straight < 0.2:
        kind, straight = "cylinder", body
    parts = [part("hull", rod(radius, straight, kind=kind))]
    return Craft(parts, np.array([body, 2.0 * radius, 2.0 * radius])), walls, length
