"""Into a bay that is closed on five sides, with a probe that ends in a socket."""

from __future__ import annotations

import numpy as np

from benchmarks.tight3d._crafts import SIMPLE, craft
from benchmarks.tight3d._motion import At, through
from benchmarks.tight3d._scene import (
    Case,
    Craft,
    Flight,
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


def make(family: str, seed: int, rng: np.random.Generator) -> Case:
    """The bay opens towards −x; the probe points along +x."""
    margin = round(float(rng.uniform(0.05, 0.08)), 3)
    gap, socket_gap = margin + rng.uniform(0.03, 0.15, 2)
    size = np.array([rng.uniform(1.0, 2.5), *rng.uniform(0.8, 1.8, 2)])
    probe, radius = float(rng.uniform(0.4, 0.9)), float(rng.uniform(0.08, 0.2))
    hull = craft(rng, size, SIMPLE)
    front = 0.5 * size[0]
    parts = [*hull.parts, part("probe", rod(radius, probe), (front + 0.5 * probe, 0, 0))]
    own = Craft(parts, size + np.array([2.0 * probe, 0.0, 0.0]))
    # In the bay's frame the hull's front comes to rest at x = 0, its socket's ring behind that.
    hole, wall = size[1:] + 2.0 * gap, float(rng.uniform(0.1, 0.3))
    depth, socket = float(size[0] * rng.uniform(0.5, 1.0)), float(probe * rng.uniform(0.5, 0.9))
    outer = hole + 2.0 * wall
    back = gap + max(socket, probe)
    walls = ring("wall", hole, depth + back, outer, along_x(0.5 * (back - depth)))
    socket_at = along_x(gap + 0.5 * socket)
    walls += ring("socket", np.full(2, 2.0 * (radius + socket_gap)), socket, hole, socket_at)
    walls.append(part("back", box(wall, *outer), along_x(back + 0.5 * wall)))
    goal, mouth = along_x(-front), along_x(-depth - own.radius - margin - 0.1)
    away = np.array([-rng.uniform(0.5, 3.0), *rng.uniform(-3.0, 3.0, 2)])
    start = At(mouth.r + away, random_turn(rng))
    frame = random_frame(rng)
    return case(
        family, seed, rng, margin, frame, [Flight(own, through(start, mouth, goal))],
        [structure("bay", walls, frame)],
        f"A bay that leaves {gap - margin:.3f} m beyond the margin, and its socket "
        f"{socket_gap - margin:.3f} m about the probe.",
    )  # fmt: skip
