"""Mass properties against closed forms and sums."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.geometry import quaternion
from berthing.geometry.pose import Pose
from berthing.mesh.mass import NOTHING, MassProperties, of_solid
from support import solids


def test_a_box_has_the_moments_of_the_book():
    mass = of_solid(solids.solid(solids.box((1, 2, 3), (4, 5, 6))), 10.0)
    centre = np.array([4.0, 5.0, 6.0])
    about_centre = 60.0 / 12.0 * np.diag([4 + 9, 1 + 9, 1 + 4])
    shift = 60.0 * (centre @ centre * np.eye(3) - np.outer(centre, centre))
    assert mass.mass_kg == pytest.approx(60.0)
    np.testing.assert_allclose(mass.first_moment_kg_m, 60.0 * centre)
    np.testing.assert_allclose(mass.inertia_kg_m2, about_centre + shift, rtol=1e-12)


def test_a_far_away_solid_keeps_its_digits():
    near = of_solid(solids.solid(solids.l_bracket()))
    far = of_solid(solids.solid(solids.moved(solids.l_bracket(), 1e4, -2e4, 3e4)))
    back = far.seen_from(Pose(np.array([-1e4, 2e4, -3e4]), np.eye(3)))
    assert far.mass_kg == pytest.approx(near.mass_kg, rel=1e-9)
    np.testing.assert_allclose(
        back.first_moment_kg_m, near.first_moment_kg_m, atol=1e-7 * near.mass_kg
    )


def test_mass_moves_with_its_frame():
    """The same bracket, turned and shifted as a mesh or as mass properties."""
    turn = quaternion.rotation_matrix(np.array([0.5, 0.5, -0.1, 0.7]))
    pose = Pose(np.array([0.3, -1.0, 2.0]), turn)
    corners = solids.l_bracket()
    as_mesh = of_solid(solids.solid(pose.apply(corners)), 2700.0)
    as_mass = of_solid(solids.solid(corners), 2700.0).seen_from(pose)
    np.testing.assert_allclose(as_mesh.first_moment_kg_m, as_mass.first_moment_kg_m, rtol=1e-11)
    np.testing.assert_allclose(as_mesh.inertia_kg_m2, as_mass.inertia_kg_m2, rtol=1e-11)


def test_masses_add_up():
    two = of_solid(solids.solid(np.concatenate([solids.box((1, 1, 1), (c, 0, 0)) for c in (0, 3)])))
    one = of_solid(solids.solid(solids.box((1, 1, 1))))
    total = NOTHING + one + one.seen_from(Pose(np.array([3.0, 0, 0]), np.eye(3)))
    np.testing.assert_allclose(total.inertia_kg_m2, two.inertia_kg_m2, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(one.scaled(3.0).inertia_kg_m2, 3.0 * one.inertia_kg_m2)


def test_inertia_about_the_centre_comes_back():
    inertia = np.array([[3.0, 0.1, 0.2], [0.1, 4.0, 0.3], [0.2, 0.3, 5.0]])
    found = MassProperties.of_inertia(2.0, inertia).inertia_kg_m2
    np.testing.assert_allclose(found, inertia, rtol=1e-15)
