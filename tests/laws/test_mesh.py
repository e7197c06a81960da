"""A mesh is a closed surface that faces outward and lies in its set, and nearly fills it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable

import numpy as np
import pytest

from berthing.geometry.arrays import Array
from berthing.geometry.box import Box
from berthing.geometry.capability import level, mesh
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.mesh import Mesh
from support.shapes import level_rounding, rounding, size

# Of a flat facet inside a curved surface, as a fraction of the size.
FACET_DEPTH = 0.02


def directed_edges(surface: Mesh) -> Counter[tuple[int, int]]:
    t = surface.triangles
    pairs = np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]).tolist()
    return Counter((i, j) for i, j in pairs)


def area_vectors(surface: Mesh) -> Array:
    a, b, c = (surface.vertices[surface.triangles[:, i]] for i in range(3))
    return np.asarray(0.5 * np.cross(b - a, c - a))


def check_closed(surface: Mesh) -> None:
    """Every edge is walked once each way."""
    edges = directed_edges(surface)
    assert set(edges.values()) == {1}
    assert all((j, i) in edges for i, j in edges)


def check_outward(surface: Mesh) -> None:
    middle = surface.vertices.mean(axis=0)
    centroids = surface.vertices[surface.triangles].mean(axis=1)
    assert np.all(np.sum(area_vectors(surface) * (centroids - middle), axis=1) > 0.0)


def test_solids_are_closed_and_face_outward(shape: ConvexSet) -> None:
    if shape.dim == 2:
        return
    check_closed(mesh(shape))
    if shape.bounding_radius > 0.0:
        check_outward(mesh(shape))


def test_planar_shapes_are_polygons_that_face_up(shape: ConvexSet) -> None:
    if shape.dim == 3:
        return
    surface = mesh(shape)
    assert np.all(surface.vertices[:, 2] == 0.0)
    if shape.bounding_radius > 0.0:
        assert np.all(area_vectors(surface)[:, 2] > 0.0)
    rim = [edge for edge in directed_edges(surface) if edge[::-1] not in directed_edges(surface)]
    assert sorted(i for i, _ in rim) == list(range(len(surface.vertices)))


def test_vertices_lie_on_the_boundary(shape: ConvexSet) -> None:
    """Those of the piece of a half-space that is drawn, on it or behind."""
    surface = mesh(shape)
    within = 10.0 * max(rounding(shape), level_rounding(shape))
    height = level(shape, surface.vertices[:, : shape.dim])
    assert np.max(height) == pytest.approx(0.0, abs=within)
    if np.isfinite(shape.bounding_radius):
        assert np.min(height) >= -within
    assert set(surface.triangles.ravel().tolist()) == set(range(len(surface.vertices)))


def test_nearly_fills_the_set(bounded: ConvexSet, directions: Callable[[int, int], Array]) -> None:
    n = directions(200, bounded.dim)
    n = n / np.linalg.norm(n, axis=1, keepdims=True)
    drawn = np.max(n @ mesh(bounded).vertices[:, : bounded.dim].T, axis=1)
    missing = bounded.support(n)[0] - drawn
    assert np.all(missing >= -1e-12)
    assert np.all(missing <= FACET_DEPTH * size(bounded))


def test_the_checks_notice_a_hole_and_a_flipped_triangle() -> None:
    good = mesh(Box([1.0, 1.0, 1.0]))
    with pytest.raises(AssertionError):
        check_closed(Mesh(good.vertices, good.triangles[1:]))
    flipped = good.triangles.copy()
    flipped[0] = flipped[0, ::-1]
    with pytest.raises(AssertionError):
        check_closed(Mesh(good.vertices, flipped))
    with pytest.raises(AssertionError):
        check_outward(Mesh(good.vertices, flipped))
