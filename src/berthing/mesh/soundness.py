"""Whether a surface encloses a solid, and advice where it does not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.mesh.crossing import first_crossing
from berthing.mesh.solid import Solid, Surface
from berthing.mesh.winding import winding_number

Edges = npt.NDArray[np.int64]

# CoACD's time grows with the triangles: 48,000 take minutes, a million the better part of a day.
MOST_TRIANGLES = 100_000
# Of size³. A closed surface that encloses less is a sheet; 1 m × 1 m × 1e-9 m would pass.
SMALLEST_VOLUME = 1e-10
# Of the size: how far behind a triangle its inside is looked for.
BEHIND = 1e-6


def sound(surface: Surface) -> Solid:
    """The surface as a solid.

    Raises:
        InputError: too many triangles, a hole, faces turned over, no volume, all faces inward, or
            a surface that crosses itself; with the place and what to do.
    """
    for check in _CHECKS:
        check(surface)
    return Solid(surface.name, surface.sha256, surface.vertices, surface.triangles)


def _check_count(surface: Surface) -> None:
    count = len(surface.triangles)
    if count == 0:
        raise InputError(surface.name, "has no triangles", "a closed surface of triangles")
    if count > MOST_TRIANGLES:
        raise InputError(
            surface.name,
            f"has {count:,} triangles, more than can be decomposed in a reasonable time",
            f"at most {MOST_TRIANGLES:,}; export it from CAD with a coarser chord tolerance, or "
            "reduce it (MeshLab: Quadric Edge Collapse Decimation with Preserve Topology; "
            "Blender: Decimate), and add to the margin what that moves the surface",
        )


def _check_closed(surface: Surface) -> None:
    edges, rising, falling = _edges(surface)
    alone = rising + falling == 1
    if not np.any(alone):
        return
    ends = edges[alone]
    joint = coo_array(
        (np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(len(surface.vertices),) * 2
    )
    label = connected_components(joint, directed=False)[1]
    holes = len(np.unique(label[ends[:, 0]]))
    rim = surface.vertices[ends]
    length = float(np.sum(np.linalg.norm(rim[:, 1] - rim[:, 0], axis=1)))
    what = (
        f"is not closed: {len(ends)} edges have a triangle on one side only, around "
        f"{holes} {'hole' if holes == 1 else 'holes'} with rims of {length:.4g} m in all, the "
        f"first at {_place(rim[0].mean(axis=0))}"
    )
    expected = (
        "a watertight surface; export a solid rather than faces, or close it (MeshLab: Merge "
        "Close Vertices, then Close Holes; Blender: 3D Print Toolbox, Make Manifold)"
    )
    raise InputError(surface.name, what, expected)


def _check_turned(surface: Surface) -> None:
    edges, rising, falling = _edges(surface)
    wrong = rising != falling
    if not np.any(wrong):
        return
    at = surface.vertices[edges[wrong][0]].mean(axis=0)
    what = (
        f"has faces turned over: along {int(np.sum(wrong))} edges the triangles on either side "
        f"do not agree which side is out, the first at {_place(at)}"
    )
    expected = (
        "corners counter-clockwise seen from outside everywhere (MeshLab: Re-Orient All Faces "
        "Coherently; Blender: Recalculate Normals)"
    )
    raise InputError(surface.name, what, expected)


def _check_volume(surface: Surface) -> None:
    volume, size = surface.volume, surface.size
    if abs(volume) <= SMALLEST_VOLUME * size**3:
        what = f"encloses no volume: {volume:.3g} m³ at a size of {size:.4g} m"
        raise InputError(surface.name, what, "a solid; give a sheet its thickness")
    if volume < 0.0:
        what = f"is inside out: all its faces point inward, its volume is {volume:.4g} m³"
        raise InputError(surface.name, what, "outward faces (MeshLab: Invert Faces Orientation)")


def _check_crossing(surface: Surface) -> None:
    found = first_crossing(surface)
    if found is None:
        return
    count, at = found
    what = f"crosses itself: {count} pairs of triangles, the first at {_place(at)}"
    expected = (
        "one skin; unite overlapping solids in CAD (a boolean union), or name each in a part of "
        "its own"
    )
    raise InputError(surface.name, what, expected)


def _check_nesting(surface: Surface) -> None:
    """Just behind a triangle of each connected skin, the surface must go around once.

    Where it does so twice, the skin lies in another solid; where not at all, it faces inward.
    """
    t = surface.triangles
    joint = coo_array(
        (np.ones(2 * len(t)), (t[:, [0, 1]].ravel(), t[:, [1, 2]].ravel())),
        shape=(len(surface.vertices),) * 2,
    )
    count, label = connected_components(joint, directed=False)
    if count == 1:
        return
    # The largest triangle of each skin, which is the last one written.
    largest = np.zeros(count, dtype=np.int64)
    by_area = np.argsort(surface.areas, kind="stable")
    largest[label[t[by_area, 0]]] = by_area
    a, b, c = np.moveaxis(surface.corners[largest], 1, 0)
    normal = np.cross(b - a, c - a)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    behind = (a + b + c) / 3.0 - BEHIND * surface.size * normal
    around = np.round(winding_number(surface, behind))
    for i in np.flatnonzero(around != 1.0):
        how = "faces inward" if around[i] < 1.0 else "lies inside another solid of the file"
        what = f"has {count} separate skins, one of which {how}, at {_place(behind[i])}"
        raise InputError(surface.name, what, "solids side by side, and hollows that face inward")


_CHECKS: tuple[Callable[[Surface], None], ...] = (
    _check_count,
    _check_closed,
    _check_turned,
    _check_volume,
    _check_crossing,
    _check_nesting,
)


def _edges(surface: Surface) -> tuple[Edges, Edges, Edges]:
    """Edges (e, 2), lower index first, and how many triangles go along each up and down.

    A closed oriented surface goes as often up as down: then its boundary as a chain is zero, and
    winding number and volume are well defined, also where four triangles meet in an edge.
    """
    t = surface.triangles
    every = np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])
    up = every[:, 0] < every[:, 1]
    edges, where = np.unique(np.sort(every, axis=1), axis=0, return_inverse=True)
    where = where.reshape(-1)
    count = len(edges)
    rising = np.bincount(where[up], minlength=count)
    return edges, rising, np.bincount(where[~up], minlength=count)


def _place(point: Array) -> str:
    return "({}) m".format(", ".join(f"{x:.4g}" for x in point))
