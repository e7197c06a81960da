"""Residuals of Pontryagin's conditions: none on a true extremal, and each caught when it is not."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from berthing.geometry.box import Box
from berthing.scenario.attitude import AxisAttitude, FreeAttitude
from berthing.trajectory import SeparationCostate
from berthing.verify.extremal import Extremality, extremality, ranges

START, GOAL = (0.0, 0.0, 0.0), (3.0, 1.0, -2.0)
LEAST = 12.0 * 3.0**2 * 14.0 / 10.0**3
"""12 m² d²/T³ of 3 kg from START to GOAL in 10 s."""


@pytest.fixture(scope="module")
def straight(make):
    own = make.vehicle(Box(np.ones(3)))
    glide = make.glide(own, START, GOAL, segments=4)
    plan = replace(make.plan([glide], [make.glide_nodes(glide)]), cost=LEAST)
    still = {"velocity_m_s": np.zeros(3), "rate_rad_s": np.zeros(3)}
    own = replace(own, start=replace(own.start, **still), goal=replace(own.goal, **still))
    return make.scenario([own], []), plan


def changed(plan, **costates):
    """The plan with columns of its costates replaced by functions of them."""
    nodes = plan.nodes[0]
    new = nodes.costates.copy()
    for columns, change in costates.values():
        new[:, columns] = change(new[:, columns])
    return replace(plan, nodes=(replace(nodes, costates=new),))


def test_the_double_integrator_is_an_extremal(straight) -> None:
    found = extremality(*straight)
    assert found.worst < 1e-8
    assert found.digits >= 8.0
    assert found.complementarity == found.dual == 0.0


@pytest.mark.parametrize("factor", [-1.0, 0.5, 1.001])
def test_scaled_costates_leave_the_controls_not_stationary(straight, factor: float) -> None:
    scenario, plan = straight
    found = extremality(scenario, changed(plan, all=(slice(None), lambda p: factor * p)))
    assert found.stationarity > 0.1 * abs(factor - 1.0)
    assert found.drift > 1e-4


def test_costates_of_the_position_must_fit_those_of_the_velocity(straight) -> None:
    scenario, plan = straight
    found = extremality(scenario, changed(plan, r=(slice(0, 3), lambda p: -p)))
    assert found.adjoint > 0.1
    assert found.stationarity < 1e-8


def kinked(straight, at_s: float, size: float):
    """The plan with costates of the position that are ``size`` lower along the way after ``at_s``,
    and those of the velocity that go with them."""
    scenario, plan = straight
    nodes = plan.nodes[0]
    new = nodes.costates.copy()
    late = nodes.times_s >= at_s - 1e-9
    new[late, :3] -= size * np.array(GOAL)
    new[late, 3:6] += size * np.outer(nodes.times_s[late] - at_s, GOAL)
    name = scenario.phases[0].vehicles[0].name
    return scenario, replace(plan, nodes=(replace(nodes, costates=new),)), name


@pytest.mark.parametrize(("factor", "good"), [(1.0, True), (-1.0, False), (0.9, False)])
def test_a_row_accounts_for_its_own_jump(straight, monkeypatch, factor, good) -> None:
    scenario, plan, name = kinked(straight, 5.0, 0.2)
    jump = np.zeros(13)
    jump[:3] = 0.2 * factor * np.array(GOAL)
    rows = (SeparationCostate("main", "a|b", 5.0, 0.2, {name: jump}),)
    monkeypatch.setattr("berthing.verify.extremal.room_m", lambda *_: 0.0)
    found = extremality(scenario, replace(plan, separations=rows))
    assert (found.adjoint < 1e-8) is good
    assert extremality(scenario, plan).adjoint > 0.1


def test_multipliers_have_a_sign_and_pull_only_at_the_margin(straight, monkeypatch) -> None:
    scenario, plan = straight
    rows = [SeparationCostate("main", "a|b", 5.0, value, {}) for value in (0.3, -0.1)]
    monkeypatch.setattr("berthing.verify.extremal.room_m", lambda *_: 0.01)
    held = extremality(scenario, replace(plan, separations=(rows[0],)))
    assert held.complementarity == pytest.approx(0.3 * 0.01 / LEAST)
    assert held.dual == 0.0
    wrong = extremality(scenario, replace(plan, separations=tuple(rows)))
    assert wrong.dual == pytest.approx(0.1 * 3.0 / LEAST)
    assert wrong.complementarity == pytest.approx(held.complementarity)


def with_goal(scenario, **changes):
    phase = scenario.phases[0]
    own = phase.vehicles[0]
    moved = replace(own, goal=replace(own.goal, **changes))
    return replace(scenario, phases=(replace(phase, vehicles=(moved,)),))


def test_a_free_end_must_promise_nothing(straight) -> None:
    scenario, plan = straight
    assert extremality(scenario, plan).transversality < 1e-8
    # The glide stops; with a free final velocity its costate would have to vanish.
    free = extremality(with_goal(scenario, velocity_m_s=None), plan)
    assert free.transversality > 0.1
    # Turning is promised nothing on this plan, whatever the attitude asked for.
    loose = with_goal(scenario, attitude=FreeAttitude(), rate_rad_s=None)
    assert extremality(loose, plan).transversality < 1e-8
    tilted = changed(plan, q=(9, lambda p: p + 0.1))
    assert extremality(scenario, tilted).transversality < 1e-8
    assert extremality(loose, tilted).transversality > 1e-3
    about = AxisAttitude(np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, 1.0]))
    assert extremality(with_goal(scenario, attitude=about), tilted).transversality > 1e-3
    across = AxisAttitude(np.array([1.0, 0.0, 0.0]), np.array([1.0, 0.0, 0.0]))
    assert extremality(with_goal(scenario, attitude=across), tilted).transversality < 1e-8


def test_a_control_at_its_limit_may_press_against_it(straight) -> None:
    scenario, plan = straight
    phase = scenario.phases[0]
    own = phase.vehicles[0]
    top = float(np.max(plan.nodes[0].controls[:, 0]))

    def limited(upper: float, lower: float):
        limits = replace(
            own.limits, control_upper=np.full(6, upper), control_lower=np.full(6, lower)
        )
        vehicle = replace(own, limits=limits)
        return replace(scenario, phases=(replace(phase, vehicles=(vehicle,)),))

    nodes = plan.nodes[0]
    controls = nodes.controls.copy()
    at_top = np.argmax(controls[:, 0])
    costates = nodes.costates.copy()
    # H would fall if the force along x rose: fine at the upper limit, and nowhere else.
    costates[at_top, 3] -= 5.0
    pressed = replace(plan, nodes=(replace(nodes, costates=costates),))
    assert extremality(limited(top, -1.0), pressed).stationarity < 1e-8
    assert extremality(limited(2.0 * top, -1.0), pressed).stationarity > 0.1
    assert extremality(limited(2.0 * top, top), pressed).stationarity > 0.1


def test_without_costates_nothing_is_said(straight) -> None:
    scenario, plan = straight
    blank = replace(plan.nodes[0], costates=np.full_like(plan.nodes[0].costates, np.nan))
    assert extremality(scenario, replace(plan, nodes=(blank,))) is None
    assert extremality(scenario, replace(plan, nodes=())) is None


def test_digits_are_those_of_the_worst() -> None:
    found = Extremality(1e-9, 3e-4, 0.0, 1e-6, 0.0, None)
    assert found.limiting == "adjoint"
    assert found.digits == 3.5
    assert math.isinf(Extremality(0.0, 0.0, 0.0, 0.0, 0.0, None).digits)
    assert found.to_json()["worst"] == 3e-4


def test_ranges_are_shared_by_unit() -> None:
    names = ("x_m", "y_m", "vx_m_s", "qw")
    np.testing.assert_allclose(ranges(names, np.array([1.0, 3.0, 0.5, 0.0])), [3.0, 3.0, 0.5, 3.0])
    np.testing.assert_allclose(ranges(("x_m",), np.zeros(1)), [1.0])
