import numpy as np
import pytest
from scipy.spatial import ConvexHull

from berthing.geometry.body import Body, Part
from berthing.geometry.box import Box
from berthing.geometry.capability import mesh
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.ellipsoid import Ellipsoid
from berthing.geometry.mesh import hull_mesh
from berthing.geometry.polytope import Polytope
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.report.offline import coarse
from berthing.report.offline.coarse import coarsened
from berthing.report.offline.packing import Packing
from berthing.report.offline.shapes import packed_body

# Rounding of hulls about a metre large.
ROUNDING_M = 1e-9


def dense_ball(count, seed=0):
    """A convex surface with about twice as many triangles as points."""
    points = np.random.default_rng(seed).normal(size=(count, 3))
    return hull_mesh(points / np.linalg.norm(points, axis=1, keepdims=True))


def edges_of(body):
    return packed_body(body, Packing())["e"]["n"][0]


def test_bodies_of_few_triangles_stay_as_they_are():
    whole = [mesh(Box(np.ones(3))), mesh(Sphere(1.0)), mesh(Cylinder(1.0, 2.0))]
    drawn, off = coarsened(whole)
    assert off == 0.0
    assert all(new is old for new, old in zip(drawn, whole, strict=True))


@pytest.mark.slow
@pytest.mark.parametrize("parts", [1, 3])
def test_a_hundred_thousand_triangles_become_as_many_as_can_be_drawn(parts):
    whole = [dense_ball(50_000 // parts, seed) for seed in range(parts)]
    assert sum(len(found.triangles) for found in whole) > 99_000
    drawn, off = coarsened([mesh(Box(np.ones(3))), *whole])
    count = sum(len(found.triangles) for found in drawn)
    assert 0.8 * coarse.MOST_TRIANGLES < count <= coarse.MOST_TRIANGLES
    assert len(drawn[0].triangles) == 12
    assert 0.0 < off < 0.01


def test_what_is_drawn_lies_inside_and_by_no_more_than_is_said(monkeypatch):
    monkeypatch.setattr(coarse, "MOST_TRIANGLES", 1_000)
    whole = [dense_ball(2_000)]
    (drawn,), off = coarsened(whole)
    assert len(drawn.triangles) <= 1_000
    outer = ConvexHull(whole[0].vertices).equations
    inner = ConvexHull(drawn.vertices).equations
    assert np.max(drawn.vertices @ outer[:, :3].T + outer[:, 3]) < ROUNDING_M
    short = np.max(whole[0].vertices @ inner[:, :3].T + inner[:, 3])
    assert short == pytest.approx(off, rel=1e-6)
    # Outward triangles all around: the volume that they enclose is nearly the ball's.
    a, b, c = (drawn.vertices[drawn.triangles[:, i]] for i in range(3))
    volume = np.sum(np.einsum("ij,ij->i", a, np.cross(b, c))) / 6.0
    assert volume == pytest.approx(4.0 * np.pi / 3.0, rel=0.02)


def test_a_part_among_many_still_looks_like_itself(monkeypatch):
    monkeypatch.setattr(coarse, "MOST_TRIANGLES", 10)
    drawn, _ = coarsened([mesh(Sphere(1.0)), mesh(Sphere(2.0))])
    for found in drawn:
        assert 0.8 * coarse.LEAST_TRIANGLES < len(found.triangles) <= coarse.LEAST_TRIANGLES


def test_flat_shapes_are_left_alone(monkeypatch):
    monkeypatch.setattr(coarse, "MOST_TRIANGLES", 10)
    monkeypatch.setattr(coarse, "LEAST_TRIANGLES", 10)
    flat = mesh(Sphere(1.0, 2))
    assert coarsened([flat]) == ([flat], 0.0)


def test_smooth_shapes_have_no_edges_and_others_keep_theirs(monkeypatch):
    monkeypatch.setattr(coarse, "MOST_TRIANGLES", 10)
    here = Pose.identity(3)
    lens = Body((Part("a", Ellipsoid(np.array([1.0, 0.9, 0.8])), here),))
    drum = Body((Part("a", Cylinder(1.0, 0.2), here),))
    cube = Body((Part("a", Polytope.from_vertices(mesh(Box(np.ones(3))).vertices), here),))
    assert edges_of(lens) == 0
    assert edges_of(drum) > 20
    assert edges_of(cube) == 12
