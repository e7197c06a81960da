"""A point mass in both dimensions."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.scenario.point_mass import PointMass


@pytest.mark.parametrize("dim", [2, 3])
def test_names_and_pose(dim: int) -> None:
    model = PointMass(2.0, dim)
    assert model.state_names == ("x_m", "y_m", "z_m")[:dim] + ("vx_m_s", "vy_m_s", "vz_m_s")[:dim]
    assert model.control_names == ("fx_n", "fy_n", "fz_n")[:dim]
    r, v = np.random.default_rng(0).normal(size=(2, 5, dim))
    x = model.assemble(r, np.zeros((5, 4)), v, np.zeros((5, 3)))
    pose = model.pose(x)
    assert pose.dim == dim
    np.testing.assert_array_equal(pose.position, r)
    np.testing.assert_array_equal(pose.rotation, np.broadcast_to(np.eye(dim), (5, dim, dim)))
    velocity, rate = model.velocity(x)
    np.testing.assert_array_equal(velocity, v)
    assert rate.shape == (5, 3)
    assert not rate.any()


@pytest.mark.parametrize(("mass", "dim"), [(0.0, 3), (np.inf, 3), (1.0, 4)])
def test_bad_data_is_refused(mass: float, dim: int) -> None:
    with pytest.raises(InputError):
        PointMass(mass, dim)
