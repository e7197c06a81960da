"""Poses act, compose and invert, one by one or in batches."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.pose import Pose

RNG = np.random.default_rng(8)


def many(count: int, dim: int) -> Pose:
    position = RNG.normal(size=(count, dim))
    if dim == 2:
        return Pose.planar(position, RNG.uniform(-3, 3, size=count))
    return Pose.from_quaternion(position, RNG.normal(size=(count, 4)))


def test_turns_before_it_shifts() -> None:
    quarter = quaternion.from_axis_angle(np.array([0.0, 0.0, 1.0]), np.pi / 2)
    pose = Pose.from_quaternion(np.array([10.0, 0.0, 0.0]), quarter)
    np.testing.assert_allclose(pose.apply(np.array([1.0, 0.0, 0.0])), [10.0, 1.0, 0.0], atol=1e-15)
    planar = Pose.planar(np.array([10.0, 0.0]), np.pi / 2)
    np.testing.assert_allclose(planar.apply(np.array([1.0, 0.0])), [10.0, 1.0], atol=1e-15)


@pytest.mark.parametrize("dim", [2, 3])
def test_composes_and_inverts(dim: int) -> None:
    first, second, x = many(7, dim), many(7, dim), RNG.normal(size=(7, dim))
    both = first.compose(second)
    np.testing.assert_allclose(both.apply(x), first.apply(second.apply(x)), atol=1e-14)
    np.testing.assert_allclose(first.inverse().apply(first.apply(x)), x, atol=1e-14)
    nothing = first.compose(first.inverse())
    np.testing.assert_allclose(nothing.rotation, np.tile(np.eye(dim), (7, 1, 1)), atol=1e-14)
    np.testing.assert_allclose(nothing.position, 0.0, atol=1e-14)
    np.testing.assert_allclose(first.unrotate(first.rotate(x)), x, atol=1e-14)


@pytest.mark.parametrize("dim", [2, 3])
def test_indexes_and_broadcasts(dim: int) -> None:
    poses, points = many(6, dim), RNG.normal(size=(4, dim))
    assert len(poses) == 6
    assert poses.batch_shape == (6,)
    assert poses[2].batch_shape == ()
    assert poses[1:4].batch_shape == (3,)
    assert poses[:, None].apply(points).shape == (6, 4, dim)
    assert poses[..., None].batch_shape == (6, 1)
    assert poses[np.array([True, False] * 3)].batch_shape == (3,)
    np.testing.assert_allclose(poses[:, None].apply(points)[2], poses[2].apply(points))
    one = Pose.identity(dim)
    assert one.compose(poses).batch_shape == (6,)
    assert poses.compose(one).batch_shape == (6,)
    assert poses.dim == one.dim == dim


def test_one_rotation_serves_many_positions() -> None:
    poses = Pose(np.zeros((5, 3)), np.eye(3))
    assert poses.rotation.shape == (5, 3, 3)
    assert poses[4].rotation.shape == (3, 3)


def test_does_not_follow_its_arguments() -> None:
    position = np.zeros(3)
    pose = Pose(position, np.eye(3))
    position[0] = 1.0
    assert pose.position[0] == 0.0


BAD = [
    (np.zeros(4), np.eye(4), "Pose.position: has the shape"),
    (np.zeros(3), np.eye(2), "Pose.rotation: has the shape"),
    (np.zeros((4, 3)), np.tile(np.eye(3), (5, 1, 1)), "Pose: batches"),
    (np.array([0.0, np.nan]), np.eye(2), "Pose.position: contains NaN"),
    (np.zeros(2), np.full((2, 2), np.nan), "Pose.rotation: is not orthonormal"),
    (np.zeros(3), 1.001 * np.eye(3), "Pose.rotation: is not orthonormal"),
    (np.zeros(3), np.diag([1.0, 1.0, -1.0]), "Pose.rotation: mirrors"),
    ("nowhere", np.eye(3), "Pose: position or rotation is not an array"),
]


@pytest.mark.parametrize(("position", "rotation", "message"), BAD)
def test_is_refused(position: np.ndarray, rotation: np.ndarray, message: str) -> None:
    with pytest.raises(InputError, match=message):
        Pose(position, rotation)


def test_a_single_pose_has_no_length_and_dimensions_do_not_mix() -> None:
    with pytest.raises(TypeError, match="no length"):
        len(Pose.identity())
    with pytest.raises(InputError, match=r"Pose.compose: joins 2 with 3 dimensions"):
        Pose.identity(2).compose(Pose.identity(3))
    with pytest.raises(InputError, match="quaternion: is zero"):
        Pose.from_quaternion(np.zeros(3), np.zeros(4))
