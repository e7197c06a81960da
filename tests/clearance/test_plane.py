"""The plane bound by hand; that it never exceeds a distance is a law in tests/laws."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.clearance.plane import plane_bound
from berthing.errors import InputError
from berthing.geometry.box import Box
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere

CUBE, BALL = Box([1.0, 1.0, 1.0]), Sphere(0.5)
HERE, THERE = Pose.identity(), Pose(np.array([4.0, 0.0, 0.0]), np.eye(3))
X = np.array([1.0, 0.0, 0.0])


def test_by_hand() -> None:
    assert plane_bound(CUBE, HERE, BALL, THERE, X) == pytest.approx(4.0 - 1.0 - 0.5)
    assert plane_bound(CUBE, HERE, BALL, THERE, -X) == pytest.approx(-4.0 - 1.0 - 0.5)


def test_a_short_normal_proves_less_and_a_long_one_no_more() -> None:
    assert plane_bound(CUBE, HERE, BALL, THERE, 0.5 * X) == pytest.approx(1.25)
    assert plane_bound(CUBE, HERE, BALL, THERE, 10.0 * X) == pytest.approx(2.5)
    assert plane_bound(CUBE, HERE, BALL, THERE, 0.0 * X) == 0.0


def test_turns_normals_into_the_sets_frames() -> None:
    diagonal = Pose.from_quaternion(
        np.zeros(3), np.array([np.cos(np.pi / 8), 0.0, 0.0, np.sin(np.pi / 8)])
    )
    assert plane_bound(CUBE, diagonal, BALL, THERE, X) == pytest.approx(3.5 - np.sqrt(2.0))


def test_broadcasts() -> None:
    poses = Pose(np.random.default_rng(0).normal(size=(5, 3)), np.eye(3))
    normals = np.random.default_rng(1).normal(size=(7, 1, 3))
    bounds = plane_bound(CUBE, poses, BALL, THERE, normals)
    assert bounds.shape == (7, 5)
    one = plane_bound(CUBE, poses[3], BALL, THERE, normals[2, 0])
    assert bounds[2, 3] == pytest.approx(float(one))


def test_bad_input_is_refused() -> None:
    with pytest.raises(InputError, match="plane_bound: n: contains NaN"):
        plane_bound(CUBE, HERE, BALL, THERE, np.array([1.0, np.nan, 0.0]))
    with pytest.raises(InputError, match="plane_bound: n: has the shape"):
        plane_bound(CUBE, HERE, BALL, THERE, np.ones(2))
    with pytest.raises(InputError, match=r"Box and Sphere: .*\(3, 3, 2, 3\) dimensions"):
        plane_bound(CUBE, HERE, Sphere(1.0, dim=2), THERE, X)
    with pytest.raises(InputError, match=r"\(3, 2, 3, 3\) dimensions"):
        plane_bound(CUBE, Pose.identity(2), BALL, THERE, X)
