"""Clearance of two bodies: the closest pair of their parts."""

from __future__ import annotations

from itertools import product

from berthing.clearance.separation import Separation, separation
from berthing.errors import InputError
from berthing.geometry.body import Body, Part
from berthing.geometry.convex_set import norm
from berthing.geometry.pose import Pose


def clearance(
    body_a: Body, pose_a: Pose, body_b: Body, pose_b: Pose
) -> tuple[Separation, Part, Part]:
    """The smallest signed distance over all pairs of parts, and the pair it belongs to.

    Pairs are asked in the order of their bounding spheres' distance, until the spheres alone
    show that no pair left can be closer.

    Args:
        body_a, body_b: bodies of the same dimension.
        pose_a, pose_b: single poses of the bodies' frames in the world.

    Raises:
        InputError: dimensions that do not fit, or a batch of poses.
        CapabilityError: a part without a distance query.
    """
    if pose_a.batch_shape or pose_b.batch_shape:
        raise InputError("clearance", "was given a batch of poses", "single poses")
    placed_a = [(part, pose_a.compose(part.placement)) for part in body_a.parts]
    placed_b = [(part, pose_b.compose(part.placement)) for part in body_b.parts]
    if body_a.dim != body_b.dim:
        raise InputError("clearance", f"of {body_a.dim} and {body_b.dim} dimensions", "the same")
    pairs = sorted(
        ((_sphere_gap(*a, *b), a, b) for a, b in product(placed_a, placed_b)),
        key=lambda pair: pair[0],
    )
    best: tuple[Separation, Part, Part] | None = None
    for gap, (part_a, at_a), (part_b, at_b) in pairs:
        if best is not None and gap >= best[0].distance:
            break
        found = separation(part_a.shape, at_a, part_b.shape, at_b)
        if best is None or found.distance < best[0].distance:
            best = (found, part_a, part_b)
    if best is None:
        raise InputError("clearance", "was given a body without parts")
    return best


def _sphere_gap(part_a: Part, at_a: Pose, part_b: Part, at_b: Pose) -> float:
    """A lower bound on the distance of two placed parts."""
    centres = float(norm(at_b.position - at_a.position))
    return centres - part_a.shape.bounding_radius - part_b.shape.bounding_radius
