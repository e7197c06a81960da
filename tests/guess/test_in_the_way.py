"""Guesses go around what is near the way and what hangs on it, not around a far field."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.geometry.body import Body, Part
from berthing.geometry.box import Box
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.pose import Pose
from berthing.guess.in_the_way import in_the_way

CUBE = Box(np.full(3, 0.5))
ENDS = np.zeros(3), np.array([10.0, 0.0, 0.0])
HERE = Pose.identity(3)


def field(*places: tuple[float, float, float]) -> Body:
    parts = (Part(f"c{i}", CUBE, Pose(np.array(at), np.eye(3))) for i, at in enumerate(places))
    return Body(tuple(parts))


def names(body: Body | None) -> list[str]:
    return [] if body is None else [part.name for part in body.parts]


def test_what_is_far_is_left_out() -> None:
    body = field((5, 1, 0), (5, 30, 0), (40, 0, 0))
    assert names(in_the_way(body, HERE, ENDS, 3.0, 1.0)) == ["c0"]


def test_what_hangs_on_a_near_part_is_kept() -> None:
    wall = field(*((5.0, float(y), 0.0) for y in range(1, 30)), (5, 60, 0))
    assert names(in_the_way(wall, HERE, ENDS, 3.0, 0.5)) == [f"c{i}" for i in range(29)]


def test_a_gap_ends_it() -> None:
    # Balls of 0.87 m, 4 m apart: they are 2.27 m from each other.
    body = field((5, 1, 0), (5, 5, 0), (5, 9, 0))
    assert names(in_the_way(body, HERE, ENDS, 3.0, 2.2)) == ["c0"]
    assert names(in_the_way(body, HERE, ENDS, 3.0, 2.3)) == ["c0", "c1", "c2"]


def test_nothing_near_is_nothing_in_the_way() -> None:
    assert in_the_way(field((5, 30, 0)), HERE, ENDS, 3.0, 1.0) is None


def test_half_spaces_are_left_out() -> None:
    floor = Part("floor", HalfSpace(np.array([0.0, 0.0, 1.0]), -2.0), HERE)
    body = field((5, 1, 0))
    assert names(in_the_way(Body((*body.parts, floor)), HERE, ENDS, 3.0, 1.0)) == ["c0"]
    assert in_the_way(Body((floor,)), HERE, ENDS, 3.0, 1.0) is None


@pytest.mark.parametrize("shift", [(0.0, 2.0, 0.0), (0.0, 20.0, 0.0)])
def test_the_pose_of_the_body_counts(shift: tuple[float, float, float]) -> None:
    body = in_the_way(field((5, 0, 0)), Pose(np.array(shift), np.eye(3)), ENDS, 3.0, 1.0)
    assert (body is not None) == (shift[1] < 3.0)
