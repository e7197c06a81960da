import numpy as np
import pytest

from berthing.geometry.box import Box
from berthing.geometry.cylinder import Cylinder
from berthing.geometry.pose import Pose
from berthing.geometry.sphere import Sphere
from berthing.report.camera import Camera
from berthing.report.painter import Painter
from berthing.report.surface import Surface, cut_edges

CAMERA = Camera.at(-60.0, 25.0)
FROM_ABOVE = Camera.at(-90.0, 90.0)


def length(edges):
    return float(np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1).sum())


def test_the_camera_is_orthonormal_and_looks_from_where_it_is_said():
    axes = np.stack([CAMERA.right, CAMERA.up, CAMERA.towards])
    np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-15)
    assert np.linalg.det(axes) == pytest.approx(1.0)
    np.testing.assert_allclose(FROM_ABOVE.towards, [0.0, 0.0, 1.0], atol=1e-15)
    np.testing.assert_allclose(FROM_ABOVE.project(np.array([3.0, 2.0, 9.0])), [3.0, 2.0])


def test_of_a_box_three_faces_and_nine_edges_are_seen():
    seen = Surface.of(Box(np.array([2.0, 1.0, 0.5])).mesh()).seen(Pose.identity(3), CAMERA)
    assert len(seen.corners) == 3 * 2 * 3
    assert len(seen.edges) == 9
    assert length(seen.edges) == pytest.approx(3 * (4.0 + 2.0 + 1.0))


def test_from_straight_above_one_face_and_its_rim_are_seen():
    seen = Surface.of(Box(np.array([2.0, 1.0, 0.5])).mesh()).seen(Pose.identity(3), FROM_ABOVE)
    assert length(seen.edges) == pytest.approx(2 * (4.0 + 2.0))


def test_of_a_sphere_only_the_outline_is_seen():
    seen = Surface.of(Sphere(2.0).mesh()).seen(Pose.identity(3), CAMERA)
    # Triangles are up to 0.35 m large, so the outline wanders in depth by about as much.
    assert np.abs(CAMERA.depth(seen.edges)).max() < 0.4
    assert length(CAMERA.project(seen.edges)) == pytest.approx(2 * np.pi * 2.0, rel=0.02)


def test_of_a_cylinder_one_cap_is_whole_and_the_other_half():
    seen = Surface.of(Cylinder(1.0, 3.0).mesh()).seen(Pose.identity(3), CAMERA)
    around = 2 * np.pi
    assert length(seen.edges) == pytest.approx(around + around / 2 + 2 * 6.0, rel=0.02)


def test_a_flat_shape_has_its_rim():
    seen = Surface.of(Box(np.array([2.0, 1.0])).mesh()).seen(Pose.identity(3), FROM_ABOVE)
    assert length(seen.edges) == pytest.approx(12.0)


def test_cut_edges_are_short_and_make_up_the_same_length():
    edges = np.array([[[0.0, 0, 0], [10.0, 0, 0]], [[0.0, 0, 0], [0.1, 0, 0]]])
    pieces = cut_edges(edges, 1.0)
    assert np.linalg.norm(pieces[:, 1] - pieces[:, 0], axis=1).max() <= 1.0
    assert length(pieces) == pytest.approx(10.1)


def test_the_nearer_body_is_painted_later():
    painter = Painter(FROM_ABOVE, 10.0)
    surface = Surface.of(Box(np.ones(3)).mesh())
    for height, colour in ((5.0, "red"), (-5.0, "blue"), (0.0, "lime")):
        pose = Pose(np.array([0.0, 0.0, height]), np.eye(3))
        painter.surface(surface.seen(pose, FROM_ABOVE), colour, 0.5, colour, 0.0)
    from berthing.report.style import new_figure

    axes = new_figure(2.0, 2.0).add_axes((0, 0, 1, 1))
    painter.paint(axes)
    faces = axes.collections[0].get_facecolor()
    filled = faces[faces[:, 3] > 0.0]
    np.testing.assert_allclose(filled[:, :3], [[0, 0, 1], [0, 1, 0], [1, 0, 0]])


def test_a_point_has_nothing_to_draw():
    seen = Surface.of(Sphere(0.0).mesh()).seen(Pose.identity(3), CAMERA)
    assert len(seen.corners) == 0
    Painter(CAMERA, 1.0).surface(seen, "red", 0.5, "red", 1.0)
