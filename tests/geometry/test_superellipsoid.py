"""The paper's superellipsoid: values known in closed form, and bad exponents."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import CapabilityError, InputError
from berthing.geometry.capability import conic_form
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.superellipsoid import Superellipsoid

PAPER_CYLINDER = Superellipsoid([2.0, 1.0, 1.0], [8, 2, 2])


def test_level_is_the_papers_function() -> None:
    """f_T2 of Scenario A: (x/2)⁸ + y² + z² − 1."""
    for x, y, z in np.random.default_rng(1).uniform(-2, 2, size=(50, 3)):
        printed = (x / 2) ** 8 + y**2 + z**2 - 1
        assert PAPER_CYLINDER.level(np.array([x, y, z])) == pytest.approx(printed, abs=1e-12)


def test_it_is_slimmer_than_the_cylinder_near_its_ends() -> None:
    """Radius 0.755 m at x = 1.8 m, where the cylinder's is 1."""
    radius = np.sqrt(1.0 - 0.9**8)
    assert radius == pytest.approx(0.755, abs=5e-4)
    assert PAPER_CYLINDER.level(np.array([1.8, radius, 0.0])) == pytest.approx(0.0, abs=1e-12)
    true = Cylinder(1.0, 2.0)
    n = np.random.default_rng(2).normal(size=(500, 3))
    assert np.all(PAPER_CYLINDER.support(n)[0] <= true.support(n)[0] + 1e-12)


@pytest.mark.parametrize("exponent", [2, 4, 10, 100])
@pytest.mark.parametrize("semi_axes", [[1.0, 2.0], [1.0, 2.0, 0.3]])
def test_equal_exponents_give_the_dual_norm(exponent: int, semi_axes: list[float]) -> None:
    shape = Superellipsoid(semi_axes, exponent)
    n = np.random.default_rng(3).normal(size=(200, len(semi_axes)))
    q = exponent / (exponent - 1.0)
    dual = np.sum(np.abs(n * semi_axes) ** q, axis=1) ** (1.0 / q)
    np.testing.assert_allclose(shape.support(n)[0], dual, rtol=1e-13)


def test_exponents_of_two_are_an_ellipsoid() -> None:
    shape, known = Superellipsoid([1.0, 2.0, 0.5], 2), Ellipsoid([1.0, 2.0, 0.5])
    n = np.random.default_rng(4).normal(size=(100, 3))
    np.testing.assert_allclose(shape.support(n)[1], known.support(n)[1], atol=1e-14)
    assert shape.bounding_radius == pytest.approx(2.0)
    assert len(conic_form(shape).blocks) == 1
    assert conic_form(shape).lift == 0


def test_the_right_side_scales_each_axis_by_its_own_power() -> None:
    shape = Superellipsoid([2.0, 1.0], [8, 2], size=1.5, size_exponent=4)
    assert shape.bound == pytest.approx(1.5**4)
    np.testing.assert_allclose(shape.reaches, [2.0 * 1.5**0.5, 1.5**2])
    np.testing.assert_allclose(shape.support(np.array([1.0, 0.0]))[1], [shape.reaches[0], 0.0])


RADII = [
    (PAPER_CYLINDER, 2.0),
    (Superellipsoid([1.0, 1.0], 4), 2.0**0.25),
    (Superellipsoid([1.0, 1.0, 1.0], 6), np.sqrt(3.0) * 3.0 ** (-1 / 6)),
    (Superellipsoid([1.0, 3.0, 2.0], 2), 3.0),
]


@pytest.mark.parametrize(("shape", "radius"), RADII)
def test_bounding_radius(shape: Superellipsoid, radius: float) -> None:
    assert shape.bounding_radius == pytest.approx(radius, rel=1e-12)


def test_a_bounding_radius_between_the_axes() -> None:
    """Found by brute force: the long flat axis takes what the others leave."""
    shape = Superellipsoid([2.0, 1.8, 1.5], [8, 2, 4])
    t = np.random.default_rng(0).dirichlet(np.ones(3) * 0.7, size=400_000)
    squares = np.sum(shape.semi_axes**2 * t ** (2.0 / shape.exponents), axis=1)
    assert shape.bounding_radius == pytest.approx(np.sqrt(squares.max()), rel=1e-4)
    assert shape.bounding_radius >= np.sqrt(squares.max())


def test_only_powers_of_two_have_a_conic_form() -> None:
    assert conic_form(PAPER_CYLINDER).lift == 4
    with pytest.raises(CapabilityError, match=r"exponents \[6, 2\] has no conic form"):
        conic_form(Superellipsoid([1.0, 1.0], [6, 2]))


BAD = [
    (lambda: Superellipsoid([1.0, 1.0], 3), r"exponents\[0\]: is 3 \(expected an even number"),
    (lambda: Superellipsoid([1.0, 1.0], [2, 0]), r"exponents\[1\]: is 0"),
    (lambda: Superellipsoid([1.0, 1.0], [2, 2.5]), r"exponents\[1\]: is 2.5"),
    (lambda: Superellipsoid([1.0, 1.0], [2, 2, 2]), "exponents: has the shape 3"),
    (lambda: Superellipsoid([1.0, 1.0], "two"), "exponents: is not an array of numbers"),
    (lambda: Superellipsoid([1.0, -1.0], 2), r"semi_axes\[1\]: is -1"),
    (lambda: Superellipsoid([1.0, 1.0], 2, size=0.0), "Superellipsoid.size: is 0"),
    (lambda: Superellipsoid([1.0, 1.0], 2, 1.0, np.inf), "size_exponent: is inf"),
]


@pytest.mark.parametrize(("make", "message"), BAD)
def test_bad_input_is_refused(make, message: str) -> None:
    with pytest.raises(InputError, match=message):
        make()
