"""Distances are symmetric, the same in every frame, and lie between two proofs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import fields

import numpy as np
import pytest

from berthing.clearance.plane import plane_bound
from berthing.clearance.separation import PairQuery, Separation
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capability import level
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from support.shapes import size

Poses = Callable[[int, int, float], Pose]
Pair = tuple[ConvexSet, ConvexSet]
SPREAD_M = 3.0
# Of the distance of sets apart, in terms of the sizes: coal enlarges its boxes by 1e-10.
APART = 1e-8
# Of the level at witnesses; coal's are less exact than its distances, and the level of a thin
# ellipsoid is steep.
WITNESS = 5e-7
# Of the vector between witnesses: its length is as exact as the distance, and so flat a minimum
# that its direction is not.
ACROSS = 3e-6
# Between two evaluations of one plane bound in different frames: that of solved support values.
PROOF = 1e-9
# Of the depth of overlapping sets: the tolerance of coal's EPA.
DEEP = 2e-6


def tolerance(pair: Pair, distance: Array) -> Array:
    within = max(size(pair[0]) + size(pair[1]), 1.0)
    return np.where(distance > 0.0, APART, DEEP) * within


def check_between_proofs(
    pair: Pair, pose_a: Pose, pose_b: Pose, all_found: Sequence[Separation]
) -> None:
    """Of one answer a pose."""
    a, b = pair
    distance, normal, point_a, point_b, bound = (
        np.array([getattr(one, field.name) for one in all_found]) for field in fields(Separation)
    )
    within = tolerance(pair, distance)
    np.testing.assert_allclose(np.linalg.norm(normal, axis=-1), 1.0, atol=1e-12)
    np.testing.assert_allclose(bound, plane_bound(a, pose_a, b, pose_b, normal), atol=PROOF)
    assert np.all(bound <= distance)
    assert np.all(distance <= bound + within)
    # The points are members of their sets, so the sets are no farther apart than they.
    beyond = WITNESS * (size(a) + size(b) + 1.0)
    assert np.all(level(a, pose_a.inverse().apply(point_a)) <= beyond)
    assert np.all(level(b, pose_b.inverse().apply(point_b)) <= beyond)
    aside = np.maximum(within, ACROSS * (size(a) + size(b)))
    across = point_b - point_a - distance[:, None] * normal
    assert np.all(np.abs(across) <= aside[:, None])


def test_is_symmetric(pair: Pair, poses: Poses, count: int) -> None:
    at_a, at_b = poses(count, pair[0].dim, SPREAD_M), poses(count, pair[0].dim, SPREAD_M)
    there = PairQuery(*pair).batch(at_a, at_b)[0]
    back = PairQuery(*pair[::-1]).batch(at_b, at_a)[0]
    assert np.all(np.abs(there - back) <= tolerance(pair, there))


def test_is_the_same_in_every_frame(pair: Pair, poses: Poses, count: int) -> None:
    dim = pair[0].dim
    at_a, at_b, moved = (poses(count, dim, spread) for spread in (SPREAD_M, SPREAD_M, 50.0))
    query = PairQuery(*pair)
    here = query.batch(at_a, at_b)[0]
    there = query.batch(moved.compose(at_a), moved.compose(at_b))[0]
    assert np.all(np.abs(there - here) <= tolerance(pair, here))


def test_lies_between_plane_and_witnesses(pair: Pair, poses: Poses, count: int) -> None:
    at_a, at_b = poses(count, pair[0].dim, SPREAD_M), poses(count, pair[0].dim, SPREAD_M)
    query = PairQuery(*pair)
    found = [query.query(at_a[i], at_b[i]) for i in range(count)]
    check_between_proofs(pair, at_a, at_b, found)


def test_batch_and_query_agree(pair: Pair, poses: Poses, count: int) -> None:
    at_a, at_b = poses(count, pair[0].dim, SPREAD_M), poses(count, pair[0].dim, SPREAD_M)
    query = PairQuery(*pair)
    distance, normal, bound = query.batch(at_a, at_b)
    for i in range(count):
        one = query.query(at_a[i], at_b[i])
        assert one.distance == pytest.approx(distance[i], abs=float(tolerance(pair, distance[i])))
        np.testing.assert_allclose(
            plane_bound(pair[0], at_a[i], pair[1], at_b[i], normal[i]), bound[i], atol=PROOF
        )


def test_moving_closer_by_a_step_costs_at_most_the_step(
    pair: Pair, poses: Poses, count: int
) -> None:
    dim = pair[0].dim
    at_a, at_b = poses(count, dim, SPREAD_M), poses(count, dim, SPREAD_M)
    step = 0.1
    query = PairQuery(*pair)
    before, normal, _ = query.batch(at_a, at_b)
    after = query.batch(at_a, Pose(at_b.position - step * normal, at_b.rotation))[0]
    assert np.all(after >= before - step - tolerance(pair, after))


def test_the_check_notices_a_wrong_answer() -> None:
    pair = (Box([1.0, 1.0, 1.0]), Box([1.0, 1.0, 1.0]))
    here, there = Pose.identity(), Pose(np.array([3.0, 0.0, 0.0]), np.eye(3))
    good = PairQuery(*pair).query(here, there)
    check_between_proofs(pair, here, there, [good])
    tilted = np.array([np.cos(0.01), np.sin(0.01), 0.0])
    aside = np.array([0.0, 0.1, 0.0])
    wrong = [
        Separation(1.01, good.normal, good.point_a, good.point_b, good.lower_bound),
        Separation(0.99, good.normal, good.point_a, good.point_b, good.lower_bound),
        Separation(1.0, tilted, good.point_a, good.point_b, good.lower_bound),
        Separation(1.0, good.normal, good.point_a, good.point_b + aside, 1.0),
        Separation(1.0, good.normal, good.point_a - [0.1, 0.0, 0.0], good.point_b, 1.0),
    ]
    for answer in wrong:
        with pytest.raises(AssertionError):
            check_between_proofs(pair, here, there, [answer])
