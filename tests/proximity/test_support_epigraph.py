"""Epigraphs bound the support function from above, and reach it, whatever the shape."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np
import pytest

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capsule import Capsule
from berthing.geometry.cone import Cone
from berthing.geometry.conic_form import ConicForm, SecondOrderBlock
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.intersection import Intersection
from berthing.geometry.offset import Offset
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.sphere import Sphere
from berthing.geometry.superellipsoid import Superellipsoid
from berthing.geometry.truncated_cone import TruncatedCone
from berthing.proximity.support_epigraph import (
    BlockEpigraph,
    ConicEpigraph,
    Epigraph,
    VertexEpigraph,
    support_epigraph,
)

ROUNDING = 1e-12
# Of multipliers that a cone solver found, and of what they add up to.
SOLVED = 1e-8

TRIANGLE = Polytope.from_vertices([[0.5, 0.0], [2.0, 0.3], [1.0, 1.5]])
BLOCKS: dict[str, ConvexSet] = {
    "capsule": Capsule(0.4, 1.0, "z"),
    "stadium": Capsule(0.4, 1.0, "y", dim=2),
    "padded-box": Offset(Box([1.0, 0.5, 0.2]), 0.3),
    "padded-capsule": Offset(Capsule(0.4, 1.0), 0.2),
}
CONES: dict[str, ConvexSet] = {
    "cone": Cone(0.8, 1.0, "y"),
    "lampshade": TruncatedCone(0.5, 1.0, 0.4, "z"),
    "padded-triangle": Offset(TRIANGLE, 0.2),
    "paper-cylinder": Superellipsoid([2.0, 1.0, 1.0], [8, 2, 2]),
    "cut-cylinder": Intersection([Cylinder(1.0, 1.5), HalfSpace([1.0, 1.0, 0.5], 1.0)]),
    "lens": Intersection(
        [Sphere(1.0, dim=2), Sphere(1.0, dim=2)],
        [Pose.planar(np.array([x, 0.0]), 0.0) for x in (0.5, -0.5)],
    ),
}


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


@pytest.mark.parametrize("known", BLOCKS.values(), ids=BLOCKS.keys())
def test_helping_variables_leave_one_multiplier_a_block(known: ConvexSet, rng) -> None:
    epigraph = support_epigraph(known)
    assert isinstance(epigraph, BlockEpigraph)
    check(known, rng)


@pytest.mark.parametrize("known", CONES.values(), ids=CONES.keys())
def test_any_conic_form_has_multipliers_that_reach_the_support_function(
    known: ConvexSet, rng
) -> None:
    epigraph = support_epigraph(known)
    assert isinstance(epigraph, ConicEpigraph)
    m = np.concatenate([np.eye(known.dim), 10.0 * rng.normal(size=(6, known.dim))])
    starts = epigraph.start(m)
    assert starts.shape == (len(m), epigraph.size)
    for direction, multipliers in zip(m, starts, strict=True):
        value, rows, lower = evaluated(epigraph, multipliers, direction)
        within = SOLVED * np.linalg.norm(direction)
        ties = epigraph.form.size
        np.testing.assert_allclose(rows[:ties], 0.0, atol=within)
        assert np.all(rows[ties:] >= lower[ties:] - within * np.linalg.norm(direction))
        assert value == pytest.approx(float(known.support(direction)[0]), abs=10.0 * within)


@pytest.mark.parametrize("known", CONES.values(), ids=CONES.keys())
def test_no_multipliers_say_less_than_the_support_function(known: ConvexSet, rng) -> None:
    """The value is minimised over the rows, from multipliers of another direction."""
    epigraph = support_epigraph(known)
    m, other = rng.normal(size=(2, known.dim))
    v = ca.SX.sym("v", epigraph.size)
    rows = epigraph.rows(v, ca.DM(m))
    ipopt = {"print_level": 0, "sb": "yes", "tol": 1e-9, "bound_relax_factor": 0.0}
    options = {"print_time": False} | {f"ipopt.{key}": value for key, value in ipopt.items()}
    solver = ca.nlpsol("h", "ipopt", {"x": v, "f": rows.value, "g": rows.expression}, options)
    found = solver(x0=epigraph.start(other), lbg=rows.lower, ubg=rows.upper)
    assert float(found["f"]) == pytest.approx(float(known.support(m)[0]), abs=1e-5)


def test_a_half_space_has_one_multiplier_and_no_value_off_its_normal() -> None:
    epigraph = support_epigraph(HalfSpace([0.0, 0.6, 0.8], 2.0))
    assert epigraph.size == 1
    along = np.array([0.0, 1.2, 1.6])
    value, rows, _ = evaluated(epigraph, epigraph.start(along), along)
    assert value == pytest.approx(4.0)
    np.testing.assert_allclose(rows[:3], 0.0, atol=ROUNDING)
    aside = np.array([1.0, 0.6, 0.8])
    _, rows, _ = evaluated(epigraph, epigraph.start(aside), aside)
    assert np.max(np.abs(rows[:3])) > 0.5


def test_at_direction_zero_cones_have_no_multipliers() -> None:
    for shape in CONES.values():
        epigraph = support_epigraph(shape)
        assert not epigraph.start(np.zeros(shape.dim)).any()


SMOOTHED = SmoothedPolytope.inner(Box([1.0, 1.0, 1.0]), 8.0)


@pytest.mark.parametrize(
    "without", [SMOOTHED, Offset(SMOOTHED, 0.1), Superellipsoid([1.0, 1.0], [6])],
    ids=["smoothed", "padded", "sixth powers"],
)  # fmt: skip
def test_a_set_without_either_form_is_told_what_would_do(without: ConvexSet) -> None:
    with pytest.raises(CapabilityError) as caught:
        support_epigraph(without)
    message = str(caught.value)
    for name in (type(without).__name__, "Box", "Capsule", "Polytope", "powers of two", "`kkt`"):
        assert name in message


def test_vertices_are_the_way_out_where_the_conic_form_is_not_square() -> None:
    @dataclass(frozen=True, eq=False)
    class Cut(Capped):
        def vertices(self) -> Array:
            return np.eye(3)

    epigraph = support_epigraph(Cut(np.zeros(3), 1.0))
    assert isinstance(epigraph, VertexEpigraph)
    assert isinstance(support_epigraph(OffCentreBall(np.zeros(3), 1.0)), BlockEpigraph)
