"""The proof, and what makes it fail: uncovered surface, gaps inside."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.geometry.polytope import Polytope
from berthing.mesh.coverage import coverage
from berthing.mesh.winding import winding_number
from support import solids


def block(size, centre=(0, 0, 0)):
    return Polytope.from_vertices(solids.box(size, centre).reshape(-1, 3))


CUBE = solids.solid(solids.box((1, 1, 1)))


def test_a_larger_box_covers():
    found = coverage(CUBE, [block((1.001, 1.001, 1.001))])
    assert found.proven
    assert (found.uncovered_area_m2, found.uncovered_triangles, found.voids) == (0.0, 0, 0)


def test_the_same_box_does_not_for_rounding_could_open_it():
    assert not coverage(CUBE, [block((1, 1, 1))]).proven


def test_what_sticks_out_is_measured():
    found = coverage(CUBE, [block((1.001, 1.001, 1.001), (0.1, 0, 0))])
    assert not found.proven
    assert found.voids is None
    # One face, and a strip of 0.0995 m of the four around it.
    assert found.uncovered_area_m2 == pytest.approx(1 + 4 * 0.0995, rel=1e-6)
    # The one face, and of the others the triangles that have an edge there, or a corner.
    assert 2 <= found.uncovered_triangles <= 10


def shell():
    """Six plates that cover the cube's surface and not its middle."""
    plates = []
    for axis in range(3):
        for side in (-1, 1):
            size, centre = np.full(3, 1.1), np.zeros(3)
            size[axis], centre[axis] = 0.2, 0.48 * side
            plates.append(block(size, centre))
    return plates


def test_a_gap_inside_is_found_although_the_surface_is_covered():
    found = coverage(CUBE, shell())
    assert found.uncovered_triangles == 0
    assert found.voids is not None
    assert found.voids > 0
    assert not found.proven
    assert coverage(CUBE, [*shell(), block((0.9, 0.9, 0.9))]).proven


def test_a_narrow_gap_between_pieces_is_found():
    bar = solids.solid(solids.box((2, 1, 1)))
    ends = [block((1.1, 1.1, 1.1), (s * 0.6, 0, 0)) for s in (-1, 1)]
    caps = [
        block(size, centre)
        for size, centre in (
            ((0.4, 1.1, 0.1), (0, 0, 0.5)),
            ((0.4, 1.1, 0.1), (0, 0, -0.5)),
            ((0.4, 0.1, 1.1), (0, 0.5, 0)),
            ((0.4, 0.1, 1.1), (0, -0.5, 0)),
        )
    ]
    found = coverage(bar, [*ends, *caps])
    # Its six walls.
    assert (found.uncovered_triangles, found.voids) == (0, 6)
    assert coverage(bar, [*ends, *caps, block((0.3, 1, 1))]).proven


def test_a_hollow_need_not_be_filled():
    """A cavity of the mesh itself is outside the solid."""
    hollow = np.concatenate([solids.box((1, 1, 1)), solids.box((0.8, 0.8, 0.8))[:, ::-1]])
    assert coverage(solids.solid(hollow), shell()).proven


def test_winding_numbers_are_whole():
    torus = solids.solid(solids.torus())
    points = np.array([[0.5, 0, 0], [0, 0, 0], [0.5, 0, 0.119], [9, 9, 9], [0, -0.45, 0.05]])
    np.testing.assert_allclose(winding_number(torus, points), [1, 0, 1, 0, 1], atol=1e-9)
    assert winding_number(torus, np.empty((0, 3))).shape == (0,)
