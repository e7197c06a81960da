import numpy as np
import pytest

import berthing as bt
from berthing.geometry.half_space import HalfSpace
from berthing.routes import pair_query
from berthing.routes.pair_query import BY_A, BY_B, DISTANCE, FramesQuery

AGREES = 1e-4
"""Two methods, one distance and its gradient, of sets that are apart. The compiled search ends at
1e-9 m here, which leaves the square root of that in the normal of sets of some decimetres."""


def frames(rng, count, dim):
    turn, place = np.tile(np.eye(3), (count, 1, 1)), np.zeros((count, 3))
    if dim == 2:
        angle = rng.uniform(-3.0, 3.0, count)
        turn[:, 0, 0] = turn[:, 1, 1] = np.cos(angle)
        turn[:, 1, 0], turn[:, 0, 1] = np.sin(angle), -np.sin(angle)
    else:
        turn = bt.Pose.from_quaternion(place, rng.normal(size=(count, 4))).rotation.copy()
    place[:, :dim] = rng.uniform(-1.0, 1.0, (count, dim))
    return turn, place


@pytest.mark.parametrize(
    ("a", "b", "dim"),
    [
        (bt.Box(np.array([0.5, 0.2, 0.3])), bt.Cylinder(0.3, 0.6), 3),
        (bt.Box(np.array([0.5, 0.2])), bt.Ellipsoid(np.array([0.4, 0.2])), 2),
        (bt.Sphere(0.3), HalfSpace(np.array([0.0, 0.0, 1.0]), -9.0), 3),
    ],
)
def test_without_a_compiler_answers_are_the_same(monkeypatch, a, b, dim):
    rng = np.random.default_rng(2)
    count = 8
    own, other = frames(rng, count, dim), frames(rng, count, dim)
    own[1][:, 0] += 5.0
    quick = FramesQuery(a, b)(*own, *other)
    monkeypatch.setattr(pair_query, "kernel", lambda: None)
    query = FramesQuery(a, b)
    slow = query(*own, *other)
    for columns in (DISTANCE, BY_A, BY_B):
        assert np.allclose(slow[:, columns], quick[:, columns], atol=AGREES)
    still = query(*own, other[0][:1], other[1][:1])
    assert np.array_equal(still[0], slow[0])
    assert not np.allclose(still[1], slow[1])


def test_frames_may_stand_still_or_lie_apart_in_memory():
    rng = np.random.default_rng(3)
    query = FramesQuery(bt.Sphere(0.3), bt.Box(np.array([0.5, 0.2, 0.3])))
    turn, place = frames(rng, 12, 3)
    still = turn[:1], place[:1] + 4.0
    whole = query(turn, place, *still)[:, DISTANCE]
    assert np.allclose(query(turn[::3], place[::3], *still)[:, DISTANCE], whole[::3])
    wide = np.zeros((12, 5))
    wide[:, 1:4] = place
    assert np.allclose(query(turn, wide[:, 1:4], *still)[:, DISTANCE], whole)
