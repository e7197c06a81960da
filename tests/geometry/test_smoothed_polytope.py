"""The smoothed polytope: the paper's function, which side it lies on, and how far off it is."""

from __future__ import annotations

from math import log

import numpy as np
import pytest

from berthing.errors import CapabilityError, InputError
from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capability import halfspaces, level, vertices
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.polytope import Polytope
from berthing.geometry.smoothed_polytope import SmoothedPolytope
from berthing.geometry.sphere import Sphere
from support.shapes import WEDGE

SPACECRAFT = Box([2.0, 1.0, 1.0])
PYRAMID = Polytope.from_vertices([[1, 1, 0], [1, -1, 0], [-1, 1, 0], [-1, -1, 0], [0, 0, 1.5]])
MODELLED = {"box": SPACECRAFT, "square": Box([1.0, 1.0]), "wedge": WEDGE, "pyramid": PYRAMID}


@pytest.fixture(params=MODELLED.values(), ids=MODELLED.keys())
def polytope(request: pytest.FixtureRequest) -> ConvexSet:
    return request.param


def unit_directions(dim: int, count: int = 2000) -> Array:
    n = np.random.default_rng(5).normal(size=(count, dim))
    return n / np.linalg.norm(n, axis=1, keepdims=True)


def recession(model: ConvexSet, corner: Array, direction: Array) -> float:
    """How far from ``corner`` along ``direction`` the model begins, by bisection."""
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        inside = level(model, corner - middle * direction) <= 0.0
        low, high = (low, middle) if inside else (middle, high)
    return high


def test_level_is_the_papers_function() -> None:
    """f_S of Scenario A, written out."""
    model = SmoothedPolytope.inner(SPACECRAFT, 8.0)
    for x, y, z in np.random.default_rng(1).uniform(-3, 3, size=(50, 3)):
        terms = [x - 2, y - 1, z - 1, -x - 2, -y - 1, -z - 1]
        printed = log(sum(np.exp(8 * f) for f in terms) ** (1 / 8))
        assert model.level(np.array([x, y, z])) == pytest.approx(printed, abs=1e-12)


def test_level_does_not_overflow() -> None:
    model = SmoothedPolytope.inner(SPACECRAFT, 1000.0)
    assert model.level(np.array([1e6, 0.0, 0.0])) == pytest.approx(1e6 - 2.0)
    assert model.level(np.zeros(3)) == pytest.approx(-1.0, abs=0.01)


def test_exponents_of_faces_level_and_base() -> None:
    A, b = halfspaces(Box([1.0, 2.0]))
    Q = np.array([5.0, 9.0, 7.0, 11.0])
    x = np.array([0.9, 1.5])
    f = A @ x - b
    natural = SmoothedPolytope(A, b, Q, level_exponent=4.0)
    assert natural.level(x) == pytest.approx(np.log(np.sum(np.exp(Q * f))) / 4.0)
    binary = SmoothedPolytope(A, b, Q, level_exponent=4.0, base=2.0)
    assert binary.level(x) == pytest.approx(np.log2(np.sum(2.0 ** (Q * f))) / 4.0)
    # Q_{m+1} moves nothing, and another base does what other exponents do.
    again = SmoothedPolytope(A, b, Q * log(2.0))
    n = unit_directions(2, 50)
    np.testing.assert_allclose(binary.support(n)[0], again.support(n)[0], atol=1e-12)


