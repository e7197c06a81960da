"""From bay to bay inside a truss, and out through the one face that has no diagonal."""

from __future__ import annotations

from itertools import pairwise, product

import numpy as np

from benchmarks.tight3d._crafts import FORMS, craft
from benchmarks.tight3d._motion import At, through
from benchmarks.tight3d._scene import (
    Case,
    Document,
    Flight,
    case,
    part,
    random_frame,
    random_turn,
    rod,
    structure,
)
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array

FACES = {"+y": (1, 1.0), "-y": (1, -1.0), "+z": (2, 1.0), "-z": (2, -1.0)}
"""Axis and sign of the long faces."""


def make(family: str, seed: int, rng: np.random.Generator) -> Case:
    """The truss lies along x, bays of length ``bay`` and clear width ``side``."""
    margin = round(float(rng.uniform(0.05, 0.1)), 3)
    gap = margin + float(rng.uniform(0.05, 0.2))
    size = rng.uniform([1.2, 0.7, 0.7], [2.2, 1.4, 1.4])
    own = craft(rng, size, tuple(FORMS))
    radius = float(rng.uniform(0.03, 0.08))
    # Struts' axes lie on the edges of cubes; diagonals reach in by their radius.
    half = 0.5 * size[1:] + gap + radius
    bays = int(rng.integers(3, 6))
    bay = float(size[0] + 2.0 * (gap + radius) + rng.uniform(0.0, 0.5))
    leave = int(rng.integers(1, bays))
    name = list(FACES)[int(rng.integers(4))]
    axis, sign = FACES[name]
    middle = [At(np.array([(i + 0.5) * bay, 0.0, 0.0])) for i in (0, leave)]
    out = middle[1].r.copy()
    out[axis] = sign * (half[axis - 1] + radius + own.radius + margin + 0.1)
    goal = out + rng.uniform(-1.0, 1.0, 3)
    goal[axis] = out[axis] + sign * rng.uniform(0.2, 1.5)
    poses = [*middle, At(out), At(goal, random_turn(rng, 1.5))]
    frame = random_frame(rng)
    return case(
        family, seed, rng, margin, frame, [Flight(own, through(*poses))],
        [structure("truss", _struts(bays, bay, half, radius, (leave, name)), frame)],
        f"Inside a truss of {bays} bays that leaves {gap - margin:.3f} m beyond the margin, and "
        f"out through its face {name} in bay {leave + 1}.",
    )  # fmt: skip


def _struts(
    bays: int, bay: float, half: Array, radius: float, without: tuple[int, str]
) -> list[Document]:
    """Longerons, battens at every frame, and a diagonal on all faces but one."""
    corners = [half * s for s in ([1, 1], [-1, 1], [-1, -1], [1, -1])]
    ring = [*corners, corners[0]]
    out = [
        _strut(f"longeron-{i}", (0.0, *c), (bays * bay, *c), radius) for i, c in enumerate(corners)
    ]
    for k, (i, (a, b)) in product(range(bays + 1), enumerate(pairwise(ring))):
        out.append(_strut(f"batten-{k}-{i}", (k * bay, *a), (k * bay, *b), radius))
    for k, (name, (axis, sign)) in product(range(bays), FACES.items()):
        if (k, name) == without:
            continue
        across = half.copy()
        across[axis - 1] *= sign
        other = across.copy()
        other[2 - axis] *= -1.0
        ends = (k * bay, *across), ((k + 1) * bay, *other)
        out.append(
            _strut(f"diagonal-{k}-{'plus' if sign > 0 else 'minus'}-{name[1]}", *ends, radius)
        )
    # Closed at both ends.
    for k, end in ((0, "rear"), (bays, "front")):
        a, b = (k * bay, *corners[0]), (k * bay, *corners[2])
        out.append(_strut(f"brace-{end}", a, b, radius))
    return out


def _strut(name: str, a: tuple, b: tuple, radius: float) -> Document:
    """A capsule from a to b."""
    a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    length = float(np.linalg.norm(b - a))
    along = (b - a) / length
    # The half turn about the direction midway takes x to ``along``.
    midway = along + np.array([1.0, 0.0, 0.0])
    q = (
        np.array([0.0, *(midway / np.linalg.norm(midway))])
        if np.linalg.norm(midway) > 0.1
        else np.asarray(quaternion.from_axis_angle(np.array([0.0, 0.0, 1.0]), np.asarray(np.pi)))
    )
    return part(name, rod(radius, length, kind="capsule"), At(0.5 * (a + b), q))
