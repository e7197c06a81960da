"""What flies under the exported controls is what the interpolant says, or it is noticed."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from berthing.geometry.box import Box
from berthing.scenario.point_mass import PointMass
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.wrench import Wrench
from berthing.verify.equations import derivative
from berthing.verify.replay import replay

CUBE = Box(np.ones(3))


def controls_replaced(flown, change):
    return replace(
        flown, segments=tuple(replace(s, control=change(s.control)) for s in flown.segments)
    )


def test_an_exact_solution_is_met(make) -> None:
    own = make.vehicle(CUBE)
    found = replay(own.model, make.glide(own, (0, 0, 0), (3, 1, 0), 1.5))
    assert found.position_error_m < 1e-9
    assert found.attitude_error_rad < 1e-9
    assert found.reasons == []


@pytest.mark.parametrize(
    "change",
    [lambda u: -u, lambda u: 1.01 * u, lambda u: np.roll(u, 3, axis=1), lambda u: 0.0 * u],
    ids=["sign", "one percent", "columns", "none"],
)
def test_other_controls_do_not_fly_the_same(make, change) -> None:
    own = make.vehicle(CUBE)
    flown = controls_replaced(make.glide(own, (0, 0, 0), (3, 1, 0), 1.5), change)
    found = replay(own.model, flown)
    assert found.end_position_error_m > 1e-3
    assert found.time_s > 0.0
    assert len(found.reasons) == 4
    assert "is off by" in found.reasons[0]


def test_a_wiggle_of_the_interpolant_cannot_hide(make) -> None:
    """1 cm in one segment, with no trace at its ends nor in the other columns."""
    own = make.vehicle(CUBE)
    flown = make.glide(own, (0, 0, 0), (3, 1, 0))
    state = np.zeros((25, 13))
    state[: len(flown.segments[4].state)] = flown.segments[4].state
    state[[0, 24], 1] += 0.005, -0.005
    segments = list(flown.segments)
    segments[4] = replace(segments[4], state=state)
    found = replay(own.model, replace(flown, segments=tuple(segments)))
    assert 0.01 - 1e-6 <= found.position_error_m <= 0.02
    assert found.end_position_error_m < 1e-9
    assert len(found.reasons) == 1


def test_another_mass_does_not_fly_the_same(make) -> None:
    own = make.vehicle(CUBE)
    flown = make.glide(own, (0, 0, 0), (3, 1, 0))
    assert replay(RigidBody(3.03, 5.0 * np.eye(3)), flown).position_error_m > 1e-2


def test_a_tumbling_body_with_an_arm_against_an_integrator(make) -> None:
    """Restarted at the kinks of the arm's force, which lie within segments."""
    arm = Wrench(
        "arm", np.array([0.5, 0.1, 0.0]), np.array([1.3, 2.7, 6.1]),
        np.array([[0.0, 0, 0], [0.2, -0.1, 0.3], [0, 0, 0]]), np.zeros((3, 3)),
    )  # fmt: skip
    model = RigidBody(3.0, np.diag([2.0, 3.0, 4.0]), np.array([0.2, 0.1, -0.1]), (arm,))
    rates = derivative(model)
    x0 = np.concatenate([[0, 0, 0, 0.1, 0, 0, 1, 0, 0, 0], [0.2, -0.1, 0.3]])
    true = solve_ivp(
        lambda t, x: rates(t, x, np.zeros(6)), (0, 10), x0, "DOP853", rtol=1e-12, atol=1e-12,
        dense_output=True, max_step=0.05,
    )  # fmt: skip
    own = make.vehicle(CUBE, model=model)
    flown = make.trajectory(own, lambda t: true.sol(t).T, segments=60, degree=6)
    found = replay(model, flown)
    assert found.position_error_m < 1e-6
    assert found.attitude_error_rad < 1e-6


def test_an_integration_that_fails_is_infinitely_off(make) -> None:
    own = make.vehicle(CUBE)
    flown = controls_replaced(make.glide(own, (0, 0, 0), (3, 1, 0)), lambda u: u + 1e200)
    found = replay(own.model, flown)
    assert found.position_error_m == np.inf
    assert found.reasons


def test_point_mass(make) -> None:
    own = make.vehicle(Box(np.ones(2)), model=PointMass(2.0, 2))
    flown = make.trajectory(
        own, lambda t: np.stack([t**2, 0 * t, 2 * t, 0 * t], axis=1),
        lambda t: np.stack([4.0 + 0 * t, 0 * t], axis=1),
    )  # fmt: skip
    found = replay(own.model, flown)
    assert found.position_error_m < 1e-10
    assert found.attitude_error_rad == 0.0