def test_recession_at_exponent_8() -> None:
    """ln 1, ln 2 and ln 3 over 8 along each normal: face, edge and corner of the spacecraft."""
    model = SmoothedPolytope.inner(SPACECRAFT, 8.0)
    ones = np.array([1.0, 1.0, 1.0])
    corner = recession(model, np.array([2.0, 1.0, 1.0]), ones)
    edge = recession(model, np.array([0.0, 1.0, 1.0]), ones * [0, 1, 1])
    face = recession(model, np.array([0.0, 0.0, 1.0]), ones * [0, 0, 1])
    assert corner == pytest.approx(log(3.0) / 8.0, abs=1e-5)
    assert corner == pytest.approx(0.137, abs=5e-4)
    assert edge == pytest.approx(log(2.0) / 8.0, abs=1e-5)
    assert edge == pytest.approx(0.087, abs=5e-4)
    assert face < 1e-3
    # From corner to corner it is √3 times as far, and the bound says so to the last digit.
    assert model.error_m == pytest.approx(np.sqrt(3.0) * corner, abs=1e-9)


@pytest.mark.parametrize("exponent", [8.0, 60.0, 1000.0])
def test_inner_lies_inside_and_recedes_no_further_than_stated(
    polytope: ConvexSet, exponent: float
) -> None:
    model = SmoothedPolytope.inner(polytope, exponent)
    A, b = halfspaces(polytope)
    n = unit_directions(polytope.dim)
    point = model.support(n)[1]
    assert np.max(point @ A.T - b) < 1e-12
    # All points at least ln(m)/Q inside every face are members.
    deep = Polytope(A, b - log(len(b)) / exponent) if exponent > 8.0 else None
    if deep is not None:
        assert np.max(model.level(deep.vertices())) <= 1e-12
    farthest = np.max(polytope.support(n)[0] - model.support(n)[0])
    assert farthest <= model.error_m + 1e-9
    assert farthest >= 0.8 * model.error_m


@pytest.mark.parametrize("exponent", [8.0, 60.0, 1000.0])
def test_outer_contains_the_polytope_and_bulges_no_further_than_stated(
    polytope: ConvexSet, exponent: float
) -> None:
    model = SmoothedPolytope.outer(polytope, exponent)
    assert np.max(model.level(vertices(polytope))) <= 0.0
    assert np.max(model.level(vertices(polytope))) >= -1e-12
    A, b = halfspaces(polytope)

    def beyond(n: Array) -> Array:
        return model.support(n)[0] - polytope.support(n)[0]

    tried = np.concatenate([unit_directions(polytope.dim), A])
    for spread in (0.1, 0.03, 0.01):
        best = tried[np.argmax(beyond(tried))]
        near = best + spread * unit_directions(polytope.dim, 200)
        tried = np.vstack([near / np.linalg.norm(near, axis=1, keepdims=True), best])
    farthest = np.max(beyond(tried))
    assert farthest <= model.error_m <= 1.005 * farthest
    bulge = np.max(beyond(A))
    assert bulge <= model.shift_m + 1e-12 <= log(len(b)) / exponent + 1e-9


def test_outer_of_a_box_bulges_by_ln_3_over_the_exponent() -> None:
    model = SmoothedPolytope.outer(SPACECRAFT, 8.0)
    assert model.shift_m == pytest.approx(log(3.0) / 8.0, abs=1e-5)
    assert (model.side, SmoothedPolytope.inner(SPACECRAFT, 8.0).side) == ("outer", "inner")


@pytest.mark.parametrize("side", ["inner", "outer"])
@pytest.mark.parametrize("error_m", [0.1, 0.01, 0.001])
def test_exponent_follows_from_the_error_allowed(
    polytope: ConvexSet, side: str, error_m: float
) -> None:
    model = SmoothedPolytope.for_error(polytope, error_m, side)
    assert model.side == side
    assert 0.97 * error_m <= model.error_m <= error_m


@pytest.mark.parametrize("side", ["inner", "outer"])
def test_an_error_larger_than_the_polytope_is_no_trouble(side: str) -> None:
    assert SmoothedPolytope.for_error(Box([0.05, 0.05, 0.05]), 1.0, side).error_m <= 1.0


