"""Epigraphs bound the support function from above, and reach it."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np
import pytest

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.conic_form import ConicForm, SecondOrderBlock
from berthing.geometry.convex_set import ConvexSet
from berthing.proximity.support_epigraph import (
    BlockEpigraph,
    Epigraph,
    VertexEpigraph,
    support_epigraph,
)

ROUNDING = 1e-12


@dataclass(frozen=True, eq=False)
class OffCentreBall(ConvexSet):
    """{x : ‖x + b‖ ≤ r}: a block with an offset, which none of the shapes has."""

    b: Array
    radius: float

    @property
    def dim(self) -> int:
        return len(self.b)

    @property
    def bounding_radius(self) -> float:
        return float(np.linalg.norm(self.b)) + self.radius

    def support(self, n: Array) -> tuple[Array, Array]:
        length = np.linalg.norm(n, axis=-1, keepdims=True)
        point = -self.b + self.radius * n / length
        return np.sum(n * point, axis=-1), point

    def conic_form(self) -> ConicForm:
        block = SecondOrderBlock(self.radius, np.eye(self.dim), self.b)
        return ConicForm(self.dim, np.zeros((0, self.dim)), np.zeros(0), (block,))


@dataclass(frozen=True, eq=False)
class Capped(OffCentreBall):
    """A ball cut by a plane: linear rows leave μ undetermined."""

    def conic_form(self) -> ConicForm:
        blocks = super().conic_form().blocks
        return ConicForm(self.dim, np.eye(self.dim)[:1], np.ones(1), blocks)


@dataclass(frozen=True, eq=False)
class Lens(OffCentreBall):
    """Two balls' intersection: the tails do not stack to a square matrix."""

    def conic_form(self) -> ConicForm:
        block = super().conic_form().blocks[0]
        return ConicForm(self.dim, np.zeros((0, self.dim)), np.zeros(0), (block, block))


def evaluated(epigraph: Epigraph, tau: Array, m: Array) -> tuple[float, Array, Array]:
    rows = epigraph.rows(ca.DM(tau), ca.DM(m))
    return float(rows.value), np.asarray(ca.DM(rows.expression)).ravel(), rows.lower


def check(shape: ConvexSet, rng: np.random.Generator) -> None:
    epigraph = support_epigraph(shape)
    directions = np.concatenate(
        [np.eye(shape.dim), -np.eye(shape.dim), rng.normal(size=(6, shape.dim))]
    )
    starts = epigraph.start(directions)
    assert starts.shape == (len(directions), epigraph.size)
    for m, tau in zip(directions, starts, strict=True):
        h = float(shape.support(m)[0])
        value, rows, lower = evaluated(epigraph, tau, m)
        assert np.all(rows >= lower - ROUNDING)
        assert value == pytest.approx(h, abs=1e-12)
        larger = tau + rng.uniform(0.0, 1.0, size=epigraph.size)
        value, rows, lower = evaluated(epigraph, larger, m)
        assert np.all(rows >= lower - ROUNDING)
        assert value >= h - ROUNDING


def test_value_is_above_the_support_function_and_reaches_it(shape, rng) -> None:
    check(shape, rng)


def test_blocks_may_have_an_offset(rng) -> None:
    check(OffCentreBall(np.array([0.5, -1.0, 0.2]), 0.7), rng)


def test_less_than_the_least_multiplier_is_infeasible(shape, rng) -> None:
    epigraph = support_epigraph(shape)
    m = rng.normal(size=shape.dim)
    tau = epigraph.start(m)
    for i in range(epigraph.size):
        less = tau.copy()
        less[i] -= 0.05
        _, rows, lower = evaluated(epigraph, less, m)
        assert np.min(rows - lower) < -1e-4


def test_a_negative_multiplier_is_no_way_around_the_square(shape) -> None:
    epigraph = support_epigraph(shape)
    if isinstance(epigraph, VertexEpigraph):
        assert epigraph.size == 1
        return
    m = np.ones(shape.dim)
    _, rows, lower = evaluated(epigraph, -epigraph.start(m), m)
    assert np.min(rows - lower) < -0.1


def test_at_direction_zero_everything_is_zero(shape) -> None:
    epigraph = support_epigraph(shape)
    tau = epigraph.start(np.zeros(shape.dim))
    value, rows, lower = evaluated(epigraph, tau, np.zeros(shape.dim))
    assert value == 0.0
    assert np.all(rows >= lower)


def test_a_set_without_either_form_is_told_what_would_do() -> None:
    for shape in (Capped(np.zeros(3), 1.0), Lens(np.zeros(3), 1.0)):
        with pytest.raises(CapabilityError) as caught:
            support_epigraph(shape)
        message = str(caught.value)
        for name in (type(shape).__name__, "Box", "Sphere", "Ellipsoid", "Cylinder", "Polytope"):
            assert name in message


def test_vertices_are_the_way_out_where_the_conic_form_is_not_square() -> None:
    @dataclass(frozen=True, eq=False)
    class Cut(Capped):
        def vertices(self) -> Array:
            return np.eye(3)

    epigraph = support_epigraph(Cut(np.zeros(3), 1.0))
    assert isinstance(epigraph, VertexEpigraph)
    assert isinstance(support_epigraph(OffCentreBall(np.zeros(3), 1.0)), BlockEpigraph)
