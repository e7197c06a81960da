"""Through a window in a wall, which the vehicle fits only after a quarter turn."""

from __future__ import annotations

import numpy as np

from benchmarks.tight3d._crafts import SIMPLE, craft
from benchmarks.tight3d._motion import At, through
from benchmarks.tight3d._scene import (
    Case,
    Flight,
    about,
    along_x,
    case,
    random_frame,
    random_turn,
    ring,
    structure,
)
from berthing.geometry import quaternion

WALL_M = 14.0


def make(family: str, seed: int, rng: np.random.Generator) -> Case:
    """Both ends lie across the window, so that no straight way at one attitude leads through."""
    margin = round(float(rng.uniform(0.05, 0.1)), 3)
    gap = margin + float(rng.uniform(0.03, 0.2))
    # Longer than wide than high: turned over about the way or across it, it does not fit.
    height = rng.uniform(0.5, 1.0)
    width = height + 2.0 * gap + rng.uniform(0.3, 1.0)
    size = np.array([width + rng.uniform(0.3, 1.5), width, height])
    own = craft(rng, size, SIMPLE)
    thick = float(rng.uniform(0.1, 0.6))
    wall = ring("wall", size[1:] + 2.0 * gap, thick, np.full(2, WALL_M))
    over = about("x", rng.choice([-1.0, 1.0]) * 0.5 * np.pi)
    if rng.random() < 0.5:
        over = np.asarray(quaternion.multiply(about("z", 0.5 * np.pi), over))
    clear = 0.5 * thick + own.radius + margin + 0.1
    ends = [
        At(
            np.array([side * (clear + rng.uniform(0.3, 1.5)), *rng.uniform(-0.8, 0.8, 2)]),
            np.asarray(quaternion.multiply(over, random_turn(rng, 0.2))),
        )
        for side in (-1.0, 1.0)
    ]
    mouths = [along_x(side * clear) for side in (-1.0, 1.0)]
    frame = random_frame(rng)
    return case(
        family, seed, rng, margin, frame, [Flight(own, through(ends[0], *mouths, ends[1]))],
        [structure("wall", wall, frame)],
        f"A window that leaves {gap - margin:.3f} m on each side beyond the margin, and nothing "
        "before a quarter turn.",
    )  # fmt: skip
