"""One query or many, in any order, give the same; what fails in coal is caught."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from berthing.clearance import coal_pair as module
from berthing.clearance.coal_pair import CoalPair
from berthing.clearance.separation import PairQuery, separation
from berthing.errors import CapabilityError, InputError
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere

CUBE, ROD, EGG = Box([1.0, 1.0, 1.0]), Cylinder(0.5, 2.0), Ellipsoid([1.0, 2.0, 0.5])


def scattered(count: int, spread: float, seed: int = 0) -> Pose:
    rng = np.random.default_rng(seed)
    return Pose.from_quaternion(spread * rng.normal(size=(count, 3)), rng.normal(size=(count, 4)))


@pytest.mark.parametrize("spread", [0.5, 5.0])
def test_answers_do_not_depend_on_earlier_queries(spread: float) -> None:
    query, poses = PairQuery(EGG, ROD), scattered(50, spread)
    forward = query.batch(poses, Pose.identity())
    backward = query.batch(poses[::-1], Pose.identity())
    for there, back in zip(forward, backward, strict=True):
        np.testing.assert_array_equal(there, back[::-1])
    alone = PairQuery(EGG, ROD).query(poses[7], Pose.identity())
    assert alone.distance == pytest.approx(forward[0][7], abs=1e-12)


def test_a_single_pose_serves_a_batch_on_either_side() -> None:
    query, poses = PairQuery(CUBE, ROD), scattered(9, 4.0)
    first = query.batch(poses, Pose.identity())
    second = query.batch(poses, Pose.identity()[None])
    np.testing.assert_array_equal(first[0], second[0])
    assert first[1].shape == (9, 3)
    back = PairQuery(ROD, CUBE).batch(Pose.identity(), poses)
    np.testing.assert_allclose(back[0], first[0], atol=1e-8)
    np.testing.assert_allclose(back[1], -first[1], atol=1e-3)


def test_an_empty_batch_is_answered() -> None:
    distance, normal, bound = PairQuery(CUBE, ROD).batch(scattered(3, 1.0)[:0], Pose.identity())
    assert distance.shape == bound.shape == (0,)
    assert normal.shape == (0, 3)


def test_separation_is_a_query() -> None:
    pose = scattered(1, 5.0)[0]
    one, other = separation(CUBE, Pose.identity(), EGG, pose), PairQuery(CUBE, EGG)
    assert one.distance == other.query(Pose.identity(), pose).distance


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e3])
def test_size_does_not_matter(scale: float) -> None:
    poses = scattered(40, 1.5)
    small = PairQuery(EGG, ROD).batch(poses, Pose.identity())[0]
    egg, rod = Ellipsoid(scale * EGG.semi_axes), Cylinder(0.5 * scale, 2.0 * scale)
    moved = Pose(scale * poses.position, poses.rotation)
    large = PairQuery(egg, rod).batch(moved, Pose.identity())[0]
    np.testing.assert_allclose(large, scale * small, atol=5e-6 * scale)


def closed_form(x: Array, rod: Cylinder) -> Array:
    """Signed distance of points x (k, 3) to a cylinder along x."""
    along = np.abs(x[:, 0]) - rod.half_length
    across = np.hypot(x[:, 1], x[:, 2]) - rod.radius
    outside = np.hypot(np.maximum(along, 0.0), np.maximum(across, 0.0))
    return np.where(np.maximum(along, across) < 0.0, np.maximum(along, across), outside)


@pytest.mark.parametrize("radius", [0.0, 0.2])
def test_ball_and_cylinder_agree_with_the_closed_form(radius: float) -> None:
    """coal's own routine for the two errs in depth; see coal_shapes."""
    rng = np.random.default_rng(4)
    x = rng.uniform(-1, 1, size=(400, 3)) * [2.5, 0.8, 0.8]
    distance = PairQuery(Sphere(radius), ROD).batch(Pose(x, np.eye(3)), Pose.identity())[0]
    np.testing.assert_allclose(distance, closed_form(x, ROD) - radius, atol=5e-6)


class _Sabotaged:
    """coal's functor, with answers made to fail."""

    def __init__(self, inner: Any, spoil: Any) -> None:
        self.inner, self.spoil = inner, spoil

    def __call__(self, *arguments: Any) -> float:
        return float(self.spoil(self.inner(*arguments)))


SPOILED = {
    "+failed": lambda d: 1.7976931348623157e308,
    "-failed": lambda d: -1.7976931348623157e308,
    "nan": lambda d: float("nan"),
    "overstated": lambda d: d + 1e3,
}


