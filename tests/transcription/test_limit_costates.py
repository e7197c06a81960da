"""Multipliers of limits and path constraints are those of the continuous problem."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from berthing.scenario.path_constraint import PathConstraint
from berthing.scenario.user_function import UserFunction
from berthing.trajectory import Plan
from berthing.verify.extremal import extremality
from support.documents import puck, scenario
from support.solving import Solved, solved

MASS_KG, DISTANCE_M, DURATION_S = 2.0, 6.0, 100.0


def plan_of(got: Solved) -> Plan:
    assert got.outcome.solved
    return Plan("test", (got.trajectory,), got.nodes, "plane", "lgr", got.outcome.cost, 1, 0, 0.0)


def test_the_multiplier_of_a_force_limit_is_the_slope_of_h() -> None:
    """At the limit f: ∂H/∂u = 2 f + λ_v/m, and the multiplier makes up for it."""
    limit = 0.8 * 6.0 * MASS_KG * DISTANCE_M / DURATION_S**2
    got = solved(scenario(puck(limits={"max_force_n": limit})), 10, 4)
    nodes = got.nodes[0]
    slope = 2.0 * nodes.controls[:, 0] + nodes.costates[:, 2] / MASS_KG
    pulls = nodes.multipliers["limit_fx_n"]
    assert np.nanmax(pulls) > 0.1 * limit
    assert np.nanmin(pulls) < -0.1 * limit
    np.testing.assert_allclose(pulls[:-1], -slope[:-1], atol=1e-6 * limit)
    assert np.isnan(pulls[-1])
    found = extremality(got.problem.scenario, plan_of(got))
    assert found.stationarity < 1e-4
    # Without it the slope counts, for Bernstein coefficients keep the force inside its limit.
    none = replace(plan_of(got), nodes=(replace(nodes, multipliers={}),))
    assert extremality(got.problem.scenario, none).stationarity > 0.01
    turned = {"limit_fx_n": -pulls}
    wrong = replace(plan_of(got), nodes=(replace(nodes, multipliers=turned),))
    assert extremality(got.problem.scenario, wrong).stationarity > 0.1


@pytest.mark.parametrize("own", [True, False], ids=["path", "limit"])
def test_the_multiplier_of_a_speed_limit_moves_the_costate(own: bool) -> None:
    """While v is held, λ_v stands at zero force and λ̇_v = −λ_x − μ: μ is −λ_x."""
    speed = 0.8 * 1.5 * DISTANCE_M / DURATION_S
    given = scenario(puck(limits={} if own else {"max_speed_m_s": speed}))
    if own:
        top = UserFunction("slow", lambda t, x, u, p, xp: x[2] - p["v"], {"v": speed})
        phase = given.phases[0]
        slow = PathConstraint("slow", top, 1e-6, speed)
        first = replace(phase.vehicles[0], path_constraints=(slow,))
        given = replace(given, phases=(replace(phase, vehicles=(first,)),))
    got = solved(given, 12, 4)
    nodes = got.nodes[0]
    pulls = np.nan_to_num(nodes.multipliers["path_slow_0" if own else "limit_vx_m_s"])
    # λ_x is the same throughout, and λ_v turns from −2 m f to as much the other way by it.
    lever = -nodes.costates[0, 0]
    assert lever > 0.0
    assert np.max(pulls) > 0.5 * lever
    # Rows on Bernstein coefficients pull on their neighbours a little.
    assert np.min(pulls) > -0.02 * lever
    held = np.abs(nodes.times_s - 50.0) < 8.0
    assert np.mean(pulls[held]) == pytest.approx(lever, rel=0.1)
    found = extremality(given, plan_of(got))
    assert found.adjoint < 0.02
    assert found.complementarity < 0.02
    flipped = {name: -values for name, values in nodes.multipliers.items()}
    wrong = extremality(given, replace(plan_of(got), nodes=(replace(nodes, multipliers=flipped),)))
    assert wrong.adjoint > 0.5
    # Turned around they press on the lower limit, far away, or have no side to press on.
    assert wrong.dual + wrong.complementarity > 0.1
