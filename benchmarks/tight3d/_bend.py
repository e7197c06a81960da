"""Around a corner with a module longer than the corridors are wide."""

from __future__ import annotations

import numpy as np

from benchmarks.tight3d._crafts import SIMPLE, craft
from benchmarks.tight3d._motion import At, Leg, straight, time_for
from benchmarks.tight3d._scene import (
    Case,
    Flight,
    about,
    case,
    part,
    random_frame,
    random_turn,
    ring,
    structure,
)
from berthing.geometry.arrays import Array
from support.documents import box

SLAB_M = 0.3

OUTSIDE_M = 6.0
"""How far the wall on the diagonal reaches beyond the corridors."""


def make(family: str, seed: int, rng: np.random.Generator) -> Case:
    """Two corridors along x and y, their outer walls in the planes x = 0 and y = 0."""
    margin = round(float(rng.uniform(0.05, 0.1)), 3)
    spare = float(rng.uniform(0.03, 0.15))
    gap = margin + spare
    breadth, height = rng.uniform(0.4, 0.9), rng.uniform(0.4, 1.2)
    # With the gap around it: as broad as ``w``, and of the length ``L`` that just fits at 45°.
    w = breadth + 2.0 * gap
    W = w * rng.uniform(1.25, 1.6)
    L = 2.0 * (np.sqrt(2.0) * W - w) * rng.uniform(0.85, 1.0)
    size = np.array([L - 2.0 * gap, breadth, height])
    own = craft(rng, size, SIMPLE)
    long = float(W + L * rng.uniform(0.8, 1.3))
    legs = _legs(L, w, long, own.radius + margin + 0.1, rng)
    frame = random_frame(rng)
    return case(
        family, seed, rng, margin, frame, [Flight(own, legs)],
        [structure("bend", _walls(W, long, height + 2.0 * gap), frame)],
        f"Around a corner {W:.2f} m wide with a module {size[0]:.2f} m long; it leaves "
        f"{spare:.3f} m beyond the margin.",
    )  # fmt: skip


def _walls(W: float, long: float, high: float) -> list[dict]:
    """Outer and inner walls, floor and ceiling; the inner corner is at (W, W).

    A wall along the diagonal, open only where the corner is, keeps the way outside closed.
    """
    t, inner = SLAB_M, long - W
    tall, level = high + 2.0 * t, 0.5 * (high + t)
    out = [
        part("outer-x", box(long + t, t, tall), (0.5 * (long - t), -0.5 * t, 0)),
        part("outer-y", box(t, long, tall), (-0.5 * t, 0.5 * long, 0)),
        part("inner", box(inner, inner, tall), (W + 0.5 * inner, W + 0.5 * inner, 0)),
    ]
    for name, sign in (("ceiling", 1), ("floor", -1)):
        z = sign * level
        out += [
            part(f"{name}-x", box(long, W, t), (0.5 * long, 0.5 * W, z)),
            part(f"{name}-y", box(W, inner, t), (0.5 * W, W + 0.5 * inner, z)),
        ]
    # Its hole ends where its own edges would reach out of the corner's walls.
    corner, thin = np.sqrt(2.0) * W, 0.2
    at = At(np.array([0.5 * W, 0.5 * W, 0.0]), about("z", -0.25 * np.pi))
    around = corner + 2.0 * (long + OUTSIDE_M)
    return out + ring("diagonal", (corner + thin, high), thin, (around, 2.0 * OUTSIDE_M), at)


def _legs(L: float, w: float, long: float, clear: float, rng: np.random.Generator) -> list[Leg]:
    """In along the outer wall, around as a ladder slides down a wall, out along the other."""

    def around(s: Array) -> tuple[Array, Array]:
        # The ladder of length L and thickness w, its feet on both outer walls.
        angle = 0.5 * np.pi * s
        c, d = np.cos(angle), np.sin(angle)
        middle = np.stack([0.5 * (L * c + w * d), 0.5 * (L * d + w * c), np.zeros_like(s)], axis=1)
        return middle, np.stack([about("z", -a) for a in angle])

    begin, end = (_pose(*around(np.array([s]))) for s in (0.0, 1.0))
    mouths = [
        At(np.array([long + clear, 0.5 * w, 0.0]), begin.q),
        At(np.array([0.5 * w, long + clear, 0.0]), end.q),
    ]
    away = [np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])]
    first, last = (
        At(mouth.r + rng.uniform(0.2, 1.5) * out + np.array([0, 0, rng.uniform(-1.0, 1.0)]),
           random_turn(rng, 2.0))
        for mouth, out in zip(mouths, away, strict=True)
    )  # fmt: skip
    turn = Leg(time_for(0.8 * L, 0.5 * np.pi), around)
    return [
        straight(first, mouths[0]), straight(mouths[0], begin), turn,
        straight(end, mouths[1]), straight(mouths[1], last),
    ]  # fmt: skip


def _pose(r: Array, q: Array) -> At:
    return At(r[0], q[0])
