"""Residuals of Pontryagin's conditions: none on a true extremal, and each caught when it is not."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from berthing.geometry.box import Box
from berthing.report.verdict_table import extremality_rows
from berthing.scenario.attitude import AxisAttitude, FreeAttitude
from berthing.trajectory import SeparationCostate
from berthing.verify.extremal import Extremality, extremality, with_best_costates
from berthing.verify.lagrangian import ranges

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
    assert found.limiting == "adjoint"


def all_rooms(monkeypatch, room: float) -> None:
    """Every row has this much room."""
    own = "berthing.verify.extremal.rooms_m"
    monkeypatch.setattr(own, lambda _, plan: [room for _ in plan.separations])


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
    all_rooms(monkeypatch, 0.0)
    found = extremality(scenario, replace(plan, separations=rows))
    assert (found.adjoint < 1e-8) is good
    assert extremality(scenario, plan).adjoint > 0.1


def test_multipliers_have_a_sign_and_pull_only_at_the_margin(straight, monkeypatch) -> None:
    scenario, plan = straight
    rows = [SeparationCostate("main", "a|b", 5.0, value, {}) for value in (0.3, -0.1)]
    all_rooms(monkeypatch, 0.01)
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


def test_the_adjoint_equations_mend_costates_that_do_not_meet_them(straight) -> None:
    """All but the last are spoiled; carried back from it, they are those of the extremal."""
    scenario, plan = straight
    nodes = plan.nodes[0]
    spoiled = nodes.costates.copy()
    spoiled[1:-1] *= 1.5
    bad = replace(plan, nodes=(replace(nodes, costates=spoiled),))
    mended, found = with_best_costates(scenario, bad)
    assert extremality(scenario, bad).worst > 0.1
    assert found.worst < 1e-8
    np.testing.assert_allclose(mended.nodes[0].costates, nodes.costates, atol=1e-8)
    # Where the last is wrong there is nothing to go by.
    wrong = changed(plan, all=(slice(None), lambda p: -p))
    _, still = with_best_costates(scenario, wrong)
    assert still.worst > 0.1


def test_good_costates_stay_what_they_are(straight) -> None:
    scenario, plan = straight
    same, found = with_best_costates(scenario, plan)
    assert found.worst <= extremality(scenario, plan).worst
    np.testing.assert_allclose(same.nodes[0].costates, plan.nodes[0].costates, atol=1e-8)
    blank = replace(plan.nodes[0], costates=np.full_like(plan.nodes[0].costates, np.nan))
    assert with_best_costates(scenario, replace(plan, nodes=(blank,)))[1] is None


def test_controls_that_do_not_follow_their_dynamics_count(straight) -> None:
    """λ (ẋ − f) is what the cost may have gained by it."""
    scenario, plan = straight
    own = plan.phases[0].vehicles[0]
    pushed = []
    for segment in own.segments:
        control = segment.control.copy()
        control[0, 0] *= 1.01
        pushed.append(replace(segment, control=control))
    moved = replace(own, segments=tuple(pushed))
    off = replace(plan, phases=(replace(plan.phases[0], vehicles=(moved,)),))
    assert extremality(scenario, plan).primal < 1e-9
    assert extremality(scenario, off).primal > 1e-3


def with_limit(scenario, value: float):
    phase = scenario.phases[0]
    own = phase.vehicles[0]
    limits = replace(own.limits, control_upper=np.full(6, value), control_lower=np.full(6, -value))
    return replace(scenario, phases=(replace(phase, vehicles=(replace(own, limits=limits),)),))


def test_multipliers_of_limits_enter_where_they_are_known(straight) -> None:
    """A torque that H would have grow: the multiplier of its limit makes up for the slope, has to
    have the sign of its side, and pulls only at the limit."""
    scenario, plan = straight
    nodes = plan.nodes[0]
    pressed = nodes.costates.copy()
    pressed[:, 10] -= 1.0
    slope = pressed[:, 10] / np.trace(scenario.phases[0].vehicles[0].model.inertia_kg_m2) * 3.0

    def given(values, limit: float):
        own = replace(nodes, costates=pressed, multipliers={"limit_gx_nm": values})
        return extremality(with_limit(scenario, limit), replace(plan, nodes=(own,)))

    met = given(-slope, 0.1)
    assert met.stationarity < 1e-6
    assert met.adjoint < 1e-6
    assert met.dual == 0.0
    # No torque is used: all of the limit is room.
    assert met.complementarity == pytest.approx(-slope[0] * 0.1 * 10.0 / LEAST, rel=1e-6)
    assert given(slope, 0.1).stationarity > 0.1
    assert given(0.0 * slope, 0.1).stationarity > 0.05
    assert given(-slope, math.inf).dual > 0.1


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
    found = Extremality(1e-9, 3e-4, 0.0, 1e-6, 0.0, 1e-5, 0.1)
    assert found.limiting == "adjoint"
    assert found.digits == 3.5
    # The drift is no share of the cost, and stands by itself.
    assert found.to_json()["drift"] == 0.1
    assert math.isinf(Extremality(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, None).digits)
    assert found.to_json()["worst"] == 3e-4


def test_a_residual_that_is_no_number_is_the_worst() -> None:
    found = Extremality(0.1, 0.0, math.nan, 0.0, 0.0, 0.0, None)
    assert found.limiting == "transversality"
    assert found.worst == math.inf
    assert found.digits == -math.inf
    (first, *_) = extremality_rows(found)
    assert first.value == "not: worst is transversality, inf of the cost"


def test_ranges_are_shared_by_unit() -> None:
    names = ("x_m", "y_m", "vx_m_s", "qw")
    np.testing.assert_allclose(ranges(names, np.array([1.0, 3.0, 0.5, 0.0])), [3.0, 3.0, 0.5, 3.0])
    np.testing.assert_allclose(ranges(("x_m",), np.zeros(1)), [1.0])
