"""Outer bounds of points: hulls with joined faces, boxes; and the budget they share."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from berthing.geometry import quaternion
from berthing.geometry.box import Box
from berthing.geometry.cylinder import Cylinder
from berthing.mesh.box_fit import box_around
from berthing.mesh.choose import chosen
from berthing.mesh.fit import Fit, fits
from berthing.mesh.hull import hull_volume, outer_bound
from berthing.mesh.merge import joined
from berthing.mesh.piece import Piece
from support import solids

TURN = quaternion.rotation_matrix(np.array([0.9, 0.2, -0.4, 0.1]))


def cloud(seed, count=40):
    draw = np.random.default_rng(seed)
    return (draw.standard_normal((count, 3)) * [1.0, 0.4, 0.2]) @ TURN.T + draw.random(3)


def rod(sides, radius=0.02, length=0.8):
    """Corners of a round strut along z, turned."""
    a = np.arange(sides) * (2 * np.pi / sides)
    ring = np.stack([radius * np.cos(a), radius * np.sin(a), np.zeros(sides)], axis=1)
    return np.concatenate([ring, solids.moved(ring, 0, 0, length)]) @ TURN.T


@given(st.integers(0, 10**6), st.sampled_from([0.0, 5.0, 20.0, 40.0]))
@settings(max_examples=40, deadline=None)
def test_joined_faces_never_cut_a_point(seed, angle):
    points = cloud(seed)
    bound = outer_bound(points, angle)
    if bound is not None:
        assert np.max(points @ bound.A.T - bound.b) <= 1e-15 * 10
        assert bound.volume >= hull_volume(points) * (1 - 1e-12)


def test_a_wider_angle_leaves_fewer_faces():
    points = solids.torus().reshape(-1, 3)
    faces = [len(bound.b) for a in (0.0, 10.0, 25.0) if (bound := outer_bound(points, a))]
    assert faces[0] > faces[1] > faces[2]


def test_what_is_flat_has_no_bound():
    flat = cloud(1) * [1, 1, 0]
    assert outer_bound(flat, 0.0) is None
    assert hull_volume(flat) == 0.0
    assert fits(flat, 1.15) == []


def test_faces_that_leave_a_side_open_are_no_bound():
    needle = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.3, 0.3, 1e-3]])
    assert outer_bound(needle, 89.0) is None or outer_bound(needle, 89.0).volume > 0.0


def test_a_turned_box_is_found_again():
    size = np.array([0.3, 0.7, 1.9])
    points = solids.box(size).reshape(-1, 3) @ TURN.T + [1, 2, 3]
    half, pose = box_around(points)
    np.testing.assert_allclose(np.sort(2 * half), size, rtol=1e-9)
    assert np.all(np.abs(pose.inverse().apply(points)) <= half + 1e-12)


@pytest.mark.parametrize("seed", range(8))
def test_every_fit_contains_the_points(seed):
    points = cloud(seed) if seed else rod(16)
    found = fits(points, 1.15)
    costs, volumes = [f.cost for f in found], [f.volume for f in found]
    assert costs == sorted(costs, reverse=True)
    assert volumes == sorted(volumes)
    for fit in found:
        piece = fit.build()
        assert piece.volume == pytest.approx(fit.volume, rel=1e-9)
        # The proof uses the core.
        assert np.max(piece.core.level(points)) <= 1e-12


def test_bars_become_boxes():
    bar = solids.box((0.05, 0.05, 1.0)).reshape(-1, 3) @ TURN.T
    assert isinstance(fits(bar, 1.15)[-1].build().shape, Box)


def test_round_struts_become_cylinders():
    strut = rod(8)
    best = fits(strut, 1.15)[-1].build()
    assert isinstance(best.shape, Cylinder)
    assert best.shape.radius == pytest.approx(0.02, rel=5e-3)
    assert best.shape.half_length == pytest.approx(0.4)
    # Tighter than the box: 8/π of the octagon's area against 2√2 of it.
    assert best.volume < 1.12 * hull_volume(strut)


def test_a_piece_grows_by_twice_the_share_that_is_asked_for_at_most():
    points = cloud(3)
    tight = hull_volume(points)
    for ratio in (1.05, 1.45):
        assert all(fit.volume <= (2 * ratio - 1) * tight for fit in fits(points, ratio))
    assert fits(points, 1.45)[-1].cost < fits(points, 1.05)[-1].cost


def test_the_core_of_a_cylinder_lies_inside_it():
    piece = fits(rod(8), 1.15)[-1].build()
    inside = piece.placement.inverse().apply(piece.core.corners)
    assert np.max(piece.shape.level(inside)) <= 1e-15


@pytest.mark.parametrize("points", [rod(16), cloud(4), solids.box((1, 2, 3)).reshape(-1, 3)])
def test_a_pushed_piece_contains_the_old_one(points):
    for fit in fits(points, 1.15):
        piece = fit.build()
        old, new = piece.core, piece.pushed(1e-3).core
        assert np.max(new.level(old.corners)) <= -1e-4
        again = Piece.from_json(piece.to_json(), "piece")
        assert abs(np.max(again.core.level(old.corners))) <= 1e-12
        assert abs(np.max(old.level(again.core.corners))) <= 1e-12


def test_the_budget_goes_where_it_saves_most():
    def fit(volume, cost):
        return Fit(volume, cost, lambda: None)

    options = [[fit(1.0, 20), fit(1.1, 10), fit(1.5, 6)], [fit(2.0, 30), fit(2.05, 12)]]
    picked = chosen(options, 3.2)
    assert [(f.volume, f.cost) for f in picked] == [(1.1, 10), (2.05, 12)]
    assert [f.cost for f in chosen(options, 1.0)] == [20, 30]
    assert [f.cost for f in chosen(options, 9.0)] == [6, 12]


def test_halves_of_a_box_are_joined_and_far_ones_are_not():
    near = [solids.box((1, 1, 1), (c, 0, 0)).reshape(-1, 3) for c in (0, 1)]
    assert len(joined(near, 1e-6)) == 1
    apart = [near[0], near[0] + [3, 0, 0]]
    assert len(joined(apart, 100.0)) == 2
    bent = [near[0], near[0] + [1, 1, 0]]
    assert len(joined(bent, 1e-6)) == 2
