"""Signed distances by the compiled kernel, a batch of poses at a time."""

from __future__ import annotations

import numpy as np

from berthing.clearance.kernel import BY_A, BY_B, DISTANCE, WIDTH, kernel
from berthing.clearance.queried_distance import queried_distance
from berthing.clearance.set_numbers import CONIC, set_numbers
from berthing.clearance.signed_distance import SignedDistance
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose

# Answers closer than this to each other, as a fraction of the sizes, end a search. Rounding allows
# about 1e-15.
TOLERANCE = 1e-10
# The same where sets overlap: every other direction is shown to be no better than by this much, or
# by so many metres where that is less, but never less than the third. The normal itself is as exact
# as that of sets apart.
DEPTH_TOLERANCE = 2e-6
DEPTH_TOLERANCE_M = 4e-6
LEAST_DEPTH_TOLERANCE = 5e-7
# The first, for sets whose support points an interior-point method finds, to some 1e-11.
CONIC_TOLERANCE = 1e-9
# Bounds of sets apart that stay further from each other than so many tolerances are improved on by
# slower methods; none of 300,000 random pairs of all shapes was.
WIDE = 5.0


def takes(a: ConvexSet, b: ConvexSet) -> bool:
    """Whether the kernel is there and knows both sets."""
    return set_numbers(a) is not None and set_numbers(b) is not None and kernel() is not None


def compiled_distance(a: ConvexSet, poses_a: Pose, b: ConvexSet, poses_b: Pose) -> SignedDistance:
    """At poses of batch shapes () or (...), taken in order as a path; both sets are known.

    Each search starts where that of the pose before ended. What it ends at does not depend on the
    start, but for rounding and where several answers are equally good.
    """
    compute, numbers_a, numbers_b = kernel(), set_numbers(a), set_numbers(b)
    assert compute is not None
    assert numbers_a is not None
    assert numbers_b is not None
    batch = np.broadcast_shapes(poses_a.batch_shape, poses_b.batch_shape)
    count, size = int(np.prod(batch)), _size(numbers_a) + _size(numbers_b)
    solved = CONIC in (numbers_a[0], numbers_b[0])
    tolerance = (CONIC_TOLERANCE if solved else TOLERANCE) * size
    rows = np.empty((count, WIDTH))
    turn_a, place_a, step_a = _flat(poses_a, batch)
    turn_b, place_b, step_b = _flat(poses_b, batch)
    done = compute(
        numbers_a.ctypes.data, numbers_b.ctypes.data, a.dim, count,
        turn_a.ctypes.data, place_a.ctypes.data, step_a,
        turn_b.ctypes.data, place_b.ctypes.data, step_b,
        tolerance, _depth_tolerance(size), rows.ctypes.data,
    )  # fmt: skip
    if done < 0:
        raise MemoryError("no memory for the distance search")
    answers = _answers(rows.reshape(*batch, WIDTH), a.dim)
    if done == 0:
        return answers
    return _second_opinions(answers, WIDE * tolerance, a, poses_a, b, poses_b)


def _second_opinions(
    answers: SignedDistance,
    open_by: float,
    a: ConvexSet,
    poses_a: Pose,
    b: ConvexSet,
    poses_b: Pose,
) -> SignedDistance:
    """Where bounds of sets apart are further apart than that, the other methods are heard too."""
    wide = (answers.distance > 0.0) & (answers.upper_bound - answers.lower_bound > open_by)
    if not np.any(wide):
        return answers
    spread_a, spread_b = _spread(poses_a, wide.shape), _spread(poses_b, wide.shape)
    other = queried_distance(a, spread_a[wide], b, spread_b[wide])
    return answers.improved(wide, other)


def _spread(poses: Pose, batch: tuple[int, ...]) -> Pose:
    d = poses.dim
    positions = np.broadcast_to(poses.position, (*batch, d))
    return Pose(positions, np.broadcast_to(poses.rotation, (*batch, d, d)))


def _size(numbers: Array) -> float:
    """Of a set with its pad, as native/shape.h has it."""
    return float(2.0 * numbers[1] + numbers[2])


def _depth_tolerance(size: float) -> float:
    return max(LEAST_DEPTH_TOLERANCE * size, min(DEPTH_TOLERANCE * size, DEPTH_TOLERANCE_M))


def _flat(poses: Pose, batch: tuple[int, ...]) -> tuple[Array, Array, int]:
    """Rotations (k, 3, 3) and positions (k, 3) in space, and 1; or (1, …) and 0 for one pose."""
    single = not poses.batch_shape
    shape = () if single else batch
    d = poses.dim
    turns = np.broadcast_to(poses.rotation, (*shape, d, d)).reshape(-1, d, d)
    places = np.broadcast_to(poses.position, (*shape, d)).reshape(-1, d)
    if d == 2:
        solid_turns, solid_places = np.zeros((len(places), 3, 3)), np.zeros((len(places), 3))
        solid_turns[:, :2, :2], solid_turns[:, 2, 2], solid_places[:, :2] = turns, 1.0, places
        turns, places = solid_turns, solid_places
    return np.ascontiguousarray(turns), np.ascontiguousarray(places), 0 if single else 1


def _answers(rows: Array, dim: int) -> SignedDistance:
    """Views of the kernel's columns."""
    axes = slice(0, dim)
    turns = slice(5, 6) if dim == 2 else slice(3, 6)

    def gradient(pose: slice) -> Array:
        columns = rows[..., pose]
        if dim == 3:
            return columns
        return np.concatenate([columns[..., axes], columns[..., turns]], axis=-1)

    return SignedDistance(
        distance=rows[..., DISTANCE],
        normal=rows[..., 3:6][..., axes],
        point_a=rows[..., 6:9][..., axes],
        point_b=rows[..., 9:12][..., axes],
        lower_bound=rows[..., 0],
        upper_bound=rows[..., 1],
        gradient_a=gradient(BY_A),
        gradient_b=gradient(BY_B),
    )