def test_a_cube_below_ln_6_over_8_is_empty() -> None:
    half = log(6.0) / 8.0
    SmoothedPolytope.inner(Box(np.full(3, 1.01 * half)), 8.0)
    with pytest.raises(InputError, match=r"is empty: .*too small for an exponent of 8 per metre"):
        SmoothedPolytope.inner(Box(np.full(3, 0.99 * half)), 8.0)
    SmoothedPolytope.outer(Box(np.full(3, 0.1 * half)), 8.0)


def test_the_exponent_that_the_error_names_is_enough() -> None:
    tiny = Box([0.01, 0.3, 0.2])
    with pytest.raises(InputError) as caught:
        SmoothedPolytope.inner(tiny, 8.0)
    named = float(caught.value.expected.split("such as ")[1].split()[0])
    SmoothedPolytope.inner(tiny, named)


@pytest.mark.parametrize("exponent", [8.0, 300.0, 1e4])
@pytest.mark.parametrize("count", [12, 40])
def test_many_faces_that_nearly_meet_do_not_lead_astray(count: int, exponent: float) -> None:
    """Directions of faces, edges and next to them, where the boundary is all but flat."""
    rng = np.random.default_rng(count)
    rows = rng.normal(size=(count, 3))
    rows = np.concatenate([rows, -rows]) / np.linalg.norm(np.tile(rows, (2, 1)), axis=1)[:, None]
    model = SmoothedPolytope(rows, np.ones(len(rows)), exponent)
    beside = rows[:, None] + np.array([0.0, 1e-3, 1e-8])[None, :, None] * rng.normal(size=(1, 3, 3))
    between = rows + np.roll(rows, 1, axis=0)
    n = np.concatenate([beside.reshape(-1, 3), between])
    n = n / np.linalg.norm(n, axis=1, keepdims=True)
    value, point = model.support(n)
    np.testing.assert_allclose(np.sum(n * point, axis=1), value, atol=1e-9)
    on = model.hill.boundary(rng.normal(size=(2000, 3)))
    assert np.max(n @ on.T - value[:, None]) <= 1e-12


BAD = [
    (lambda: SmoothedPolytope(np.eye(3), np.ones(3), 8.0), "SmoothedPolytope: is unbounded"),
    (lambda: SmoothedPolytope(np.eye(3), np.ones(2), 8.0), "SmoothedPolytope.b: has the shape 2"),
    (lambda: SmoothedPolytope.inner(SPACECRAFT, 0.0), "SmoothedPolytope.exponents: is 0"),
    (lambda: SmoothedPolytope.inner(SPACECRAFT, np.nan), "SmoothedPolytope.exponents: is nan"),
    (lambda: SmoothedPolytope.inner(SPACECRAFT, "big"), "SmoothedPolytope.exponents: is 'big'"),
    (lambda: SmoothedPolytope.inner(SPACECRAFT, [8.0, 8.0]), r"exponents: has the shape \(2,\)"),
    (lambda: SmoothedPolytope.inner(SPACECRAFT, [8.0] * 5 + [-1.0]), r"exponents\[5\]: is -1"),
    (lambda: SmoothedPolytope.inner(SPACECRAFT, 8.0, 0.0), "level_exponent: is 0"),
    (lambda: SmoothedPolytope.inner(SPACECRAFT, 8.0, base=1.0), "SmoothedPolytope.base: is 1"),
    (lambda: SmoothedPolytope.for_error(SPACECRAFT, 0.0, "inner"), "error_m: is 0"),
    (lambda: SmoothedPolytope.for_error(SPACECRAFT, 0.1, "upper"), "side: is 'upper'"),
]


@pytest.mark.parametrize(("make", "message"), BAD)
def test_bad_input_is_refused(make, message: str) -> None:
    with pytest.raises(InputError, match=message):
        make()


def test_only_sets_with_half_spaces_have_a_model() -> None:
    with pytest.raises(CapabilityError, match="Sphere has no finite set of half-spaces"):
        SmoothedPolytope.inner(Sphere(1.0), 8.0)
