"""Conventions and identities of attitude quaternions."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array, skew

COUNT = 200


@pytest.fixture
def q() -> Array:
    return quaternion.normalise(np.random.default_rng(5).normal(size=(COUNT, 4)))


@pytest.fixture
def p() -> Array:
    return quaternion.normalise(np.random.default_rng(6).normal(size=(COUNT, 4)))


def test_a_quarter_turn_about_z_takes_x_to_y() -> None:
    turn = quaternion.from_axis_angle(np.array([0.0, 0.0, 3.0]), np.pi / 2)
    np.testing.assert_allclose(turn, [np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)], atol=1e-15)
    R = quaternion.rotation_matrix(turn)
    np.testing.assert_allclose(R @ [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], atol=1e-15)


def test_rotation_matrix_agrees_with_scipy(q: Array) -> None:
    np.testing.assert_allclose(
        quaternion.rotation_matrix(q),
        Rotation.from_quat(q[:, [1, 2, 3, 0]]).as_matrix(),
        atol=1e-14,
    )


def test_the_paper_has_the_transpose(q: Array) -> None:
    """C_sI = (η² − εᵀε) 1 + 2 ε εᵀ − 2 η ε^×, with the same components."""
    eta, epsilon = q[:, 0], q[:, 1:]
    scalar = (eta**2 - np.sum(epsilon**2, axis=1))[:, None, None] * np.eye(3)
    C_sI = (
        scalar + 2 * epsilon[:, :, None] * epsilon[:, None] - 2 * eta[:, None, None] * skew(epsilon)
    )
    np.testing.assert_allclose(quaternion.rotation_matrix(q), np.swapaxes(C_sI, 1, 2), atol=1e-14)


def test_rotation_matrix_normalises(q: Array) -> None:
    R = quaternion.rotation_matrix(q)
    np.testing.assert_allclose(quaternion.rotation_matrix(-3.7 * q), R, atol=1e-14)


def test_products_compose(p: Array, q: Array) -> None:
    R = quaternion.rotation_matrix
    np.testing.assert_allclose(R(quaternion.multiply(p, q)), R(p) @ R(q), atol=1e-14)
    same = quaternion.multiply(q, quaternion.conjugate(q))
    np.testing.assert_allclose(same, np.tile([1.0, 0.0, 0.0, 0.0], (COUNT, 1)), atol=1e-15)


def test_products_broadcast(q: Array) -> None:
    assert quaternion.multiply(q[0], q).shape == (COUNT, 4)
    assert quaternion.multiply(q[:, None], q[None, :3]).shape == (COUNT, 3, 4)


def test_matrix_there_and_back(q: Array) -> None:
    back = quaternion.from_matrix(quaternion.rotation_matrix(q))
    np.testing.assert_allclose(back, q * np.sign(q[:, :1]), atol=1e-14)


@pytest.mark.parametrize("axis", np.eye(3))
@pytest.mark.parametrize("angle", [0.0, 1e-9, np.pi / 2, np.pi - 1e-9, np.pi])
def test_matrix_of_a_hard_angle(axis: Array, angle: float) -> None:
    turn = quaternion.from_axis_angle(axis, angle)
    back = quaternion.from_matrix(quaternion.rotation_matrix(turn))
    assert quaternion.angle_between(turn, back) < 1e-15


def test_rotation_vector_there_and_back(q: Array) -> None:
    v = quaternion.rotation_vector(q)
    assert np.all(np.linalg.norm(v, axis=1) <= np.pi)
    np.testing.assert_allclose(quaternion.rotation_vector(-q), v, atol=1e-14)
    back = quaternion.from_rotation_vector(v)
    np.testing.assert_allclose(back, q * np.sign(q[:, :1]), atol=1e-14)
    np.testing.assert_allclose(v, Rotation.from_quat(q[:, [1, 2, 3, 0]]).as_rotvec(), atol=1e-13)


@pytest.mark.parametrize("size", [0.0, 1e-300, 1e-12, 1e-6])
def test_small_rotations_keep_their_digits(size: float) -> None:
    v = size * np.array([0.6, 0.0, 0.8])
    back = quaternion.rotation_vector(quaternion.from_rotation_vector(v))
    np.testing.assert_allclose(back, v, rtol=1e-14)


def test_slerp_turns_at_a_constant_rate_along_the_shorter_arc(p: Array, q: Array) -> None:
    s = np.linspace(0.0, 1.0, 11)
    path = quaternion.slerp(p[:, None], q[:, None], s)
    assert path.shape == (COUNT, 11, 4)
    whole = quaternion.angle_between(p, q)
    steps = quaternion.angle_between(path[:, :-1], path[:, 1:])
    np.testing.assert_allclose(steps, np.tile(whole[:, None] / 10, 10), atol=1e-13)
    np.testing.assert_allclose(quaternion.angle_between(path[:, -1], q), 0.0, atol=1e-14)
    np.testing.assert_allclose(quaternion.slerp(p, -q, 0.3), path[:, 3], atol=1e-13)


def test_angle_between_knows_the_double_cover(q: Array) -> None:
    np.testing.assert_allclose(quaternion.angle_between(q, -q), 0.0, atol=1e-15)
    tilt = quaternion.from_axis_angle(np.array([1.0, 2.0, 3.0]), 0.25)
    np.testing.assert_allclose(quaternion.angle_between(q, quaternion.multiply(q, tilt)), 0.25)


def test_single_quaternions_give_single_answers(q: Array) -> None:
    assert quaternion.rotation_matrix(q[0]).shape == (3, 3)
    assert quaternion.angle_between(q[0], q[1]).shape == ()
    assert quaternion.slerp(q[0], q[1], 0.5).shape == (4,)
    assert quaternion.from_matrix(np.eye(3)).tolist() == [1.0, 0.0, 0.0, 0.0]


@pytest.mark.parametrize("bad", [np.zeros(4), np.full(4, np.nan), np.array([1.0, np.inf, 0, 0])])
def test_no_attitude_is_refused(bad: Array) -> None:
    with pytest.raises(InputError, match="quaternion: is zero or not finite"):
        quaternion.rotation_matrix(bad)


def test_wrong_shapes_and_axes_are_refused() -> None:
    with pytest.raises(InputError, match="quaternion: has the shape"):
        quaternion.normalise(np.ones(3))
    with pytest.raises(InputError, match="rotation axis: is zero"):
        quaternion.from_axis_angle(np.zeros(3), 1.0)
    with pytest.raises(InputError, match="rotation matrix: has the shape"):
        quaternion.from_matrix(np.eye(2))
