"""Balls and ellipsoids in place of the sets: safe, and too large by what is known."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.clearance.separation import PairQuery
from berthing.geometry.box import Box
from berthing.geometry.pose import Pose
from berthing.proximity.enclosed import bounding_ellipsoid, bounding_sphere

ROUNDING = 1e-6


@pytest.mark.parametrize("make", [bounding_sphere, bounding_ellipsoid])
def test_what_it_proves_is_never_more_than_the_distance(make, pair, poses, rows_at) -> None:
    a, b = pair
    form, query = make(a, b), PairQuery(a, b)
    reach = 2.5 * (a.bounding_radius + b.bounding_radius) + 0.1
    poses_a, poses_b = poses(1, a.dim, 0.1), poses(1, a.dim, reach)
    gaps, normals, _ = query.batch(poses_a, poses_b)
    starts = form.start(poses_a, poses_b, normals)
    values, rows = rows_at(form, starts[0], poses_a[0], poses_b[0], 0.0)
    assert np.all(values[1:] >= rows.lower[1:] - ROUNDING)
    assert values[rows.separation] <= gaps[0] + ROUNDING


def test_between_boxes_they_lose_what_sticks_out(best_gap) -> None:
    a = b = Box([2.0, 1.0, 1.0])
    pose_a, pose_b = Pose.identity(3), Pose(np.array([0.0, 6.0, 0.0]), np.eye(3))
    normal = np.array([0.0, 1.0, 0.0])
    for make, lost in ((bounding_sphere, np.sqrt(6.0) - 1.0), (bounding_ellipsoid, 3**0.5 - 1.0)):
        form = make(a, b)
        gap = best_gap(form, form.start(pose_a, pose_b, normal), pose_a, pose_b)
        assert gap == pytest.approx(4.0 - 2.0 * lost, abs=1e-5)
