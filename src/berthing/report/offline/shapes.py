"""Bodies as the page draws them: one mesh each, and the edges that are seen."""

from __future__ import annotations

from typing import Any

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.body import Body, Part
from berthing.geometry.capability import mesh
from berthing.report.offline.packing import Packing
from berthing.report.space import in_space
from berthing.report.surface import Surface


def packed_body(body: Body, packing: Packing) -> dict[str, Any]:
    """All parts of a body as one mesh in the body's frame.

    ``v`` are vertices (k, 3) in metres, ``i`` triangles (m, 3), counter-clockwise seen from
    outside, and ``e`` edges to draw (n, 2): creases, and rims of flat shapes.
    """
    placed = [_placed(part) for part in body.parts]
    starts = np.cumsum([0, *(len(points) for points, _ in placed)])[:-1]
    surfaces = [
        (surface.triangles + start, surface.edges[surface.sharp] + start)
        for (_, surface), start in zip(placed, starts, strict=True)
    ]
    triangles, edges = (np.concatenate(rows) for rows in zip(*surfaces, strict=True))
    return {
        "v": packing.floats(np.concatenate([points for points, _ in placed])),
        "i": packing.indices(triangles),
        "e": packing.indices(edges),
    }


def _placed(part: Part) -> tuple[Array, Surface]:
    surface = Surface.of(mesh(part.shape))
    return in_space(part.placement).apply(surface.vertices), surface
