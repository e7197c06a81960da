"""Polygons less polytopes: nothing is lost and nothing is dropped unproven."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from berthing.geometry.polytope import Polytope
from berthing.mesh.faces import faces
from berthing.mesh.subtract import area, remainder
from support import solids

SLACK = 1e-9
SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])


def block(lower, upper):
    A = np.concatenate([np.eye(3), -np.eye(3)])
    return A, np.concatenate([upper, -np.array(lower, dtype=float)])


def left_area(*blocks):
    return sum(map(area, remainder(SQUARE, blocks, SLACK)))


def test_a_polygon_inside_is_gone():
    assert remainder(SQUARE, [block((-1, -1, -1), (2, 2, 1))], SLACK) == []


def test_a_polygon_outside_stays_whole():
    (left,) = remainder(SQUARE, [block((2, 2, -1), (3, 3, 1))], SLACK)
    assert left is SQUARE


def test_areas_add_up():
    assert left_area(block((0.25, 0.25, -1), (0.75, 0.75, 1))) == pytest.approx(0.75, abs=1e-7)
    assert left_area(block((-1, -1, -1), (0.5, 2, 1))) == pytest.approx(0.5, abs=1e-7)


def test_two_halves_that_overlap_cover():
    halves = [block((-1, -1, -1), (0.5, 2, 1)), block((0.5 - 1e-6, -1, -1), (2, 2, 1))]
    assert remainder(SQUARE, halves, SLACK) == []


@pytest.mark.parametrize("gap", [0.0, 1e-12, 1e-10, 1e-6])
def test_halves_that_only_touch_do_not(gap):
    """A gap however narrow is found; that they touch to the last bit is not proof enough."""
    halves = [block((-1, -1, -1), (0.5, 2, 1)), block((0.5 + gap, -1, -1), (2, 2, 1))]
    assert remainder(SQUARE, halves, SLACK) != []


def test_lying_on_the_face_is_not_inside():
    assert remainder(SQUARE, [block((-1, -1, 0), (2, 2, 1))], SLACK) != []


def test_segments_and_points_are_polygons_too():
    segment = np.array([[0.0, 0, 0], [1, 0, 0], [1, 0, 0]])
    cover = block((-1, -1, -1), (2, 2, 1))
    assert remainder(segment, [cover], SLACK) == []
    assert remainder(segment, [block((-1, -1, -1), (0.5, 1, 1))], SLACK) != []
    assert remainder(np.zeros((3, 3)), [cover], SLACK) == []


@given(st.integers(0, 10**6))
@settings(max_examples=30, deadline=None)
def test_what_is_left_is_outside_and_what_went_is_inside(seed):
    draw = np.random.default_rng(seed)
    polytopes = [
        Polytope.from_vertices(draw.random(3) + 0.6 * draw.standard_normal((12, 3)))
        for _ in range(4)
    ]
    triangle = draw.random((3, 3)) * 2 - 0.5
    parts = remainder(triangle, [(p.A, p.b) for p in polytopes], SLACK)
    for part in parts:
        middle = part.mean(axis=0)
        assert all(p.level(middle) > -2 * SLACK for p in polytopes)
    points = solids.samples(triangle[None], 400, seed)
    inside = np.any([p.level(points) < -2 * SLACK for p in polytopes], axis=0)
    share = sum(map(area, parts)) / area(triangle)
    assert share == pytest.approx(1 - np.mean(inside), abs=0.12)


def test_faces_of_a_polytope_have_its_surface():
    shape = Polytope.from_vertices(np.random.default_rng(5).standard_normal((30, 3)))
    found = faces(shape)
    assert len(found) == len(shape.b)
    surface = shape.mesh()
    a, b, c = np.moveaxis(surface.vertices[surface.triangles], 1, 0)
    wanted = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
    assert sum(map(area, found)) == pytest.approx(wanted, rel=1e-9)
    for face in found:
        assert np.max(shape.level(face)) <= 1e-9
