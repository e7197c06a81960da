"""The independent equations keep what physics keeps."""

import numpy as np
import pytest

from berthing.errors import CapabilityError
from berthing.geometry import quaternion
from berthing.geometry.arrays import skew
from berthing.scenario.point_mass import PointMass
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.wrench import Wrench
from berthing.verify.equations import (
    coriolis,
    derivative,
    derivatives,
    knots_s,
    mass_matrix,
    quadratic_load,
)
from support import users

MASS = 3.0
CENTRE = np.array([0.3, -0.2, 0.4])
J_CENTRE = np.array([[2.0, 0.1, 0.0], [0.1, 3.0, 0.2], [0.0, 0.2, 4.0]])


def lopsided(*wrenches: Wrench) -> RigidBody:
    """A body whose reference point is off its centre of mass."""
    about = J_CENTRE + MASS * (CENTRE @ CENTRE * np.eye(3) - np.outer(CENTRE, CENTRE))
    return RigidBody(MASS, about, MASS * CENTRE, wrenches)


def some_state(seed: int = 0) -> np.ndarray:
    rng = np.random.default_rng(seed)
    x = rng.normal(size=13)
    x[6:10] = quaternion.normalise(x[6:10])
    return x


def of_centre(x: np.ndarray, rates: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Acceleration of the centre of mass and derivative of the spin about it, inertial axes."""
    R, w, w_dot = quaternion.rotation_matrix(x[6:10]), x[10:13], rates[10:13]
    acceleration = rates[3:6] + R @ (np.cross(w_dot, CENTRE) + np.cross(w, np.cross(w, CENTRE)))
    spin = R @ (J_CENTRE @ w_dot + np.cross(w, J_CENTRE @ w))
    return acceleration, spin


@pytest.mark.parametrize("seed", range(5))
def test_free_motion_keeps_momentum_and_energy(seed: int) -> None:
    x = some_state(seed)
    rates = derivative(lopsided())(0.0, x, np.zeros(6))
    acceleration, spin = of_centre(x, rates)
    np.testing.assert_allclose(acceleration, 0.0, atol=1e-13)
    np.testing.assert_allclose(spin, 0.0, atol=1e-13)


@pytest.mark.parametrize("seed", range(3))
def test_loads_at_the_reference_point_move_the_centre_of_mass(seed: int) -> None:
    x, u = some_state(seed), np.random.default_rng(seed).normal(size=6)
    acceleration, spin = of_centre(x, derivative(lopsided())(0.0, x, u))
    R = quaternion.rotation_matrix(x[6:10])
    np.testing.assert_allclose(acceleration, R @ u[:3] / MASS, atol=1e-13)
    np.testing.assert_allclose(spin, R @ (u[3:] - np.cross(CENTRE, u[:3])), atol=1e-12)


def test_as_printed_the_first_row_would_not_keep_momentum() -> None:
    """Without −ω×(c×ω), the paper's l(ν), a free body accelerates by itself."""
    model, x = lopsided(), some_state()
    R, w = quaternion.rotation_matrix(x[6:10]), x[10:13]
    nu = np.concatenate([R.T @ x[3:6], w])
    load = coriolis(model, nu)
    load[:3] += np.cross(w, np.cross(model.first_moment_kg_m, w))
    nu_dot = np.linalg.solve(mass_matrix(model), -load)
    rates = np.zeros(13)
    rates[3:6], rates[10:13] = R @ (nu_dot[:3] + np.cross(w, nu[:3])), nu_dot[3:]
    assert np.linalg.norm(of_centre(x, rates)[0]) > 0.1


def test_kinematics() -> None:
    x = some_state(3)
    rates = derivative(lopsided())(0.0, x, np.zeros(6))
    np.testing.assert_array_equal(rates[:3], x[3:6])
    R = quaternion.rotation_matrix
    h = 1e-6
    spin = (R(x[6:10] + h * rates[6:10]) - R(x[6:10] - h * rates[6:10])) / (2 * h)
    np.testing.assert_allclose(spin, R(x[6:10]) @ skew(x[10:13]), atol=1e-9)


def test_the_quadratic_form_is_tabulated_right() -> None:
    model, nu = lopsided(), np.random.default_rng(7).normal(size=6)
    np.testing.assert_allclose((quadratic_load(model) @ nu) @ nu, coriolis(model, nu), atol=1e-12)


def test_manipulators_act_at_their_points() -> None:
    arm = Wrench(
        "arm", np.array([1.0, 0.0, 0.0]), np.array([0.0, 2.0]),
        np.array([[0.0, 1.0, 0.0], [0.0, 3.0, 0.0]]), np.array([[0.0, 0.0, 1.0], [0.0, 0.0, 1.0]]),
    )  # fmt: skip
    x = some_state(4)
    free = derivative(lopsided())
    for t, force in ((-1.0, 1.0), (0.0, 1.0), (1.0, 2.0), (5.0, 3.0)):
        pushed = derivative(lopsided(arm))(t, x, np.zeros(6))
        load = np.array([0.0, force, 0.0, 0.0, 0.0, 1.0 + force])
        np.testing.assert_allclose(pushed, free(t, x, load), atol=1e-13)
    np.testing.assert_array_equal(knots_s(lopsided(arm)), [0.0, 2.0])
    assert len(knots_s(PointMass(1.0))) == 0


def test_point_mass() -> None:
    rates = derivative(PointMass(2.0, 2))(
        0.0, np.array([1.0, 2.0, 3.0, 4.0]), np.array([1.0, -1.0])
    )
    np.testing.assert_array_equal(rates, [3.0, 4.0, 0.5, -0.5])


def test_a_model_without_equations_is_refused() -> None:
    class Other(PointMass):
        kind = "other"

    with pytest.raises(CapabilityError, match="'other'"):
        derivative(Other(1.0))


@pytest.mark.parametrize("name", ["lopsided", "pushed", "point", "user"])
def test_many_at_once_are_the_same(name: str) -> None:
    arm = Wrench(
        "arm", np.array([1.0, 0.2, 0.0]), np.array([0.2, 0.6]),
        np.array([[0.0, 0.1, 0.0], [0.3, 0.0, 0.0]]), np.zeros((2, 3)),
    )  # fmt: skip
    model = {
        "lopsided": lopsided(), "pushed": lopsided(arm), "point": PointMass(2.0, 3),
        "user": users.rover(),
    }[name]  # fmt: skip
    rng = np.random.default_rng(4)
    t = np.linspace(0.0, 1.0, 7)
    x = rng.normal(size=(7, len(model.state_names)))
    u = rng.normal(size=(7, len(model.control_names)))
    one = derivative(model)
    expected = [one(float(a), b, c) for a, b, c in zip(t, x, u, strict=True)]
    np.testing.assert_allclose(derivatives(model)(t, x, u), expected, rtol=1e-12, atol=1e-12)
