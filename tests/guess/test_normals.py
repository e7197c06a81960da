"""Normals to start from: those of the exact distance."""

from __future__ import annotations

import numpy as np

from berthing.geometry.pose import Pose
from berthing.guess.normals import exact_normals
from support.documents import box, puck, scenario, structure


def test_normals_point_from_the_vehicle_to_the_thing_and_part_them_best() -> None:
    things = [structure("wall", [3, 0], box(1, 8)), structure("post", [0, 5], box(1, 1))]
    given = scenario(puck(), structures=things)
    normals = exact_normals(given.pairs(given.phases[0]))
    way = np.array([[0.0, 0.0], [5.0, 1.0], [2.8, 3.0]])
    pucks = Pose(way, np.tile(np.eye(2), (3, 1, 1)))
    wall = Pose(np.tile([3.0, 0.0], (3, 1)), np.tile(np.eye(2), (3, 1, 1)))
    # In front of it, behind it, and inside it a little short of the middle.
    expected = [[1, 0], [-1, 0], [1, 0]]
    np.testing.assert_allclose(normals(0, pucks, wall), expected, atol=1e-6)
    post = Pose(np.tile([0.0, 5.0], (3, 1)), np.tile(np.eye(2), (3, 1, 1)))
    assert normals(1, pucks, post)[0] @ [0.0, 1.0] > 0.999
