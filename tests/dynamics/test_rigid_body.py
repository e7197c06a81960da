"""The rigid body against the check's own equations and against what free motion conserves."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from berthing.dynamics.rigid_body import mass_matrix
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.scenario.point_mass import PointMass
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.wrench import Wrench
from berthing.verify import equations

SPAN_S = 20.0
ROUNDING = 1e-12
CONSERVED = 1e-9
"""DOP853 at a relative 1e-12 over 20 s leaves less than this of quantities of order ten."""

WRENCHES = (
    Wrench("arm", np.array([1.0, 0.5, -0.2]), np.array([0.0, 4.0, 9.0]),
           np.array([[0.0, 0.1, 0.0], [0.3, -0.1, 0.2], [0.1, 0.0, 0.1]]),
           np.array([[0.1, 0.0, 0.0], [0.0, 0.2, 0.0], [0.0, 0.0, 0.3]])),
    Wrench("tether", np.zeros(3), np.array([2.0]), np.array([[0.0, 0.0, 0.5]]), np.zeros((1, 3))),
)  # fmt: skip


def integrals(model: RigidBody, x: Array) -> Array:
    """Linear momentum, angular momentum about the origin (both inertial) and kinetic energy."""
    r, v, w = x[0:3], x[3:6], x[10:13]
    turn = quaternion.rotation_matrix(x[6:10])
    c, v_B = model.first_moment_kg_m, turn.T @ v
    p = turn @ (model.mass_kg * v_B + np.cross(w, c))
    spin = turn @ (model.inertia_kg_m2 @ w + np.cross(c, v_B))
    nu = np.concatenate([v_B, w])
    return np.concatenate([p, np.cross(r, p) + spin, [0.5 * nu @ mass_matrix(model) @ nu]])


def drift(model: RigidBody, rates: Callable[[float, Array], Array], x0: Array) -> float:
    """Largest change of any integral of free motion over ``SPAN_S``."""
    run = solve_ivp(rates, (0.0, SPAN_S), x0, "DOP853", rtol=1e-12, atol=1e-13)
    assert run.success
    start = integrals(model, x0)
    return float(max(np.max(np.abs(integrals(model, x) - start)) for x in run.y.T[1:]))


def as_printed(model: RigidBody) -> Callable[[float, Array], Array]:
    """The paper's own l(ν), without −ω × (c × ω) in its first row."""
    inverse = np.linalg.inv(equations.mass_matrix(model))

    def rates(t: float, x: Array) -> Array:
        turn, w = quaternion.rotation_matrix(x[6:10]), x[10:13]
        nu = np.concatenate([turn.T @ x[3:6], w])
        load = equations.coriolis(model, nu)
        load[:3] += np.cross(w, np.cross(model.first_moment_kg_m, w))
        nu_dot = inverse @ -load
        acceleration = turn @ (nu_dot[:3] + np.cross(w, nu[:3]))
        q_dot = 0.5 * quaternion.multiply(x[6:10], np.concatenate([[0.0], w]))
        return np.concatenate([x[3:6], acceleration, q_dot, nu_dot[3:]])

    return rates


@pytest.fixture
def tumbling() -> tuple[RigidBody, Array]:
    c = np.array([1.0, 0.5, -0.3])
    model = RigidBody(3.0, np.diag([5.0, 6.0, 7.0]), c)
    x0 = np.array([1.0, -2.0, 0.5, 0.3, 0.1, -0.2, 1.0, 0.0, 0.0, 0.0, 0.4, -0.3, 0.5])
    return model, x0


def test_derivative_is_that_of_the_independent_equations(
    rng, body, states, right_hand_side
) -> None:
    for wrenches in ((), WRENCHES):
        model = body(wrenches)
        mine, theirs = right_hand_side(model), equations.derivative(model)
        for x in states(20):
            t, u = rng.uniform(-1.0, 12.0), rng.normal(size=6)
            expected = theirs(t, x, u)
            np.testing.assert_allclose(mine(t, x, u), expected, rtol=0, atol=ROUNDING * 100)


