"""The conic form is the set: it agrees with the level, and its dual gives the support value."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import clarabel
import numpy as np
import pytest
from scipy.linalg import block_diag

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.capability import conic_form, level
from berthing.geometry.capsule import Capsule
from berthing.geometry.cone import Cone
from berthing.geometry.conic_form import ConicForm
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from support.cones import cone_rows, solved
from support.shapes import rounding, size

Draw = Callable[[int, int], Array]
SOLVER_TOLERANCE = 1e-7


def solved_support(form: ConicForm, n: Array) -> float:
    """max n·x over the form."""
    return -solved(np.concatenate([-n, np.zeros(form.lift)]), *cone_rows(form, form.size, 0))


def dual_support(form: ConicForm, n: Array) -> float:
    """min b·λ + Σ head τ − b·u  with  Aᵀλ + Σ A_iᵀ u_i − τ_i slope_i = n, λ ≥ 0, ‖u_i‖ ≤ τ_i."""
    m = len(form.linear_b)
    cost, columns = [form.linear_b], [form.linear_A.T]
    rows, cones = [np.eye(m)], [clarabel.NonnegativeConeT(m)] if m else []
    for block in form.blocks:
        slope = np.zeros(form.size) if block.slope is None else block.slope
        cost += [np.array([block.head]), -block.b]
        columns += [-slope[:, None], block.A.T]
        rows.append(np.eye(1 + len(block.b)))
        cones.append(clarabel.SecondOrderConeT(1 + len(block.b)))
    equality = np.concatenate(columns, axis=1)
    rows_of_all = np.concatenate([-equality, block_diag(*rows)])
    wanted = np.concatenate([n, np.zeros(form.lift), np.zeros(equality.shape[1])])
    return solved(
        np.concatenate(cost), rows_of_all, wanted, [clarabel.ZeroConeT(form.size), *cones]
    )


def lifted_excess(form: ConicForm, x: Array) -> float:
    """The least s with which every row holds at x, its right side raised by s."""
    raised = replace(
        form,
        linear_A=np.column_stack([form.linear_A, -np.ones(len(form.linear_b))]),
        blocks=tuple(
            replace(
                block,
                A=np.column_stack([block.A, np.zeros(len(block.b))]),
                slope=np.append(np.zeros(form.size) if block.slope is None else block.slope, 1.0),
            )
            for block in form.blocks
        ),
        lift=form.lift + 1,
    )
    rows, offsets, cones = cone_rows(raised, raised.size, 0)
    fixed = np.eye(form.dim, raised.size)
    cost = np.zeros(raised.size)
    cost[-1] = 1.0
    cones = [clarabel.ZeroConeT(form.dim), *cones]
    return solved(cost, np.concatenate([fixed, rows]), np.concatenate([-x, offsets]), cones)


def excess(form: ConicForm, x: Array) -> Array:
    if not form.lift:
        return form.excess(x)
    return np.array([lifted_excess(form, one) for one in x])


def check_same_set(form: ConicForm, shape: ConvexSet, x: Array) -> None:
    height, within = level(shape, x), 1e-6 if form.lift else 1e-9
    clear = np.abs(height) > within
    np.testing.assert_array_equal((excess(form, x) <= 0.0)[clear], (height <= 0.0)[clear])


def check_dual(form: ConicForm, shape: ConvexSet, n: Array) -> None:
    for one in n:
        known = float(shape.support(one)[0])
        if np.isfinite(known):
            for found in (dual_support(form, one), solved_support(form, one)):
                assert found == pytest.approx(known, abs=SOLVER_TOLERANCE, rel=SOLVER_TOLERANCE)


def test_agrees_with_the_level(conic: ConvexSet, rng: np.random.Generator) -> None:
    form = conic_form(conic)
    tried = 60 if form.lift else 2000
    x = rng.uniform(-1.2, 1.2, size=(tried, conic.dim)) * max(size(conic), 1.0)
    on_axis = x * (rng.uniform(size=x.shape) < 0.5)
    check_same_set(form, conic, np.concatenate([x, on_axis]))


def test_boundary_is_the_same(conic: ConvexSet, directions: Draw) -> None:
    form, within = conic_form(conic), 10.0 * rounding(conic)
    point = conic.support(directions(8 if form.lift else 100, conic.dim))[1]
    within = max(within, SOLVER_TOLERANCE if form.lift else 0.0)
    np.testing.assert_allclose(excess(form, point), 0.0, atol=within)


def test_dual_gives_the_support_value(conic: ConvexSet, rng: np.random.Generator) -> None:
    n = np.concatenate([np.eye(conic.dim), -np.eye(conic.dim), rng.normal(size=(8, conic.dim))])
    check_dual(conic_form(conic), conic, n)


def test_a_form_with_helping_variables_has_no_excess(conic: ConvexSet) -> None:
    form = conic_form(conic)
    if form.lift:
        with pytest.raises(CapabilityError, match="helping variables"):
            form.excess(np.zeros((1, conic.dim)))


def test_has_the_dimension_of_its_set(conic: ConvexSet) -> None:
    form = conic_form(conic)
    assert form.dim == conic.dim
    assert form.linear_A.shape == (len(form.linear_b), form.size)
    for block in form.blocks:
        assert block.A.shape == (len(block.b), form.size)
        assert block.slope is None or block.slope.shape == (form.size,)


def test_the_checks_notice_a_missing_block(rng: np.random.Generator) -> None:
    shape = Cylinder(1.0, 2.0)
    form = conic_form(shape)
    blocks = (replace(form.blocks[0], head=1.9), form.blocks[1])
    with pytest.raises(AssertionError):
        check_same_set(replace(form, blocks=blocks), shape, rng.uniform(-2, 2, size=(2000, 3)))
    with pytest.raises(AssertionError):
        check_dual(replace(form, blocks=blocks), shape, rng.normal(size=(3, 3)))


def test_the_checks_notice_a_missing_slope(rng: np.random.Generator) -> None:
    shape = Cone(0.8, 1.0)
    form = conic_form(shape)
    straight = replace(form, blocks=(replace(form.blocks[0], slope=None),))
    with pytest.raises(AssertionError):
        check_same_set(straight, shape, rng.uniform(-2, 2, size=(2000, 3)))


def test_the_checks_notice_a_wrong_helping_variable(rng: np.random.Generator) -> None:
    shape = Capsule(0.4, 1.0)
    form = conic_form(shape)
    longer = replace(form, blocks=(form.blocks[0], replace(form.blocks[1], head=1.1)))
    with pytest.raises(AssertionError):
        check_same_set(longer, shape, np.array([[1.45, 0.0, 0.0]]))
    with pytest.raises(AssertionError):
        check_dual(longer, shape, np.array([[1.0, 0.0, 0.0]]))
