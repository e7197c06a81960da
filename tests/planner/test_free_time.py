"""Plans whose duration is for the solver to choose, certified."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.planner import plan
from berthing.result import CERTIFIED, Result
from berthing.scenario.scenario import Scenario
from support.documents import box, puck, scenario, spacecraft, structure

FREE = {"min_s": 30, "max_s": 200}
LEAST_TIME = {"control_energy": 0, "time": 1}
MIXED = {"control_energy": 1, "time": 1e-4}
LIMITS = {"max_force_n": 0.02, "max_torque_nm": 0.01}
SMALL = [{"name": "hull", "shape": box(2, 1, 1)}]
DRIFT = {"type": "constant-velocity", "velocity_m_s": [0.0, 0.03, 0]}
SPIN = {"type": "spin", "rate_rad_s": 0.03}


def certified(given: Scenario) -> Result:
    result = plan(given)
    assert result.outcome == CERTIFIED, (result.advice, result.attempts)
    return result


def duration(result: Result) -> float:
    assert result.plan is not None
    return result.plan.phases[0].t1_s


def craft(**goal):
    return spacecraft(parts=SMALL, limits=LIMITS, goal={"position_m": [10, 0, 0]} | goal)


def test_least_time_of_a_point_mass_is_twice_the_root():
    """Full push, then full brake: T = 2 √(d m / f), here 6 m, 2 kg and 0.03 N along x."""
    given = scenario(puck(limits={"max_force_n": 0.03}), horizon=FREE, cost=LEAST_TIME)
    exact = 2 * np.sqrt(6 * 2 / 0.03)
    found = duration(certified(given))
    assert exact * (1 - 1e-6) <= found <= 1.003 * exact


def test_where_energy_is_all_that_counts_the_longest_time_is_taken():
    result = certified(scenario(puck(), horizon={"min_s": 30, "max_s": 60}))
    assert duration(result) == pytest.approx(60.0, abs=1e-5)


def test_least_time_of_scenario_a_s_vehicle_turns_its_diagonal_along_the_path():
    """60.1 s is out of reach for any attitude, 77.5 s is the best without turning."""
    vehicle = spacecraft(limits=LIMITS, goal={"position_m": [10, 3, 0]})
    result = certified(scenario(vehicle, horizon={"min_s": 30, "max_s": 150}, cost=LEAST_TIME))
    assert 65.4 <= duration(result) <= 75.0
    assert duration(result) <= 69.3  # 69.1 s on a fine mesh
    assert result.verification is not None
    assert result.verification.replay_position_error_m <= 1e-3


@pytest.mark.slow
@pytest.mark.parametrize("cost", [LEAST_TIME, MIXED], ids=["time", "mixed"])
def test_past_a_wall_that_drifts_into_the_way(cost):
    wall = structure("wall", [5, -3, 0], box(1, 5, 3), motion=DRIFT)
    result = certified(scenario(craft(), structures=[wall], horizon=FREE, cost=cost))
    assert 64.0 <= duration(result) <= 160.0


@pytest.mark.slow
def test_a_goal_on_a_ferry_is_met_wherever_it_is_by_then():
    ferry = structure("ferry", [9, 0, 0], box(2, 2, 2), motion=DRIFT)
    given = scenario(
        craft(position_m=[0, 2.2, 0], frame="ferry"), structures=[ferry], horizon=FREE, cost=MIXED
    )
    result = certified(given)
    t = duration(result)
    assert result.plan is not None
    (last,) = result.plan.phases[0].vehicles[0].state(np.array([t]))
    np.testing.assert_allclose(last[0:3], [9, 2.2 + 0.03 * t, 0], atol=1e-6)
    np.testing.assert_allclose(last[3:6], [0, 0.03, 0], atol=1e-6)


@pytest.mark.slow
def test_through_the_sweep_of_a_bar_that_spins():
    bar = structure("bar", [5, 0, 0], box(6, 1, 1), motion=SPIN)
    result = certified(scenario(craft(), structures=[bar], horizon=FREE, cost=MIXED))
    assert 60.0 <= duration(result) <= 200.0


@pytest.mark.slow
def test_a_margin_that_holds_for_a_while_only():
    """1.5 m from the wall until t = 60 s, whenever the plan ends."""
    wall = structure("wall", [5, -2, 0], box(1, 3, 3))
    window = {"between": ["spacecraft", "wall"], "margin_m": 1.5, "window_s": [0, 60]}
    margins = {"default_m": 0.1, "overrides": [window]}
    given = scenario(craft(), structures=[wall], horizon=FREE, cost=MIXED, margins=margins)
    result = certified(given)
    assert duration(result) > 70.0
