"""Lobatto points and weights, and the two schemes made of them."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.polynomial import Legendre

from berthing.errors import InputError
from berthing.transcription.lgl import lobatto
from berthing.transcription.mesh import Mesh
from berthing.transcription.scheme import scheme
from berthing.transcription.sites import node_sites

COUNTS = [2, 3, 4, 5, 8, 13, 21, 41]

ROUNDING = 1e-13
"""Of sums of some forty terms of order one."""


def integral(power: int) -> float:
    return 2.0 / (power + 1) if power % 2 == 0 else 0.0


@pytest.mark.parametrize("n", COUNTS)
def test_quadrature_is_exact_up_to_degree_2n_minus_3(n) -> None:
    points, weights = lobatto(n)
    for power in range(2 * n - 2):
        assert weights @ points**power == pytest.approx(integral(power), abs=ROUNDING)


@pytest.mark.parametrize("n", [2, 3, 4, 5, 8])
def test_quadrature_is_not_exact_beyond(n) -> None:
    points, weights = lobatto(n)
    power = 2 * n - 2
    assert abs(weights @ points**power - integral(power)) > 1e-5


@pytest.mark.parametrize("n", COUNTS)
def test_points_rise_from_end_to_end_and_mirror(n) -> None:
    points, weights = lobatto(n)
    assert (points[0], points[-1]) == (-1.0, 1.0)
    assert np.all(np.diff(points) > 0.0)
    assert np.all(weights > 0.0)
    np.testing.assert_array_equal(points, -points[::-1])
    np.testing.assert_allclose(weights, weights[::-1], rtol=1e-12)


def test_the_first_few_are_those_of_the_books() -> None:
    points, weights = lobatto(4)
    np.testing.assert_allclose(points, [-1, -1 / np.sqrt(5), 1 / np.sqrt(5), 1], atol=1e-15)
    np.testing.assert_allclose(weights, np.array([1, 5, 5, 1]) / 6, atol=1e-15)
    points, weights = lobatto(5)
    root = np.sqrt(3 / 7)
    np.testing.assert_allclose(points, [-1, -root, 0, root, 1], atol=1e-15)
    np.testing.assert_allclose(weights, np.array([9, 49, 64, 49, 9]) / 90, atol=1e-15)


def test_one_point_is_refused() -> None:
    with pytest.raises(InputError, match="at least two"):
        lobatto(1)


def legendre_slope(n: int, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """P'_n and P''_n by the three-term recurrence, which Legendre series are not summed by."""
    before, now = np.ones_like(x), x
    for k in range(1, n):
        before, now = now, ((2 * k + 1) * x * now - k * before) / (k + 1)
    slope = n * (before - x * now) / (1 - x**2)
    return slope, (2 * x * slope - n * (n + 1) * now) / (1 - x**2)


@pytest.mark.parametrize("degree", [40, 60])
def test_many_points_are_roots_to_rounding(degree) -> None:
    inner = lobatto(degree + 1)[0][1:-1]
    assert len(inner) == degree - 1
    slope, bend = legendre_slope(degree, inner)
    # The Newton step that is left: the error of the point itself.
    assert np.max(np.abs(slope / bend)) < 5e-15


@pytest.mark.parametrize("name", ["lgl", "lgl-global"])
@pytest.mark.parametrize("degree", [1, 2, 3, 6, 12, 40])
def test_differentiation_is_exact_for_the_degree_of_the_points(name, degree) -> None:
    nodes = scheme(name)(degree)
    poly = Legendre(np.random.default_rng(degree).normal(size=degree + 1))
    exact = poly.deriv()(nodes.points)
    # Entries of D grow as the square of the degree, and roundings with them.
    atol = ROUNDING * degree**2 * np.max(np.abs(exact))
    np.testing.assert_allclose(nodes.D @ poly(nodes.points), exact, atol=atol)
    beyond = Legendre.basis(degree + 1)
    gap = nodes.D @ beyond(nodes.points) - beyond.deriv()(nodes.points)
    assert np.max(np.abs(gap)) > 1.0


@pytest.mark.parametrize("degree", [1, 3, 8, 20])
def test_the_differentiation_matrix_lacks_one_rank(degree) -> None:
    """Constants have no slope: the last singular value is rounding, the one before is not."""
    values = np.linalg.svd(scheme("lgl-global")(degree).D, compute_uv=False)
    assert values[-1] < 1e-12 * values[0]
    assert values[-2] > 1e-4 * values[0]


@pytest.mark.parametrize("degree", [1, 3, 6, 20])
def test_both_ends_are_collocated(degree) -> None:
    nodes = scheme("lgl")(degree)
    assert nodes.collocated == tuple(range(degree + 1))
    np.testing.assert_array_equal(nodes.control_points, nodes.points)
    expected = np.zeros(degree + 1)
    expected[[0, -1]] = -1.0, 1.0
    np.testing.assert_allclose(nodes.weights @ nodes.D, expected, atol=1e-12)


def test_one_segment_takes_the_papers_number_of_nodes() -> None:
    mesh = Mesh.of_nodes("lgl-global", None, 10, 4)
    assert (mesh.segments, mesh.control_count) == (1, 20)
    assert Mesh.of_nodes("lgl-global", 33, 10, 4).control_count == 33
    assert mesh.split({0}) == mesh


def test_segments_share_their_points_but_have_controls_of_their_own() -> None:
    mesh = Mesh.of_nodes("lgl", None, 10, 4)
    assert (mesh.segments, mesh.point_count, mesh.control_count) == (10, 41, 50)
    assert Mesh.of_nodes("lgl", 20, 10, 4).control_count == 20
    assert mesh.split({3}).segments == 11
    # Both ends being collocated, a place that two segments share is a site of one of them.
    places = [mesh.fraction(site.segment, site.s) for site in node_sites(mesh, 1)]
    np.testing.assert_allclose(places, mesh.point_fractions()[1:], atol=1e-15)