@pytest.mark.parametrize("spoil", SPOILED.values(), ids=SPOILED.keys())
@pytest.mark.parametrize("spread", [0.4, 5.0])
@pytest.mark.parametrize("pair", [(CUBE, ROD), (Box([1.0, 2.0]), Ellipsoid([1.0, 0.5]))])
def test_what_coal_gets_wrong_is_found_another_way(
    pair: tuple[ConvexSet, ConvexSet], spread: float, spoil: Any
) -> None:
    if pair[0].dim == 3:
        poses = scattered(4, spread)
    else:
        rng = np.random.default_rng(0)
        poses = Pose.planar(spread * rng.normal(size=(4, 2)), rng.uniform(-3, 3, size=4))
    home = Pose.identity(pair[0].dim)
    good = PairQuery(*pair).batch(home, poses)
    spoiled = PairQuery(*pair)
    method = spoiled._method
    assert isinstance(method, CoalPair)
    method._distance = _Sabotaged(method._distance, spoil)
    distance, _, bound = spoiled.batch(home, poses)
    np.testing.assert_allclose(distance, good[0], atol=1e-5)
    np.testing.assert_allclose(bound, good[0], atol=1e-5)
    one = spoiled.query(home, poses[0])
    assert one.distance == pytest.approx(good[0][0], abs=1e-5)


def test_a_plane_that_is_too_deep_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    """A tangent plane on the far side: consistent with its depth, and not the way out."""
    query, near = CoalPair(CUBE, CUBE), np.array([1.5, 0.0, 0.0])
    rotation = np.eye(3)[None]
    proven = query.proven(rotation, near[None], np.array([[0.0, 1.0, 0.0]]))
    assert proven[0] == -2.0
    assert not query._believable(rotation, near[None], proven, proven)[0]
    best = query.proven(rotation, near[None], np.array([[1.0, 0.0, 0.0]]))
    assert query._believable(rotation, near[None], best, best)[0]


def test_tight_settings_are_why_planes_prove_the_distance() -> None:
    """With coal's default tolerance the planes of its normals prove visibly less."""
    poses = scattered(300, 5.0)
    tight = PairQuery(EGG, ROD).batch(poses, Pose.identity())
    apart = tight[0] > 0.1
    assert np.max((tight[0] - tight[2])[apart]) < 1e-7
    request = module.coal.DistanceRequest()
    assert request.gjk_tolerance > module.GJK_TOLERANCE
    loose = PairQuery(EGG, ROD)
    module._request.cache_clear()
    try:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(module, "GJK_TOLERANCE", request.gjk_tolerance)
            patch.setattr(module, "ACCEPTED_GAP", 1.0)
            answer = loose.batch(poses, Pose.identity())
    finally:
        module._request.cache_clear()
    assert np.max((answer[0] - answer[2])[apart]) > 1e-5


class _Unknown(ConvexSet):
    dim = 3
    bounding_radius = 1.0

    def support(self, n: Array) -> tuple[Array, Array]:
        return Sphere(1.0).support(n)


def test_bad_input_is_refused() -> None:
    home, many = Pose.identity(), scattered(3, 1.0)
    with pytest.raises(InputError, match="Box and Sphere: have 3 and 2 dimensions"):
        PairQuery(CUBE, Sphere(1.0, dim=2))
    with pytest.raises(InputError, match="dimensions"):
        PairQuery(CUBE, ROD).query(Pose.identity(2), home)
    with pytest.raises(InputError, match=r"PairQuery.query: was given a batch"):
        PairQuery(CUBE, ROD).query(many, home)
    with pytest.raises(InputError, match=r"PairQuery.batch: was given batches"):
        PairQuery(CUBE, ROD).batch(home, home)
    with pytest.raises(InputError, match=r"PairQuery.batch: was given batches"):
        PairQuery(CUBE, ROD).batch(many, many[:2])


def test_a_set_that_no_library_knows_is_answered_all_the_same() -> None:
    poses = scattered(3, 3.0)
    known = PairQuery(Sphere(1.0), CUBE).batch(Pose.identity(), poses)
    found = PairQuery(_Unknown(), CUBE).batch(Pose.identity(), poses)
    np.testing.assert_allclose(found[0], known[0], atol=1e-8)


def test_two_half_spaces_have_no_distance() -> None:
    wall = HalfSpace([0.0, 0.0, 1.0], 0.5)
    with pytest.raises(CapabilityError, match="two half-spaces"):
        PairQuery(wall, wall)