def test_another_first_moment_gives_another_derivative(tumbling, right_hand_side) -> None:
    model, x0 = tumbling
    other = RigidBody(model.mass_kg, model.inertia_kg_m2, -model.first_moment_kg_m)
    gap = right_hand_side(other)(0.0, x0, np.zeros(6)) - right_hand_side(model)(
        0.0, x0, np.zeros(6)
    )
    assert np.max(np.abs(gap)) > 0.1


def test_free_motion_conserves_momentum_and_energy(tumbling, right_hand_side) -> None:
    model, x0 = tumbling
    rates = right_hand_side(model)
    assert drift(model, lambda t, x: rates(t, x, np.zeros(6)), x0) < CONSERVED


def test_the_equations_as_printed_do_not(tumbling) -> None:
    model, x0 = tumbling
    assert drift(model, as_printed(model), x0) > 0.1


def test_without_a_first_moment_the_printed_equations_hold(tumbling) -> None:
    _, x0 = tumbling
    model = RigidBody(3.0, np.diag([5.0, 6.0, 7.0]))
    assert drift(model, as_printed(model), x0) < CONSERVED


def test_power_is_force_times_velocity(rng, body, states, right_hand_side) -> None:
    # dT/dt = f·v_B + g·ω, by finite difference along the flow.
    model = body()
    rates = right_hand_side(model)
    for x in states(5):
        # The energy needs R(q)ᵀ only, so that the norm of q does not matter.
        u, step = rng.normal(size=6), 1e-6
        slope = rates(0.0, x, u)
        ahead, behind = (integrals(model, x + h * slope)[6] for h in (step, -step))
        v_B = quaternion.rotation_matrix(x[6:10]).T @ x[3:6]
        assert (ahead - behind) / (2 * step) == pytest.approx(
            u[:3] @ v_B + u[3:] @ x[10:], abs=1e-7
        )


def rate_seen(q: Array, q_dot: Array) -> Array:
    """ω_B with Ṙ = R ω^×, by central difference of R(q)."""
    step = 1e-6
    ahead, behind = (quaternion.rotation_matrix(q + h * q_dot) for h in (step, -step))
    seen = quaternion.rotation_matrix(q).T @ (ahead - behind) / (2 * step)
    return np.array([seen[2, 1], seen[0, 2], seen[1, 0]])


def test_the_body_turns_about_its_own_axes(states, right_hand_side, body) -> None:
    rates = right_hand_side(body())
    for x in states(5):
        q, w = x[6:10], x[10:13]
        q_dot = rates(0.0, x, np.zeros(6))[6:10]
        np.testing.assert_allclose(rate_seen(q, q_dot), w, atol=1e-8)
        assert q_dot @ q == pytest.approx(0.0, abs=ROUNDING)


def test_with_the_printed_sign_it_would_turn_about_others(states) -> None:
    for x in states(5):
        q, w = x[6:10], x[10:13]
        printed = 0.5 * np.concatenate([[-q[1:] @ w], q[0] * w - np.cross(q[1:], w)])
        assert np.max(np.abs(rate_seen(q, printed) - w)) > 0.1


@pytest.mark.parametrize("dim", [2, 3])
def test_point_mass_is_that_of_the_independent_equations(dim, rng, right_hand_side) -> None:
    model = PointMass(2.5, dim)
    x, u = rng.normal(size=2 * dim), rng.normal(size=dim)
    expected = equations.derivative(model)(0.0, x, u)
    np.testing.assert_allclose(right_hand_side(model)(0.0, x, u), expected, atol=ROUNDING)
    heavier = right_hand_side(PointMass(5.0, dim))(0.0, x, u)
    np.testing.assert_allclose(2.0 * heavier[dim:], expected[dim:], atol=ROUNDING)
