"""Superellipsoids in and around a cylinder, and how far off they are."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry import smoothed_cylinder
from berthing.geometry.arrays import Array
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.smoothed_cylinder import error, for_error, inner, outer

CYLINDERS = [Cylinder(1.0, 2.0), Cylinder(0.3, 4.0, "y"), Cylinder(2.0, 0.1, "z")]


@pytest.fixture(params=CYLINDERS, ids=["paper", "rod", "disc"])
def cylinder(request: pytest.FixtureRequest) -> Cylinder:
    return request.param


def meridian(cylinder: Cylinder, count: int = 20_000) -> Array:
    """Unit directions (count, 3) from the axis to across it."""
    angle = np.linspace(0.0, 0.5 * np.pi, count)
    n = np.zeros((count, 3))
    n[:, cylinder.axis_index], n[:, (cylinder.axis_index + 1) % 3] = np.cos(angle), np.sin(angle)
    return n


def rim(cylinder: Cylinder) -> Array:
    angle = np.linspace(0.0, 2.0 * np.pi, 100)
    ring = cylinder.radius * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    return np.insert(ring, cylinder.axis_index, cylinder.half_length, axis=1)


def test_inner_is_the_papers_and_lies_inside() -> None:
    model = inner(CYLINDERS[0], 8)
    assert model.exponents.tolist() == [8, 2, 2]
    assert model.semi_axes.tolist() == [2.0, 1.0, 1.0]
    assert model.bound == 1.0


@pytest.mark.parametrize("exponent", [2, 8, 100, 1000])
def test_inner_error(cylinder: Cylinder, exponent: int) -> None:
    model, n = inner(cylinder, exponent), meridian(cylinder)
    missing = cylinder.support(n)[0] - model.support(n)[0]
    assert np.min(missing) >= -1e-12
    assert np.max(missing) <= error(cylinder, model) * (1.0 + 1e-9)
    assert np.max(missing) >= error(cylinder, model) * (1.0 - 1e-4)


@pytest.mark.parametrize("exponent", [2, 8, 100, 1000])
def test_outer_error(cylinder: Cylinder, exponent: int) -> None:
    model, n = outer(cylinder, exponent), meridian(cylinder)
    assert np.max(model.level(rim(cylinder))) <= 0.0
    assert np.max(model.level(rim(cylinder))) >= -1e-9
    bulge = model.support(n)[0] - cylinder.support(n)[0]
    assert np.min(bulge) >= -1e-12
    assert np.max(bulge) <= error(cylinder, model) <= 1.002 * np.max(bulge)
    # Ends and mantle bulge alike.
    assert bulge[0] == pytest.approx(bulge[-1], rel=1e-6)


@pytest.mark.parametrize("side", ["inner", "outer"])
@pytest.mark.parametrize("allowed", [0.2, 0.01])
def test_exponent_is_the_least_for_the_error(cylinder: Cylinder, side: str, allowed: float) -> None:
    model = for_error(cylinder, allowed, side)
    exponent = int(model.exponents[cylinder.axis_index])
    assert error(cylinder, model) <= allowed
    if exponent > 2:
        coarser = smoothed_cylinder.BUILDERS[side](cylinder, exponent - 2)
        assert error(cylinder, coarser) > allowed


@pytest.mark.parametrize("exponent", [3, 0, -2, 2.5, np.nan, "many"])
def test_bad_exponents_are_refused(exponent: float) -> None:
    for build in (inner, outer):
        with pytest.raises(InputError, match="exponent: is"):
            build(CYLINDERS[0], exponent)


def test_bad_errors_are_refused() -> None:
    with pytest.raises(InputError, match="error_m: is 0"):
        for_error(CYLINDERS[0], 0.0, "inner")
    with pytest.raises(InputError, match="error_m: is 1e-09"):
        for_error(CYLINDERS[0], 1e-9, "outer")
