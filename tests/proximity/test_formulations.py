"""The table of formulations."""

from __future__ import annotations

import pytest

from berthing.errors import InputError
from berthing.geometry.box import Box
from berthing.geometry.sphere import Sphere
from berthing.proximity.formulations import formulate
from berthing.proximity.plane import PlaneFormulation


def test_a_formulation_is_found_by_name() -> None:
    form = formulate("plane", Box([1.0, 1.0, 1.0]), Sphere(1.0))
    assert isinstance(form, PlaneFormulation)


def test_an_unknown_name_is_told_which_there_are() -> None:
    with pytest.raises(InputError, match=r"there is no 'planes' \(expected one of .*plane\)"):
        formulate("planes", Sphere(1.0), Sphere(1.0))
