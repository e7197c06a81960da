"""Which parts of a structure a guess has to go around: those near the way, and what hangs on them.

A guess goes around a truss as a whole, for its struts leave no way through; but it does not go
around a field of things that are far from each other and from the way.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from berthing.geometry.arrays import Array
from berthing.geometry.body import Body, Part
from berthing.geometry.pose import Pose


def in_the_way(
    body: Body, pose: Pose, ends: tuple[Array, Array], within_m: float, gap_m: float
) -> Body | None:
    """The bounded parts of a placed body with balls within ``within_m`` of the straight line
    between two points (d,), and those joined to them by gaps of up to ``gap_m`` between balls.

    None where there are none.
    """
    parts = [part for part in body.parts if np.isfinite(part.bounding_radius)]
    if not parts:
        return None
    centres = pose.apply(np.array([part.placement.position for part in parts]))
    radii = np.array([part.shape.bounding_radius for part in parts])
    near = _off_line(centres, *ends) - radii <= within_m
    if not near.any():
        return None
    kept = near if near.all() else _joined(centres, radii, near, gap_m)
    return _of([part for part, keep in zip(parts, kept, strict=True) if keep], body)


def _off_line(points: Array, first: Array, last: Array) -> Array:
    """Distances (k,) of points (k, d) from the segment between two others."""
    along = last - first
    share = np.clip((points - first) @ along / max(float(along @ along), 1e-300), 0.0, 1.0)
    return np.asarray(np.linalg.norm(points - first - share[:, None] * along, axis=1))


def _joined(centres: Array, radii: Array, near: Array, gap_m: float) -> Array:
    """Whether each ball is near or joined to one that is, one after the other."""
    reach = 2.0 * float(np.max(radii)) + gap_m
    i, j = cKDTree(centres).query_pairs(reach, output_type="ndarray").T
    touch = np.linalg.norm(centres[i] - centres[j], axis=1) <= radii[i] + radii[j] + gap_m
    shape = len(radii), len(radii)
    links = coo_matrix((np.ones(int(touch.sum())), (i[touch], j[touch])), shape)
    groups = connected_components(links, directed=False)[1]
    return np.asarray(np.isin(groups, groups[near]))


def _of(parts: list[Part], body: Body) -> Body:
    return body if len(parts) == len(body.parts) else Body(tuple(parts))
