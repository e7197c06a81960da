"""Bodies as the page draws them: one mesh each, and the edges that are seen."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from berthing.geometry.body import Body
from berthing.geometry.capability import mesh
from berthing.geometry.mesh import Mesh
from berthing.report.offline.coarse import coarsened
from berthing.report.offline.packing import Packing
from berthing.report.space import in_space
from berthing.report.surface import Surface


def packed_body(body: Body, packing: Packing) -> dict[str, Any]:
    """All parts of a body as one mesh in the body's frame.

    ``v`` are vertices (k, 3) in metres, ``i`` triangles (m, 3), counter-clockwise seen from
    outside, ``e`` edges to draw (n, 2): creases, and rims of flat shapes; ``off`` is by how many
    metres at most the drawn surface lies inside the true one, beyond what its facets of a smooth
    shape do.
    """
    whole = [mesh(part.shape) for part in body.parts]
    meshes, off = coarsened(whole)
    starts = np.cumsum([0, *(len(found.vertices) for found in meshes)])[:-1]
    placed = [
        in_space(part.placement).apply(found.vertices)
        for part, found in zip(body.parts, meshes, strict=True)
    ]
    surfaces = [Surface.of(found) for found in meshes]
    triangles = [s.triangles + start for s, start in zip(surfaces, starts, strict=True)]
    edges = [
        _creases(surface, original) + start
        for surface, original, start in zip(surfaces, whole, starts, strict=True)
    ]
    return {
        "v": packing.floats(np.concatenate(placed)),
        "i": packing.indices(np.concatenate(triangles)),
        "e": packing.indices(np.concatenate(edges)),
        "off": off,
    }


def _creases(surface: Surface, original: Mesh) -> npt.NDArray[np.int64]:
    """Edges to draw; of a smooth shape none, however coarsely it is drawn."""
    simplified = len(surface.triangles) < len(original.triangles)
    if simplified and not Surface.of(original).sharp.any():
        return np.empty((0, 2), dtype=np.int64)
    return surface.edges[surface.sharp]
