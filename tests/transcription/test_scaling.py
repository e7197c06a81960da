"""The solver's units: what it works with is of order one."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.scenario.files import load
from berthing.scenario.scenario import Scenario
from berthing.transcription.scaling import PhaseScale, phase_scale
from support.documents import DURATION_S, puck, scenario, spacecraft
from support.solving import posed, solved


def scale_of(given: Scenario) -> PhaseScale:
    return phase_scale(given, given.phases[0])


def test_units_follow_from_the_distance_and_the_time() -> None:
    scale = scale_of(scenario())
    assert scale.time_s == DURATION_S
    assert scale.length_m == pytest.approx(10.0)
    assert scale.cost == pytest.approx(12.0 * 9.0 * 100.0 / DURATION_S**3)
    vehicle = scale.vehicles[0]
    np.testing.assert_allclose(vehicle.state[:6], [10.0] * 3 + [0.1] * 3)
    np.testing.assert_allclose(vehicle.state[6:], [1.0] * 4 + [np.pi / DURATION_S] * 3)
    np.testing.assert_allclose(vehicle.state_shift[:3], [5.0, 0.0, 0.0])
    assert not vehicle.state_shift[3:].any()


def test_a_limit_below_the_reference_is_the_unit_and_one_far_above_is_not() -> None:
    free = scale_of(scenario()).vehicles[0].control
    tight = scale_of(scenario(spacecraft(limits={"max_force_n": 0.008}))).vehicles[0].control
    loose = scale_of(scenario(spacecraft(limits={"max_force_n": 1e6}))).vehicles[0].control
    np.testing.assert_allclose(tight[:3], 0.008)
    np.testing.assert_allclose(loose[:3], 10.0 * free[:3])
    np.testing.assert_allclose(tight[3:], free[3:])


def test_where_nothing_is_to_be_travelled_the_bodys_size_is_the_length() -> None:
    given = scenario(spacecraft(goal={"position_m": [0, 0, 0]}))
    assert scale_of(given).length_m == pytest.approx(np.sqrt(6.0))


def test_vehicles_share_a_length_and_have_their_own_units() -> None:
    far = puck("far", start={"position_m": [0, 5]}, goal={"position_m": [0, 45]})
    far["dynamics"] = {"model": "point-mass", "mass_kg": 20}
    scale = scale_of(scenario(puck(), far))
    assert scale.length_m == pytest.approx(40.0)
    near, other = scale.vehicles
    np.testing.assert_allclose(other.control, 10.0 * near.control)


def test_time_in_the_cost_counts() -> None:
    timed = scale_of(scenario(cost={"time": 2.0, "control_energy": 0.0}))
    assert timed.cost == pytest.approx(2.0 * DURATION_S)


@pytest.mark.parametrize("factor", [1.0, 1e3])
def test_an_answer_is_of_order_one_in_the_solvers_units_whatever_the_size(factor) -> None:
    vehicle = spacecraft(goal={"position_m": [10 * factor, 3 * factor, 0]})
    found = solved(scenario(vehicle), 3, 4)
    assert found.outcome.solved
    assert 0.5 < np.max(np.abs(found.outcome.x)) < 5.0
    value = found.problem.nlp["grad_f"](found.outcome.x, found.outcome.parameters)[0]
    assert 0.5 < float(value) < 5.0


def test_the_shipped_case_starts_of_order_one() -> None:
    given = load("scenario-a")
    lower, upper = posed(given, 2, 3).layout.variables.bounds()
    assert not np.isfinite([*lower, *upper]).any()
    assert scale_of(given).length_m == pytest.approx(np.sqrt(109.0))
