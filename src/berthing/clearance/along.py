"""Distances of two parts along a motion of their bodies, asked exactly only where they are near."""

from __future__ import annotations

import numpy as np

from berthing.clearance.compiled_distance import compiled_distance, takes
from berthing.clearance.separation import PairQuery
from berthing.geometry.arrays import Array
from berthing.geometry.body import Part
from berthing.geometry.pose import Pose


def distances_along(a: Part, body_a: Pose, b: Part, body_b: Pose, near_m: float) -> Array:
    """Distances (k,) in metres, the frames of the bodies being at the poses (k,).

    Where the bounding balls are ``near_m`` or more apart, their gap, a lower bound, stands in.
    """
    centre_a, centre_b = (
        body.apply(part.placement.position) for body, part in ((body_a, a), (body_b, b))
    )
    apart = np.linalg.norm(centre_b - centre_a, axis=-1)
    distances = apart - a.shape.bounding_radius - b.shape.bounding_radius
    near = np.flatnonzero(distances < near_m)
    if len(near):
        placed_a, placed_b = (
            body[near].compose(part.placement) for body, part in ((body_a, a), (body_b, b))
        )
        if takes(a.shape, b.shape):
            found = compiled_distance(a.shape, placed_a, b.shape, placed_b).distance
        else:
            found = PairQuery(a.shape, b.shape).batch(placed_a, placed_b)[0]
        distances[near] = found
    return np.asarray(distances)
