"""Polytopes from either description have both, without redundant members."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.polytope import Polytope


def as_rows(values: Array) -> list[tuple[float, ...]]:
    return sorted(tuple(float(x) + 0.0 for x in row) for row in np.round(values, 9))


@pytest.fixture(params=[2, 3])
def cloud(request: pytest.FixtureRequest) -> Array:
    rng = np.random.default_rng(3)
    return rng.normal(size=(40, request.param)) + 5.0


def test_there_and_back(cloud: Array) -> None:
    first = Polytope.from_vertices(cloud)
    again = Polytope.from_halfspaces(first.A, first.b)
    assert as_rows(again.corners) == as_rows(first.corners)
    assert as_rows(again.A) == as_rows(first.A)
    assert len(first.corners) < len(cloud)


def test_given_vertices_are_kept_exactly(cloud: Array) -> None:
    given = {tuple(row) for row in cloud.tolist()}
    assert {tuple(row) for row in Polytope.from_vertices(cloud).corners.tolist()} <= given


def test_derived_half_spaces_cut_no_vertex(cloud: Array) -> None:
    shape = Polytope.from_vertices(cloud)
    assert np.all(shape.corners @ shape.A.T <= shape.b)


def test_vertices_inside_and_twice_are_dropped() -> None:
    corners = Box([1.0, 2.0, 3.0]).vertices()
    middles = 0.5 * (corners + np.roll(corners, 1, axis=0))
    shape = Polytope.from_vertices(np.concatenate([corners, corners, middles, np.zeros((1, 3))]))
    assert as_rows(shape.corners) == as_rows(corners)
    assert as_rows(shape.A) == as_rows(Box([1.0, 2.0, 3.0]).halfspaces()[0])


def test_redundant_rows_are_dropped_and_lengths_do_not_matter() -> None:
    A, b = Box([1.0, 2.0, 3.0]).halfspaces()
    far = np.array([[1.0, 1.0, 1.0], [1.0, 0.0, 0.0]])
    shape = Polytope(np.concatenate([7.0 * A, far]), np.concatenate([7.0 * b, [60.0, 5.0]]))
    assert as_rows(shape.A) == as_rows(A)
    assert as_rows(shape.corners) == as_rows(Box([1.0, 2.0, 3.0]).vertices())


def test_a_row_given_twice_counts_once() -> None:
    A, b = Box([1.0, 2.0]).halfspaces()
    shape = Polytope(np.concatenate([A, A]), np.concatenate([b, b]))
    assert len(shape.A) == 4
    assert len(shape.corners) == 4


@pytest.mark.parametrize("scale", [1e-4, 1.0, 1e5])
@pytest.mark.parametrize("offset", [0.0, 1e4])
def test_size_and_place_do_not_matter(scale: float, offset: float) -> None:
    corners = scale * (Box([1.0, 2.0, 3.0]).vertices() + offset)
    shape = Polytope.from_vertices(corners)
    assert len(shape.corners) == 8
    assert len(shape.A) == 6
    again = Polytope(shape.A, shape.b)
    assert len(again.corners) == 8
    error = np.min(np.linalg.norm(again.corners[:, None] - corners[None], axis=-1), axis=1)
    assert np.max(error) < 1e-9 * scale * (1.0 + offset)


def test_many_faces_meet_at_a_vertex() -> None:
    angle = np.arange(12) * (2.0 * np.pi / 12)
    rim = np.stack([np.cos(angle), np.sin(angle), np.zeros(12)], axis=-1)
    cone = Polytope.from_vertices(np.concatenate([rim, [[0.0, 0.0, 2.0]]]))
    assert len(cone.A) == 13
    assert len(Polytope(cone.A, cone.b).corners) == 13


def test_thin_plates_are_allowed() -> None:
    assert len(Polytope.from_vertices(Box([10.0, 10.0, 1e-3]).vertices()).corners) == 8
