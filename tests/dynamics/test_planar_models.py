"""The bicycle and the planar body: circles, energies, and bad data."""

import casadi as ca
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from berthing.dynamics.models import symbolic
from berthing.errors import InputError
from berthing.scenario.bicycle import bicycle
from berthing.scenario.free_flyer import free_flyer
from berthing.verify.equations import derivative

INTEGRATED = 1e-8
"""Of DOP853 at 1e-11 over some tens of seconds."""


def flown(model, x0, u, duration_s):
    f = derivative(model)
    done = solve_ivp(
        lambda t, x: f(t, x, u), (0.0, duration_s), x0, "DOP853", rtol=1e-11, atol=1e-11
    )
    return done.y[:, -1]


def test_a_car_with_its_wheels_turned_drives_in_a_circle():
    model, steering = bicycle(2.7), 0.4
    radius = 2.7 / np.tan(steering)
    quarter_s = 0.5 * np.pi * radius / 1.5
    end = flown(model, np.array([1.0, 2.0, 0.0, 1.5, steering]), np.zeros(2), quarter_s)
    np.testing.assert_allclose(end[:3], [1 + radius, 2 + radius, 0.5 * np.pi], atol=INTEGRATED)


def test_the_rear_axle_does_not_slip():
    x = np.array([0.3, -1.0, 0.7, -1.2, 0.3])
    velocity, rate = bicycle(2.7).velocity(x)
    assert velocity @ [-np.sin(0.7), np.cos(0.7)] == pytest.approx(0.0, abs=1e-15)
    assert rate[2] == pytest.approx(-1.2 * np.tan(0.3) / 2.7)


def test_a_guess_takes_the_speed_along_the_heading():
    model = bicycle(2.7)
    q = np.array([np.cos(0.25), 0, 0, np.sin(0.25)])
    backwards = -0.8 * np.array([np.cos(0.5), np.sin(0.5)])
    x = model.assemble(np.array([1.0, 2.0]), q, backwards, np.zeros(3))
    np.testing.assert_allclose(x, [1.0, 2.0, 0.5, -0.8, 0.0], atol=1e-15)


def test_a_free_flyer_obeys_newton_and_euler():
    model = free_flyer(4.0, 0.5)
    thrust, torque, spin = 2.0, 0.3, 0.2
    end = flown(model, np.array([0, 0, 0, 0, 0, spin]), np.array([thrust, 0.0, torque]), 3.0)
    angle = spin * 3.0 + 0.5 * (torque / 0.5) * 9.0
    assert end[4] == pytest.approx(angle, abs=INTEGRATED)
    # The velocity is ∫ f/m (cos θ, sin θ) dt.
    times, weights = np.polynomial.legendre.leggauss(60)
    at = 1.5 * (times + 1.0)
    turned = spin * at + 0.5 * (torque / 0.5) * at**2
    along = 1.5 * weights @ np.stack([np.cos(turned), np.sin(turned)], axis=1)
    np.testing.assert_allclose(end[2:4], thrust / 4.0 * along, atol=INTEGRATED)


@pytest.mark.parametrize("model", [bicycle(2.7), free_flyer(4.0, 0.5)], ids=lambda m: m.name)
def test_expressions_and_numbers_agree(model):
    rng = np.random.default_rng(3)
    x, u = rng.normal(size=len(model.states)), rng.normal(size=len(model.controls))
    expression = symbolic(model).derivative(model, 0.0, ca.DM(x), ca.DM(u))
    np.testing.assert_allclose(
        np.array(expression).ravel(), derivative(model)(0.0, x, u), atol=1e-13
    )


@pytest.mark.parametrize("bad", [0.0, -1.0, np.nan, np.inf])
def test_sizes_are_positive(bad):
    with pytest.raises(InputError, match="wheelbase_m"):
        bicycle(bad)
    with pytest.raises(InputError, match="mass_kg"):
        free_flyer(bad, 1.0)
    with pytest.raises(InputError, match="inertia_kg_m2"):
        free_flyer(1.0, bad)
