"""The conic form is the set: it agrees with the level, and its dual gives the support value."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import clarabel
import numpy as np
import pytest
from scipy import sparse

from berthing.geometry.arrays import Array
from berthing.geometry.capability import conic_form, level
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder

Draw = Callable[[int, int], Array]
SOLVER_TOLERANCE = 1e-7


def dual_support(form: ConicForm, n: Array) -> float:
    """min b·λ + Σ head t − b·u  with  Aᵀλ + Σ A_iᵀ u_i = n, λ ≥ 0, ‖u_i‖ ≤ t_i, by Clarabel."""
    m = len(form.linear_b)
    cost, columns = [form.linear_b], [form.linear_A.T]
    rows, cones = [np.eye(m)], [clarabel.NonnegativeConeT(m)] if m else []
    for block in form.blocks:
        cost += [np.array([block.head]), -block.b]
        columns += [np.zeros((form.dim, 1)), block.A.T]
        rows.append(np.eye(1 + len(block.b)))
        cones.append(clarabel.SecondOrderConeT(1 + len(block.b)))
    q, equality = np.concatenate(cost), np.concatenate(columns, axis=1)
    A = sparse.vstack([sparse.csc_matrix(equality), -sparse.block_diag(rows)], format="csc")
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    solver = clarabel.DefaultSolver(
        sparse.csc_matrix((len(q), len(q))),
        q,
        A,
        np.concatenate([n, np.zeros(len(q))]),
        [clarabel.ZeroConeT(form.dim), *cones],
        settings,
    )
    answer = solver.solve()
    assert answer.status == clarabel.SolverStatus.Solved
    return float(answer.obj_val)


def check_same_set(form: ConicForm, shape: ConvexSet, x: Array) -> None:
    height = level(shape, x)
    clear = np.abs(height) > 1e-9
    np.testing.assert_array_equal((form.excess(x) <= 0.0)[clear], (height <= 0.0)[clear])


def check_dual(form: ConicForm, shape: ConvexSet, n: Array) -> None:
    for one in n:
        assert dual_support(form, one) == pytest.approx(
            float(shape.support(one)[0]), abs=SOLVER_TOLERANCE, rel=SOLVER_TOLERANCE
        )


def test_agrees_with_the_level(shape: ConvexSet, rng: np.random.Generator) -> None:
    spread = np.maximum(shape.bounding_radius, 1.0)
    x = rng.uniform(-1.2, 1.2, size=(2000, shape.dim)) * spread
    on_axis = x * (rng.uniform(size=x.shape) < 0.5)
    check_same_set(conic_form(shape), shape, np.concatenate([x, on_axis]))


def test_boundary_is_the_same(shape: ConvexSet, directions: Draw) -> None:
    point = shape.support(directions(100, shape.dim))[1]
    np.testing.assert_allclose(conic_form(shape).excess(point), 0.0, atol=1e-12)


def test_dual_gives_the_support_value(shape: ConvexSet, rng: np.random.Generator) -> None:
    check_dual(conic_form(shape), shape, rng.normal(size=(8, shape.dim)))


def test_has_the_dimension_of_its_set(shape: ConvexSet) -> None:
    form = conic_form(shape)
    assert form.dim == shape.dim
    assert form.linear_A.shape == (len(form.linear_b), shape.dim)
    for block in form.blocks:
        assert block.A.shape == (len(block.b), shape.dim)


def test_the_checks_notice_a_missing_block(rng: np.random.Generator) -> None:
    shape = Cylinder(1.0, 2.0)
    form = conic_form(shape)
    blocks = (replace(form.blocks[0], head=1.9), form.blocks[1])
    with pytest.raises(AssertionError):
        check_same_set(replace(form, blocks=blocks), shape, rng.uniform(-2, 2, size=(2000, 3)))
    with pytest.raises(AssertionError):
        check_dual(replace(form, blocks=blocks), shape, rng.normal(size=(3, 3)))
