"""Problems with an answer in closed form: what the programme must give to rounding."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.verify.optimality import hamiltonian, relative_drift
from support.documents import puck, scenario
from support.solving import solved

MASS_KG, DISTANCE_M, DURATION_S = 3.0, 10.0, 100.0
LEAST = 12.0 * MASS_KG**2 * DISTANCE_M**2 / DURATION_S**3
"""∫f² of a double integrator from rest to rest."""

MESHES = [(1, 3), (4, 4), (3, 7)]


@pytest.fixture(scope="module", params=MESHES, ids=str)
def straight(request):
    return solved(scenario(), *request.param)


def test_cost_is_that_of_the_double_integrator(straight) -> None:
    assert straight.outcome.solved
    assert straight.outcome.cost == pytest.approx(LEAST, rel=1e-9)


def test_cost_is_that_of_the_planar_one_too() -> None:
    found = solved(scenario(puck()), 2, 4)
    assert found.outcome.cost == pytest.approx(12.0 * 2.0**2 * 6.0**2 / DURATION_S**3, rel=1e-9)


def test_a_coarser_mesh_does_not_reach_it() -> None:
    found = solved(scenario(), 4, 1)
    assert found.outcome.solved
    assert abs(found.outcome.cost / LEAST - 1.0) > 1e-2


def test_the_lower_hamiltonian_is_constant(straight) -> None:
    times, values = hamiltonian(straight.problem.phase, straight.nodes)
    assert len(times) == straight.problem.mesh.control_count
    assert relative_drift(values) < 1e-6
    # H = −f(0)² at rest.
    assert np.mean(values) == pytest.approx(-3.0 * LEAST / DURATION_S, rel=1e-6)


def test_costates_are_the_analytic_ones(straight) -> None:
    nodes = straight.nodes[0]
    s = nodes.times_s / DURATION_S
    along = 2.0 * LEAST / DISTANCE_M
    np.testing.assert_allclose(nodes.costates[:, 0], -along, rtol=1e-7)
    # λ_v = −2 m f, at the end too, where no control lives.
    force = 0.25 * along * DURATION_S / MASS_KG * (1.0 - 2.0 * s)
    np.testing.assert_allclose(nodes.costates[:, 3], -2.0 * MASS_KG * force, atol=1e-7)
    np.testing.assert_allclose(nodes.controls[:-1, 0], force[:-1], atol=1e-8)
    others = np.delete(nodes.costates, [0, 3], axis=1)
    np.testing.assert_allclose(others, 0.0, atol=1e-7)


def test_multipliers_without_the_mapping_are_no_costates(straight) -> None:
    problem = straight.problem
    rows = problem.defect_rows["spacecraft"][0][:, 0]
    raw = -straight.outcome.multipliers[rows] * problem.layout.scale.cost
    raw = raw / problem.layout.scale.vehicles[0].state[0]
    assert np.ptp(raw) > 0.05 * np.abs(np.mean(raw))


@pytest.fixture(scope="module")
def hurried():
    """J = ∫ (f² + price) dt over a free horizon: 12 m² d²/T³ + price T is least where
    T⁴ = 36 m² d²/price."""
    price = 36.0 * MASS_KG**2 * DISTANCE_M**2 / 120.0**4
    given = scenario(horizon={"min_s": 60, "max_s": 200}, cost={"time": price})
    return price, solved(given, 2, 4)


def test_a_free_horizon_takes_the_best_duration(hurried) -> None:
    price, found = hurried
    assert found.outcome.solved
    assert found.outcome.motion.duration_s == pytest.approx(120.0, rel=1e-6)
    assert found.outcome.cost == pytest.approx(4.0 / 3.0 * price * 120.0, rel=1e-8)
    assert found.trajectory.t1_s == found.outcome.motion.duration_s
    # It began elsewhere.
    assert found.problem.phase.horizon.nominal_s == pytest.approx(np.sqrt(60 * 200))


def test_with_a_free_horizon_the_hamiltonian_is_zero(hurried) -> None:
    price, found = hurried
    _, values = hamiltonian(found.problem.phase, found.nodes)
    np.testing.assert_allclose(values, 0.0, atol=1e-6 * price)


def test_a_horizon_held_short_has_a_hamiltonian_below_zero() -> None:
    price = 36.0 * MASS_KG**2 * DISTANCE_M**2 / 120.0**4
    found = solved(scenario(horizon={"min_s": 60, "max_s": 100}, cost={"time": price}), 2, 4)
    assert found.outcome.motion.duration_s == pytest.approx(100.0, abs=1e-5)
    _, values = hamiltonian(found.problem.phase, found.nodes)
    assert np.max(values) < -0.5 * price
