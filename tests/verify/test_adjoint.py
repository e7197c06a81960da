"""Costates carried back by the adjoint equations, and what time does to the Hamiltonian."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from berthing.geometry.box import Box
from berthing.geometry.pose import Pose
from berthing.scenario.cost import Cost, RunningCost
from berthing.scenario.motion import ConstantVelocity
from berthing.scenario.user_function import UserFunction
from berthing.trajectory import SeparationCostate
from berthing.verify.adjoint import arcs, carried_back, misses
from berthing.verify.equations import derivative
from berthing.verify.extremal import checked_extremality
from berthing.verify.optimality import balance, drift_of, hamiltonian, relative_drift
from berthing.verify.separation_rows import drawn_m_s, rooms_m

START, GOAL = (0.0, 0.0, 0.0), (3.0, 1.0, -2.0)


@pytest.fixture(scope="module")
def turning(make):
    """A glide that turns by a radian, so that ∂f/∂x moves, and its plan."""
    own = make.vehicle(Box(np.ones(3)))
    glide = make.glide(own, START, GOAL, turn=1.0, segments=4)
    return make.scenario([own], []), make.plan([glide], [make.glide_nodes(glide, 8)])


def found(given, jumps=(), nodes=None):
    scenario, plan = given
    phase = scenario.phases[0]
    vehicle = phase.vehicles[0]
    nodes = nodes or plan.nodes[0]
    own = plan.phases[0].vehicles[0]
    return nodes, arcs(phase, vehicle, nodes, own, jumps)


def test_costates_and_variations_keep_their_product(turning) -> None:
    """λ·δx stands still along the linearised motion where the cost has no slope in x."""
    nodes, own = found(turning)
    scenario, plan = turning
    model = scenario.phases[0].vehicles[0].model
    f, trajectory = derivative(model), plan.phases[0].vehicles[0]
    last = np.random.default_rng(1).normal(size=13)
    carried = carried_back(replace(nodes, costates=np.tile(last, (len(nodes.times_s), 1))), own)
    # Two motions under the same controls from slightly different beginnings.
    step = 1e-5 * np.random.default_rng(2).normal(size=13)
    first, second = trajectory.state(np.zeros(1))[0], trajectory.state(np.zeros(1))[0] + step
    times = np.linspace(0.0, 10.0, 801)
    h = times[1]
    for t in times[:-1]:
        u = [trajectory.control(np.array([at]))[0] for at in (t, t + 0.5 * h, t + h - 1e-12)]
        first, second = (_runge_kutta(f, t, x, u, h) for x in (first, second))
    begin, end = carried.costates[0] @ step, last @ (second - first)
    assert begin == pytest.approx(end, rel=2e-3)
    assert abs(begin - last @ step) > 0.05 * abs(begin)


def _runge_kutta(f, t, x, u, h):
    a = f(t, x, u[0])
    b = f(t + 0.5 * h, x + 0.5 * h * a, u[1])
    c = f(t + 0.5 * h, x + 0.5 * h * b, u[1])
    d = f(t + h, x + h * c, u[2])
    return x + h / 6.0 * (a + 2.0 * b + 2.0 * c + d)


def test_a_jump_inside_an_interval_acts_from_its_own_time(turning, make) -> None:
    scenario, _ = turning
    own = scenario.phases[0].vehicles[0]
    glide = make.glide(own, START, GOAL, segments=4)
    straight = scenario, make.plan([glide], [make.glide_nodes(glide)])
    nodes, _ = found(straight)
    a, b = nodes.times_s[4:6]
    at = 0.3 * a + 0.7 * b
    jump = np.zeros(13)
    jump[0] = 0.2
    zero = replace(nodes, costates=np.zeros_like(nodes.costates))
    _, with_jump = found(straight, [(at, jump)], zero)
    carried = carried_back(zero, with_jump)
    # λ_x is 0.2 before, and λ̇_vx = −λ_x.
    early = nodes.times_s < at
    np.testing.assert_allclose(carried.costates[:, 0], np.where(early, 0.2, 0.0), atol=1e-9)
    expected = np.where(early, 0.2 * (at - nodes.times_s), 0.0)
    np.testing.assert_allclose(carried.costates[:, 3], expected, atol=1e-9)
    assert np.max(np.abs(misses(carried, with_jump))) < 1e-12
    flipped = found(straight, [(at, -jump)], zero)[1]
    assert np.max(np.abs(misses(carried, flipped))) == pytest.approx(0.4, rel=1e-6)


def test_a_cost_that_depends_on_time_moves_h_and_not_the_balance(turning, make) -> None:
    scenario, _ = turning
    own = scenario.phases[0].vehicles[0]
    glide = make.glide(own, START, GOAL, segments=4)
    plan = replace(make.plan([glide], [make.glide_nodes(glide)]), cost=1.0)
    name = own.name
    h = UserFunction("h", lambda t, x, u, p, xp: xp.vector([0.05 * t * t]))
    phase = replace(scenario.phases[0], cost=Cost(1.0, 0.0, (RunningCost(name, h, 1.0),)))
    timed = replace(scenario, phases=(phase,))
    assert relative_drift(hamiltonian(phase, plan.nodes)[1]) > 0.5
    assert relative_drift(balance(timed, plan, phase)[1]) < 1e-6
    # And other costates drift as they did.
    wrong = replace(plan.nodes[0], costates=1.1 * plan.nodes[0].costates)
    assert relative_drift(balance(timed, replace(plan, nodes=(wrong,)), phase)[1]) > 0.01


@pytest.fixture
def receding(make):
    """A cube that recedes at 0.2 m/s along x, 4 m ahead at first, and a vehicle that stands."""
    own = make.vehicle(Box(np.ones(3)))
    away = ConstantVelocity(Pose(np.array([6.0, 0.0, 0.0]), np.eye(3)), np.array([0.2, 0.0, 0.0]))
    wall = make.structure(Box(np.ones(3)), motion=away)
    still = make.path(own, lambda t: np.zeros((len(t), 3)))
    scenario = make.scenario([own], [wall])
    return scenario, make.plan([still], [make.glide_nodes(still)])


def test_rooms_and_speeds_of_rows_are_those_of_the_pair(receding) -> None:
    scenario, plan = receding
    pair = scenario.pairs(scenario.phases[0])[0].name
    rows = tuple(SeparationCostate("main", pair, t, 1.0, {}) for t in (2.0, 5.0))
    with_rows = replace(plan, separations=rows)
    gap = 6.0 - 2.0 - 0.1 - plan.backoff_m
    np.testing.assert_allclose(rooms_m(scenario, with_rows), [gap + 0.4, gap + 1.0], atol=1e-7)
    np.testing.assert_allclose(drawn_m_s(scenario, with_rows), [0.2, 0.2], atol=1e-6)


def test_h_falls_by_what_a_moving_structure_gives(receding) -> None:
    """Before a touch with ν = 3 at 4 s, H is more by ν ∂g/∂t = 0.6 than after: the balance takes
    just that off."""
    scenario, plan = receding
    pair = scenario.pairs(scenario.phases[0])[0].name
    phase = scenario.phases[0]
    row = SeparationCostate("main", pair, 4.0, 3.0, {})
    times, before = balance(scenario, plan, phase)
    _, after = balance(scenario, replace(plan, separations=(row,)), phase)
    np.testing.assert_allclose(after - before, np.where(times >= 4.0, 0.6, 0.0), atol=1e-5)


def test_a_free_horizon_is_judged_by_the_cost_a_second(turning, make) -> None:
    scenario, plan = turning
    phase = scenario.phases[0]
    free = replace(phase, horizon=replace(phase.horizon, min_s=1.0, max_s=100.0))
    nodes = replace(plan.nodes[0], costates=1e-6 * plan.nodes[0].costates)
    small = replace(plan, nodes=(nodes,), cost=1e3)
    assert drift_of(scenario, small, phase)[2] > 0.1
    assert drift_of(scenario, small, free)[2] < 0.1


def test_nodes_that_are_all_at_one_time_do_no_harm(turning) -> None:
    scenario, plan = turning
    phase = scenario.phases[0]
    free = replace(phase, horizon=replace(phase.horizon, min_s=1.0, max_s=100.0))
    nodes = replace(plan.nodes[0], times_s=np.zeros(len(plan.nodes[0].times_s)))
    still = replace(plan, nodes=(nodes,), cost=1.0)
    assert drift_of(replace(scenario, phases=(free,)), still, free)[2] is not None
    assert checked_extremality(scenario, still) is None
