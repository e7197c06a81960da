"""Newton's method near an answer: rows that come and go, instants of least clearance, saddles."""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np
import pytest

from berthing.solve import newton
from berthing.solve.evaluation import Evaluation
from berthing.solve.newton import AT_LOWER, AT_UPPER, FREE, Bearing, Group, Newton, Reached
from support.solving import programme

INF = np.inf


def solve(
    nlp: dict[str, Any], start: list[float], lower: list[float], upper: list[float],
    sides: list[int] | None = None, groups: tuple[Group, ...] = (), iterations: int = 20,
) -> Reached:  # fmt: skip
    method = Newton(Evaluation(nlp), np.array(lower), np.array(upper), groups)
    x = np.array(start, dtype=np.float64)
    begun = method.begin(x, np.zeros(0))
    if sides is not None:
        begun = Bearing(x, begun.y, np.array(sides, np.int8), begun.out)
    return method.solve(begun, np.zeros(0), tolerance=1e-9, iterations=iterations)


def passing(sign: float) -> dict[str, Any]:
    """x to be near 1 with a gap of at least 2, which is x + sign (s - 1)² at s."""
    v = ca.MX.sym("v", 2)
    return programme(v, (v[0] - 1.0) ** 2, v[0] + sign * (v[1] - 1.0) ** 2)


GAP = Group(np.array([1]), np.array([0]), 0)


def test_a_known_optimum_from_near_by() -> None:
    # Hock and Schittkowski, problem 71, its bound on the first variable as a row.
    x = ca.MX.sym("x", 4)
    f = x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2]
    nlp = programme(x, f, ca.vertcat(x[0] * x[1] * x[2] * x[3], ca.sumsqr(x), x[0]))
    found = solve(nlp, [1.02, 4.7, 3.8, 1.4], [25, 40, 1], [INF, 40, 5],
                  [AT_LOWER, AT_LOWER, AT_LOWER])  # fmt: skip
    assert found.status == newton.SOLVED
    assert found.iterations <= 6
    assert found.bearing.x == pytest.approx([1.0, 4.7429994, 3.8211503, 1.3794082], abs=1e-6)
    assert found.bearing.y == pytest.approx([-0.5522937, 0.1614686, -1.0878712], abs=1e-6)


@pytest.mark.parametrize(
    ("wanted", "side", "reached", "end"),
    [(2.0, AT_UPPER, 2.0, FREE), (5.0, FREE, 3.0, AT_UPPER), (-4.0, AT_UPPER, -1.0, AT_LOWER)],
    ids=["let go", "held", "from one bound to the other"],
)
def test_rows_come_and_go(wanted: float, side: int, reached: float, end: int) -> None:
    x = ca.MX.sym("x", 1)
    found = solve(programme(x, (x - wanted) ** 2, x), [1.0], [-1.0], [3.0], [side])
    assert found.status == newton.SOLVED
    assert found.bearing.x == pytest.approx([reached], abs=1e-8)
    assert found.bearing.sides.tolist() == [end]


def test_an_instant_goes_to_the_least_gap() -> None:
    found = solve(passing(1.0), [1.9, 0.8], [2.0], [INF], groups=(GAP,))
    assert found.status == newton.SOLVED
    assert found.bearing.x == pytest.approx([2.0, 1.0], abs=1e-8)
    assert not found.bearing.out.any()


def test_an_instant_of_the_greatest_gap_is_no_answer() -> None:
    found = solve(passing(-1.0), [2.1, 0.8], [2.0], [INF], groups=(GAP,))
    assert found.status == newton.SADDLE
    assert found.bearing.x == pytest.approx([2.0, 1.0], abs=1e-8)


def test_a_gap_that_pulls_is_left_out_with_all_of_its_own() -> None:
    v = ca.MX.sym("v", 2)
    nlp = programme(v, (v[0] - 5.0) ** 2, v[0] + (v[1] - 1.0) ** 2)
    found = solve(nlp, [1.9, 0.8], [2.0], [INF], groups=(GAP,))
    assert found.status == newton.SOLVED
    assert found.bearing.out.all()
    assert found.bearing.x[0] == pytest.approx(5.0, abs=1e-6)
    assert found.bearing.y.tolist() == [0.0]


def test_what_it_does_not_claim() -> None:
    x = ca.MX.sym("x", 1)
    hill = solve(programme(x, -(x**2), x), [0.1], [-1.0], [1.0])
    assert hill.status == newton.SADDLE
    cut_short = solve(programme(x, ca.exp(x) - x, x), [2.0], [-9.0], [9.0], iterations=1)
    assert cut_short.status == newton.ITERATIONS


def test_numbers_that_are_lost_do_not_stay() -> None:
    x = ca.MX.sym("x", 1)
    method = Newton(
        Evaluation(programme(x, ca.sqrt(x) + 1.0 / x, x)), np.array([-INF]), np.array([INF]), ()
    )
    lost = Bearing(np.array([-1.0]), np.zeros(1), np.zeros(1, np.int8), np.zeros(0, bool))
    near = Bearing(np.array([1.5]), np.zeros(1), np.zeros(1, np.int8), np.zeros(0, bool))
    first = method.solve(lost, np.zeros(0), tolerance=1e-9, iterations=9)
    then = method.solve(near, np.zeros(0), tolerance=1e-9, iterations=9)
    assert first.status == newton.STUCK
    assert then.status == newton.SOLVED
    assert then.bearing.x == pytest.approx([4.0 ** (1.0 / 3.0)], abs=1e-8)
