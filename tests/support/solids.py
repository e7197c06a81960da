"""Closed surfaces made by hand: brackets, a torus, a tube, trusses; and files of them."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from pathlib import Path

import numpy as np
from scipy.spatial import ConvexHull

from berthing.geometry.arrays import Array
from berthing.mesh.solid import Solid, Surface
from berthing.mesh.soundness import sound

# Corners (m, 3, 3) of triangles, counter-clockwise seen from outside.
Corners = Array

L_OUTLINE = ((0, 0), (0.4, 0), (0.4, 0.06), (0.06, 0.06), (0.06, 0.3), (0, 0.3))
C_OUTLINE = (
    (0, 0), (0.5, 0), (0.5, 0.08), (0.08, 0.08), (0.08, 0.42), (0.5, 0.42), (0.5, 0.5), (0, 0.5),
)  # fmt: skip


def box(size: Sequence[float], centre: Sequence[float] = (0, 0, 0)) -> Corners:
    x, y, z = size
    flat = extruded(((0, 0), (x, 0), (x, y), (0, y)), z, ((0, 1, 2), (0, 2, 3)))
    return flat - 0.5 * np.array(size) + np.array(centre)


def moved(points: Array, x: float, y: float, z: float) -> Array:
    """Points (..., 3), shifted."""
    return points + np.array([x, y, z], dtype=float)


def extruded(
    outline: Sequence[Sequence[float]], height: float, fan: Sequence[Sequence[int]]
) -> Corners:
    """An outline, counter-clockwise, drawn up along z; ``fan`` cuts it into triangles."""
    low = np.column_stack([np.array(outline, dtype=float), np.zeros(len(outline))])
    high = moved(low, 0, 0, height)
    ends = [(low[c], low[b], low[a]) for a, b, c in fan]
    ends += [(high[a], high[b], high[c]) for a, b, c in fan]
    for i in range(len(outline)):
        j = (i + 1) % len(outline)
        ends += [(low[i], low[j], high[j]), (low[i], high[j], high[i])]
    return np.array(ends)


def l_bracket() -> Corners:
    """0.4 × 0.3 × 0.2 m, 0.06 m thick."""
    return extruded(L_OUTLINE, 0.2, ((0, 1, 2), (0, 2, 3), (0, 3, 5), (3, 4, 5)))


def c_bracket() -> Corners:
    """0.5 × 0.5 × 0.25 m, 0.08 m thick, open towards +x."""
    fan = ((0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 7), (4, 5, 6), (4, 6, 7))
    return extruded(C_OUTLINE, 0.25, fan)


def torus(rings: int = 48, sides: int = 24, radius: float = 0.5, thick: float = 0.12) -> Corners:
    a = np.arange(rings) * (2 * np.pi / rings)
    b = np.arange(sides) * (2 * np.pi / sides)
    out = radius + thick * np.cos(b)
    grid = np.stack(
        [
            np.cos(a)[:, None] * out,
            np.sin(a)[:, None] * out,
            np.broadcast_to(thick * np.sin(b), (rings, sides)),
        ],
        axis=-1,
    )
    return _quads(grid, np.roll(grid, -1, 0), np.roll(grid, (-1, -1), (0, 1)), np.roll(grid, -1, 1))


def tube(sides: int = 32, outer: float = 0.3, inner: float = 0.25, length: float = 1.0) -> Corners:
    """A hollow tube along z."""
    a = np.arange(sides) * (2 * np.pi / sides)
    ring = np.stack([np.cos(a), np.sin(a), np.zeros(sides)], axis=-1)
    up = np.array([0, 0, length])
    around = [outer * ring, outer * ring + up, inner * ring + up, inner * ring]
    grid = np.stack(around, axis=1)
    return _quads(grid, np.roll(grid, -1, 0), np.roll(grid, (-1, -1), (0, 1)), np.roll(grid, -1, 1))


def _quads(a: Array, b: Array, c: Array, d: Array) -> Corners:
    both = [np.stack([a, b, c], axis=-2), np.stack([a, c, d], axis=-2)]
    return np.concatenate([t.reshape(-1, 3, 3) for t in both])


def wire(nodes: Array, struts: Sequence[tuple[int, int]], radius: float, sides: int = 8) -> Corners:
    """Round struts between nodes; at each node, the hull of the ends that meet there, or a tip."""
    triangles: list[Array] = []
    ends: dict[int, list[Array]] = {i: [] for i in range(len(nodes))}
    angle = (np.arange(sides) + 0.5) * (2 * np.pi / sides)
    for i, j in struts:
        along = (nodes[j] - nodes[i]) / np.linalg.norm(nodes[j] - nodes[i])
        across = np.cross(along, [0.3, 0.5, 0.8])
        across /= np.linalg.norm(across)
        ring = radius * (
            np.cos(angle)[:, None] * across + np.sin(angle)[:, None] * np.cross(along, across)
        )
        first, last = nodes[i] + 2.5 * radius * along, nodes[j] - 2.5 * radius * along
        a, b = first + ring, last + ring
        ends[i].append(a)
        ends[j].append(b)
        triangles.append(_quads(a, np.roll(a, -1, 0), np.roll(b, -1, 0), b))
    for node, rings in ends.items():
        if len(rings) == 1:  # a loose end: the node is its tip
            rings = [rings[0], nodes[node][None]]
        points, owner = np.concatenate(rings), np.repeat(range(len(rings)), [len(r) for r in rings])
        hull = ConvexHull(points)
        for corners, normal in zip(hull.simplices, hull.equations[:, :3], strict=True):
            if len(set(owner[corners])) > 1:
                a, b, c = points[corners]
                turned = np.cross(b - a, c - a) @ normal < 0
                triangles.append(np.array([[a, c, b] if turned else [a, b, c]]))
    return np.concatenate(triangles)


def truss(radius: float = 0.02) -> Corners:
    """Two bays of 0.6 × 0.6 × 0.8 m: 20 struts."""
    nodes = np.array([(x, y, z) for z in (0, 0.8, 1.6) for y in (0, 0.6) for x in (0, 0.6)])
    struts = [
        (i, j)
        for i, j in combinations(range(len(nodes)), 2)
        if np.count_nonzero(nodes[i] - nodes[j]) == 1 and np.linalg.norm(nodes[i] - nodes[j]) < 1
    ]
    assert len(struts) == 20
    return wire(nodes, struts, radius)


def solid(corners: Corners, name: str = "solid") -> Solid:
    return sound(Surface.joined(name, "0" * 64, corners))


def write_stl(path: Path, corners: Corners) -> Path:
    """A binary STL."""
    record = np.zeros(
        len(corners), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")]
    )
    record["corners"] = corners
    header = b"made by hand".ljust(80) + np.uint32(len(corners)).tobytes()
    path.write_bytes(header + record.tobytes())
    return path


def write_obj(path: Path, corners: Corners) -> Path:
    """A Wavefront file, 17 digits."""
    vertices = "".join("v {!r} {!r} {!r}\n".format(*p) for p in corners.reshape(-1, 3).tolist())
    faces = "".join(f"f {3 * i + 1} {3 * i + 2} {3 * i + 3}\n" for i in range(len(corners)))
    path.write_text(vertices + faces, encoding="ascii")
    return path


def samples(corners: Corners, count: int, seed: int = 0) -> Array:
    """Random points (count, 3), evenly over the surface."""
    draw = np.random.default_rng(seed)
    a, b, c = np.moveaxis(corners, 1, 0)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    chosen = draw.choice(len(corners), size=count, p=areas / areas.sum())
    s, t = np.sqrt(draw.random(count)), draw.random(count)
    weights = np.stack([1 - s, s * (1 - t), s * t], axis=1)
    return np.einsum("ij,ijk->ik", weights, corners[chosen])
