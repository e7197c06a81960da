"""Curvature at an answer: none negative at a minimum, one at a saddle, flat where nothing pulls."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import casadi as ca
import numpy as np
import pytest
from scipy import sparse

from berthing.refine.curvature import FLAT, _below, curvatures, second_order
from berthing.solve.barrier import Bounds
from berthing.solve.evaluation import Evaluation
from berthing.solve.ipopt import Answer, Budget, Solver
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import build
from berthing.transcription.sites import node_sites
from support.documents import box, puck, scenario, structure
from support.solving import programme, start_of


def of_two(f, g) -> dict[str, Any]:
    """f(x, y) and rows g(x, y)."""
    x = ca.MX.sym("x", 2)
    return programme(x, f(x[0], x[1]), ca.vertcat(*g(x[0], x[1])) if g else ca.MX(0, 1))


def found(f, g, bounds, at, y):
    lower, upper = (np.array(b, dtype=float) for b in bounds)
    return curvatures(
        Evaluation(of_two(f, g)), Bounds.of(lower, upper), np.array(at, dtype=float),
        np.array(y, dtype=float), lambda corner: ([], []),
    )  # fmt: skip


NO_ROWS = ([], [])


def saddle(x, y):
    return x**2 - y**2


@pytest.mark.parametrize(
    ("f", "g", "bounds", "at", "y", "negative", "flat"),
    [
        (lambda x, y: x**2 + y**2, None, NO_ROWS, (0, 0), (), 0, 0),
        (saddle, None, NO_ROWS, (0, 0), (), 1, 0),
        (lambda x, y: -(x**2) - y**2, None, NO_ROWS, (0, 0), (), 2, 0),
        (lambda x, y: x**2 + 0.0 * y, None, NO_ROWS, (0, 0), (), 0, 1),
        # An equality takes the bad direction away; one across it does not.
        (saddle, lambda x, y: [y], ([0], [0]), (0, 0), (0,), 0, 0),
        (saddle, lambda x, y: [x], ([0], [0]), (0, 0), (0,), 1, 0),
        # So does a limit that pulls, and not one that is merely there.
        (saddle, lambda x, y: [y], ([-9], [1]), (0, 1 - 1e-10), (2,), 0, 0),
        (saddle, lambda x, y: [y], ([-9], [1]), (0, 0), (1e-10,), 1, 0),
        # The curvature of the rows counts: x² + y² = 1 at its nearest and farthest to (2, 0).
        (lambda x, y: (x - 2) ** 2 + y**2, lambda x, y: [x**2 + y**2], ([1], [1]),
         (1, 0), (1,), 0, 0),
        (lambda x, y: (x - 2) ** 2 + y**2, lambda x, y: [x**2 + y**2], ([1], [1]),
         (-1, 0), (-3,), 1, 0),
    ],
)  # fmt: skip
def test_minima_are_told_from_saddles(f, g, bounds, at, y, negative: int, flat: int) -> None:
    got = found(f, g, bounds, at, y)
    assert (got.negative, got.flat) == (negative, flat)
    assert got.minimum is (negative == flat == 0)
    assert (got.least is None) is not got.minimum


def test_the_least_curvature_is_bounded_from_below() -> None:
    got = found(lambda x, y: 0.5 * (3e-3 * x**2 + 7.0 * y**2), None, NO_ROWS, (0, 0), ())
    assert got.least == pytest.approx(1e-3)


def test_eigenvalues_are_counted_right() -> None:
    rng = np.random.default_rng(0)
    for _ in range(20):
        basis, _ = np.linalg.qr(rng.normal(size=(12, 12)))
        values = rng.normal(size=12)
        matrix = sparse.csc_matrix(basis @ np.diag(values) @ basis.T)
        for level in (-1.0, 0.0, 0.3):
            assert _below(matrix, level) == np.count_nonzero(values < level)


@pytest.fixture(scope="module")
def passing() -> Answer:
    """A puck past a block, which it touches, with planes that nothing but the touch holds."""
    low = structure("low", [3, -1.0], box(0.5, 2.5))
    given = scenario(puck(), structures=[low])
    mesh = Mesh.uniform("lgr", 4, 4)
    sites = node_sites(mesh, 1)
    problem = build(given, given.phases[0], mesh, sites, "plane", regulariser=0.0)
    solver = Solver.build(problem, "cold", Budget(300))
    outcome = solver.solve(given, start_of(problem, 1), backoff_m=0.0)
    assert outcome.solved
    return Answer(problem, outcome)


def test_an_answer_past_a_block_is_a_minimum(passing) -> None:
    got = second_order(passing)
    assert got is not None
    assert got.minimum
    assert got.least > FLAT
    # Planes that pull on nothing are left out.
    assert 100 <= got.variables < len(passing.outcome.x)
    assert got.rows < passing.problem.layout.rows.size
    assert got.to_json()["minimum"] is True


def test_planes_that_are_bent_the_wrong_way_are_no_minimum(passing) -> None:
    """With the signs of all rows but the distances' changed, planes that pull gain by turning."""
    problem, y = passing.problem, passing.outcome.multipliers.copy()
    for block in problem.layout.rows.blocks:
        if block.offset in problem.separation.rows:
            y[block.offset + 1 : block.offset + block.size] *= -1.0
    got = second_order(Answer(problem, replace(passing.outcome, multipliers=y)))
    assert got is not None
    assert got.negative > 0
    assert not got.minimum


@pytest.mark.parametrize(("sign", "negative"), [(1.0, 0), (-1.0, 1)], ids=["least", "greatest"])
def test_instants_are_not_asked_to_be_least_costs(sign: float, negative: int) -> None:
    # x near 1 with a gap of 2, x + sign (s - 1)², at its stationary instant s = 1.
    nlp = of_two(lambda x, s: (x - 1) ** 2, lambda x, s: [x + sign * (s - 1) ** 2])
    bounds = Bounds.of(np.array([2.0]), np.array([np.inf]))
    got = curvatures(
        Evaluation(nlp), bounds, np.array([2.0, 1.0]), np.array([-2.0]),
        lambda corner: ([], []), np.array([1]),
    )  # fmt: skip
    assert got is not None
    assert (got.variables, got.negative) == (1, negative)
