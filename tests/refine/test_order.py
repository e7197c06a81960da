"""The observed order is the method's own on smooth problems, and another where meshes are not."""

from __future__ import annotations

import math

import pytest

from berthing.refine.order import order_check
from berthing.refine.refiner import Refiner
from berthing.solve.ipopt import Answer
from berthing.transcription.mesh import Mesh
from berthing.transcription.scheme import scheme as node_set
from berthing.verify.observed_order import RESOLVED, OrderCheck, Study
from support.documents import puck, scenario, spacecraft
from support.solving import guessed, posed


def checked(given, segments: int, degree: int, scheme: str = "lgr"):
    """The order check of a scenario's straight way on a mesh."""
    problem = posed(given, segments, degree, scheme=scheme)
    refiner = Refiner(
        given, problem.phase, problem.mesh, "plane", 0, lambda *_: None, deadline=math.inf
    )
    attempts: list = []
    outcome = refiner.solve("plan", problem, guessed(problem), None, attempts, "sharp")
    return order_check(refiner, "order", Answer(problem, outcome), attempts), attempts


@pytest.fixture(scope="module")
def turning():
    """A body with three inertias that turns as it begins: no polynomial is the answer."""
    uneven = {"model": "rigid-body", "mass_kg": 3, "inertia_kg_m2": [2, 5, 6]}
    return scenario(
        spacecraft(
            dynamics=uneven,
            start={"position_m": [0, 0, 0], "rate_rad_s": [0.01, 0, 0]},
            goal={"position_m": [10, 4, 0]},
        )
    )


@pytest.mark.parametrize(("degree", "segments"), [(2, 8), (3, 4)])
def test_smooth_motion_shows_the_order_of_the_method(turning, degree: int, segments: int) -> None:
    found, attempts = checked(turning, segments, degree)
    meshes = (segments, 2 * segments, 4 * segments)
    assert found.own.expected == 2 * degree - 1
    assert found.own.segments == meshes
    assert found.order == pytest.approx(2 * degree - 1, abs=0.3)
    assert found.shown == found.own
    assert [a.guess for a in attempts[1:]] == [
        f"order, degree {degree}, {n} segments" for n in meshes
    ]


def test_meshes_that_are_not_halved_show_another_order(turning, monkeypatch) -> None:
    halve = Mesh.split

    def wrong(mesh: Mesh, segments: set[int]) -> Mesh:
        return halve(mesh, {7} if mesh.segments == 8 else segments)

    monkeypatch.setattr(Mesh, "split", wrong)
    found, _ = checked(turning, 8, 2)
    assert found.own.segments == (8, 9, 18)
    assert found.own.order is None or found.own.order < 1.0


def test_what_polynomials_meet_exactly_shows_its_order_at_a_lower_degree() -> None:
    """From rest to rest with degree 1, N segments cost N²/(N² − 1) times the least."""
    found, attempts = checked(scenario(puck()), 2, 2)
    assert found.own.order is None
    assert max(found.own.moves) < 1e-12
    assert found.shown is not None
    assert found.shown.degree == 1
    least = 12.0 * 2.0**2 * 6.0**2 / 100.0**3
    assert found.own.costs[0] == pytest.approx(least, rel=1e-12)
    expected = [least * n**2 / (n**2 - 1) for n in (2, 4, 8)]
    assert found.shown.costs == pytest.approx(expected, rel=1e-9)
    first, second, third = expected
    assert found.order == pytest.approx(math.log2((first - second) / (second - third)), abs=1e-6)
    assert len(attempts) == 7


def test_a_solve_that_fails_leaves_no_order(turning, monkeypatch) -> None:
    problem = posed(turning, 2, 2)
    refiner = Refiner(
        turning, problem.phase, problem.mesh, "plane", 0, lambda *_: None, deadline=math.inf
    )
    outcome = refiner.solve("plan", problem, guessed(problem), None, [], "sharp")
    monkeypatch.setattr("berthing.refine.refiner.ITERATIONS", 1)
    attempts: list = []
    assert order_check(refiner, "order", Answer(problem, outcome), attempts) is None
    assert attempts[-1].outcome == "iteration_limit"


def study(*costs: float) -> Study:
    return Study(4, 7, (2, 4, 8), costs)


def test_the_order_is_that_of_the_differences() -> None:
    assert study(1.0 + 1e-3, 1.0 + 1.25e-4, 1.0).order == pytest.approx(2.807, abs=1e-3)
    assert study(1.01, 1.0, 1.0 + 0.5 * RESOLVED).order is None
    assert study(1.0, 1.0, 1.0).order is None
    # A cost that moves more on the finer mesh does not settle.
    assert study(1.0, 1.01, 1.05).order < 0.0
    whole = OrderCheck(study(1.0, 1.0, 1.0), study(1.01, 1.001, 1.0))
    assert whole.order == pytest.approx(math.log2(9.0), abs=1e-6)
    assert whole.to_json()["shown_by"]["order"] == whole.order
    assert OrderCheck(study(1.0, 1.0, 1.0), None).to_json()["shown_by"] is None


def test_what_is_expected_follows_from_the_quadrature() -> None:
    """Exact to degree 2n − 2 with n Radau points, to 2n − 3 with n Lobatto points."""
    for scheme, degree, exact in (("lgr", 3, 4), ("lgl", 3, 5)):
        nodes = node_set(scheme)(degree)
        assert len(nodes.collocated) + len(nodes.points) - 2 == exact + 1
        for power in range(exact + 2):
            integral = float(nodes.weights @ nodes.control_points**power)
            true = (1.0 - (-1.0) ** (power + 1)) / (power + 1)
            assert (abs(integral - true) < 1e-12) is (power <= exact)
