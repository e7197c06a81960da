"""Bodies name their parts and know how far they reach."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry.body import Body, Part
from berthing.geometry.box import Box
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere


def at(*position: float) -> Pose:
    return Pose(np.array(position), np.eye(len(position)))


HULL = Part("hull", Box([2.0, 1.0, 1.0]), at(0.0, 0.0, 0.0))
BOOM = Part("boom", Cylinder(0.1, 3.0), at(4.0, 0.0, 0.0))


def test_finds_a_part_or_names_the_options() -> None:
    body = Body((HULL, BOOM))
    assert body.part("boom") is BOOM
    with pytest.raises(InputError, match=r"has no part 'arm'.*hull, boom"):
        body.part("arm")


def test_radius_of_a_part_with_vertices_is_exact() -> None:
    moved = Part("tank", Box([1.0, 1.0, 1.0]), at(2.0, 0.0, 0.0))
    assert moved.bounding_radius == pytest.approx(np.sqrt(9.0 + 2.0))
    assert Body((HULL, moved)).bounding_radius == pytest.approx(np.sqrt(11.0))


def test_radius_covers_curved_parts() -> None:
    n = np.random.default_rng(1).normal(size=(500, 3))
    reached = BOOM.placement.apply(BOOM.shape.support(n)[1])
    assert np.max(np.linalg.norm(reached, axis=1)) <= BOOM.bounding_radius
    assert Body((HULL, BOOM)).bounding_radius == BOOM.bounding_radius


def test_dimension() -> None:
    assert Body((HULL,)).dim == 3
    assert Body((Part("disc", Sphere(1.0, dim=2), at(0.0, 0.0)),)).dim == 2


def test_bad_bodies_are_refused() -> None:
    flat = Part("disc", Sphere(1.0, dim=2), at(0.0, 0.0))
    with pytest.raises(InputError, match="body: has no parts"):
        Body(())
    with pytest.raises(InputError, match="uses the part name 'hull' twice"):
        Body((HULL, HULL))
    with pytest.raises(InputError, match="mixes parts of two and three dimensions"):
        Body((HULL, flat))


def test_bad_parts_are_refused() -> None:
    with pytest.raises(InputError, match="part 'x': places a set of 3 dimensions in 2"):
        Part("x", Sphere(1.0), at(0.0, 0.0))
    with pytest.raises(InputError, match="part 'x': has a batch of placements"):
        Part("x", Sphere(1.0), Pose(np.zeros((2, 3)), np.eye(3)))
