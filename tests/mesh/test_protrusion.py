"""How far points stand out: against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.mesh.protrusion import protrusion
from berthing.mesh.tessellate import cut_triangles
from support import solids

CUBE = solids.solid(solids.box((1, 1, 1)))


@pytest.mark.parametrize(
    ("point", "distance"),
    [
        ((0, 0, 0), 0.0),
        ((0.4, 0.4, 0.4), 0.0),
        ((0.5, 0.1, 0.2), 0.0),
        ((0.7, 0.1, 0.2), 0.2),
        ((0.8, 0.9, 0.1), 0.5),
        ((1.5, 1.5, 1.5), np.sqrt(3)),
        ((0.499999, 0.6, 0.0), 0.1),
    ],
)
def test_distances_from_a_cube(point, distance):
    found = protrusion(CUBE, np.array([point], dtype=float))
    np.testing.assert_allclose(found, [distance], atol=1e-12)


def test_distances_from_a_torus():
    """Of a fine one, to within its chords."""
    torus = solids.solid(solids.torus(96, 48))
    points = np.random.default_rng(0).uniform(-0.8, 0.8, (200, 3)) * [1, 1, 0.3]
    ring = np.hypot(points[:, 0], points[:, 1]) - 0.5
    true = np.maximum(np.hypot(ring, points[:, 2]) - 0.12, 0.0)
    np.testing.assert_allclose(protrusion(torus, points), true, atol=1.5e-3)


def test_cutting_keeps_area_and_sides():
    corners = solids.l_bracket()
    cut, owner = cut_triangles(corners, 0.03)
    edges = np.linalg.norm(np.roll(cut, -1, axis=1) - cut, axis=2)
    assert edges.max() <= 0.03
    normal = np.cross(cut[:, 1] - cut[:, 0], cut[:, 2] - cut[:, 0])
    whole = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    for i in range(len(corners)):
        np.testing.assert_allclose(normal[owner == i].sum(axis=0), whole[i], atol=1e-15)
