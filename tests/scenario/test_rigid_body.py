"""Mass properties are physical, and the native state is what its names say."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.scenario.rigid_body import RigidBody


def test_inertia_about_the_centre_of_mass_is_that_of_point_masses() -> None:
    rng = np.random.default_rng(1)
    masses, points = rng.uniform(1, 2, 6), rng.normal(size=(6, 3))

    def inertia(x: np.ndarray) -> np.ndarray:
        return sum(m * (p @ p * np.eye(3) - np.outer(p, p)) for m, p in zip(masses, x, strict=True))

    moment = masses @ points
    body = RigidBody(masses.sum(), inertia(points), moment)
    centred = points - moment / masses.sum()
    np.testing.assert_allclose(body.inertia_cm_kg_m2, inertia(centred), atol=1e-12)
    np.testing.assert_allclose(body.centre_of_mass_m, moment / masses.sum())


@pytest.mark.parametrize(
    ("mass", "inertia", "moment", "says"),
    [
        (-3.0, np.eye(3), np.zeros(3), "mass_kg: is -3"),
        (np.nan, np.eye(3), np.zeros(3), "mass_kg"),
        (3.0, np.diag([5, 5, -5.0]), np.zeros(3), "not positive definite"),
        (3.0, np.diag([1, 1, 0.0]), np.zeros(3), "not positive definite"),
        (3.0, np.eye(3) + np.triu(np.ones((3, 3)), 1), np.zeros(3), "not symmetric"),
        # A plate's (1, 1, 2) is the limit of the triangle inequality.
        (3.0, np.diag([1, 1, 2.01]), np.zeros(3), "principal moments 1, 1, 2.01"),
        (3.0, np.eye(3), np.array([0, 2.0, 0]), "about the centre of mass"),
        # Positive definite about both points, but no body: (5, 5 − 12/3, 5 − 12/3).
        (3.0, np.diag([5, 5, 5.0]), np.array([np.sqrt(12), 0, 0]), "principal moments 1, 1, 5"),
        (3.0, np.eye(2), np.zeros(3), "shape"),
        (3.0, np.diag([1, 1, np.inf]), np.zeros(3), "infinite"),
    ],
)
def test_impossible_mass_properties_are_refused(
    mass: float, inertia: np.ndarray, moment: np.ndarray, says: str
) -> None:
    with pytest.raises(InputError, match=says):
        RigidBody(mass, inertia, moment)


def test_a_thin_plate_printed_with_rounding_is_a_body() -> None:
    RigidBody(1.0, np.diag([0.333333, 0.333333, 0.666667]))


def test_pose_and_velocity_of_assembled_states() -> None:
    body = RigidBody(3.0, np.diag([2.0, 5, 5]))
    rng = np.random.default_rng(2)
    r, v, w = rng.normal(size=(3, 7, 3))
    q = quaternion.normalise(rng.normal(size=(7, 4)))
    x = body.assemble(r, q, v, w)
    assert x.shape == (7, len(body.state_names))
    assert [body.state_names.index(n) for n in ("x_m", "vx_m_s", "qw", "wx_rad_s")] == [0, 3, 6, 10]
    x[:, 6:10] *= 1.7  # the pose normalises
    pose = body.pose(x)
    np.testing.assert_allclose(pose.position, r)
    np.testing.assert_allclose(pose.rotation, quaternion.rotation_matrix(q), atol=1e-14)
    velocity, rate = body.velocity(x)
    np.testing.assert_allclose(velocity, v)
    np.testing.assert_allclose(rate, pose.rotate(w), atol=1e-14)
