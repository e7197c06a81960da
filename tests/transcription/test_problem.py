"""A programme is built once and serves other numbers of the same scenario."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Solver
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import build, states_at
from support.documents import DURATION_S, box, puck, scenario, spacecraft, structure
from support.solving import BACKOFF_M, Solved, guessed, posed, solved, start_of


def post(x: float, y: float, **more: Any) -> dict[str, Any]:
    return structure("post", [x, y], {"type": "sphere", "radius_m": 0.6}, **more)


def one() -> Scenario:
    return scenario(puck(), structures=[post(3, 0.1)])


def another() -> Scenario:
    """Other ends, another place and margin; the same vehicles and shapes."""
    vehicle = puck(start={"position_m": [1, -1], "velocity_m_s": [0, 0.05]},
                   goal={"position_m": [5, 2]})  # fmt: skip
    return scenario(vehicle, structures=[post(2.8, 0.9)], margin_m=0.2)


def answer(built_for: Scenario, given: Scenario) -> Solved:
    problem = posed(built_for, 4, 4)
    start = start_of(posed(given, 4, 4), 1)
    return Solved(problem, Solver.build(problem).solve(given, start, backoff_m=BACKOFF_M))


def test_other_numbers_need_no_other_programme() -> None:
    fresh, reused = answer(another(), another()), answer(one(), another())
    assert fresh.outcome.solved
    assert reused.outcome.solved
    assert reused.outcome.cost == pytest.approx(fresh.outcome.cost, rel=1e-3)
    assert abs(answer(one(), one()).outcome.cost / fresh.outcome.cost - 1.0) > 0.05


def test_another_duration_needs_no_other_programme() -> None:
    given = scenario(horizon={"duration_s": 50})
    problem, start = posed(scenario(), 2, 4, []), start_of(posed(given, 2, 4, []))
    outcome = Solver.build(problem).solve(given, start, backoff_m=0.0)
    assert outcome.cost == pytest.approx(12.0 * 9.0 * 100.0 / 50.0**3, rel=1e-7)


@pytest.mark.parametrize("horizon", [{"duration_s": 100}, {"min_s": 50, "max_s": 200}])
def test_a_motion_survives_the_vector(horizon) -> None:
    given = scenario(structures=[structure("block", [5, 0, 0], box(2, 6, 6))], horizon=horizon)
    problem = posed(given, 3, 4)
    motion = guessed(problem, 2)
    motion.controls["spacecraft"][:] = np.arange(6 * 12).reshape(6, 12) * 1e-3
    x = problem.start_vector(given, motion, start_of(problem).normals)
    back = problem.motion(x, 100.0)
    assert back.duration_s == pytest.approx(motion.duration_s)
    for mine, own in ((back.states, motion.states), (back.controls, motion.controls)):
        np.testing.assert_allclose(mine["spacecraft"], own["spacecraft"], atol=1e-13)


def test_the_cost_is_the_integral_in_physical_units() -> None:
    limits = {"max_force_n": 0.014}
    found = solved(scenario(spacecraft(limits=limits), cost={"time": 2e-4}), 4, 4)
    times = np.linspace(0.0, DURATION_S, 40001)
    power = np.sum(found.trajectory.vehicles[0].control(times) ** 2, axis=1)
    integral = np.sum(0.5 * (power[1:] + power[:-1])) * DURATION_S / 40000 + 2e-4 * DURATION_S
    # The midpoint of a segment's break belongs to one of two polynomials.
    assert found.outcome.cost == pytest.approx(integral, rel=1e-4)
    assert found.outcome.cost > 2e-4 * DURATION_S * 1.1


def test_states_between_the_nodes_are_those_of_the_polynomial() -> None:
    mesh = Mesh("lgr", (0.0, 0.3, 1.0), (3, 4))
    t = mesh.point_fractions()
    cubic = np.stack([1.0 + t, t**3 - t**2, 2.0 * t**2])
    places = [(1, 0.37), (0, -0.9), (1, -1.0), (0, 0.5)]
    at = np.array([mesh.fraction(k, s) for k, s in places])
    expected = np.stack([1.0 + at, at**3 - at**2, 2.0 * at**2], axis=1)
    np.testing.assert_allclose(states_at(mesh, cubic, places), expected, atol=1e-14)
    assert states_at(mesh, cubic, []).shape == (0, 3)


def test_parts_that_share_shapes_share_a_formulation() -> None:
    twice = {"name": "twice", "position_m": [0, 3], "parts": [
        {"name": "a", "shape": box(1, 1)}, {"name": "b", "shape": box(1, 1), "position_m": [2, 0]},
    ]}  # fmt: skip
    problem = posed(scenario(puck(), structures=[twice, post(3, -3)]), 1, 3)
    assert len(problem.formulations) == len(problem.pairs) == 3
    for pair, form in zip(problem.pairs, problem.formulations, strict=True):
        assert (form.a, form.b) == (pair.part_a.shape, pair.part_b.shape)


def test_an_unknown_formulation_is_told_which_there_are() -> None:
    given = one()
    with pytest.raises(InputError, match=r"one of .*plane"):
        build(given, given.phases[0], Mesh.uniform("lgr", 1, 3), [], "plan")


def test_the_start_is_the_motion_and_not_another() -> None:
    given = one()
    problem = posed(given, 2, 4)
    normals = start_of(problem).normals
    first, second = (problem.start_vector(given, guessed(problem, i), normals) for i in (0, 1))
    assert np.max(np.abs(first - second)) > 0.05
