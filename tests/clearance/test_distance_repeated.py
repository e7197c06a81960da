"""The checks of the distance table: of another order of poses, of upper bounds, of gradients."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from benchmarks import _distance_checks
from benchmarks._distance_order import Repeated, upper_bounds_wrong
from benchmarks._distance_poses import random_poses
from benchmarks._distance_sets import SMOOTH, SPACE, TILTED, pose_law

import berthing as bt
from berthing.geometry.half_space import HalfSpace
from berthing.geometry.pose import Pose
from support.distances import BRACKET, DEPTH, GRADIENT
from support.shapes import SHAPES

PAIRS = [
    ("paper-cylinder", "pillow"),
    ("cylinder-x", "cone"),
    pytest.param(("inner-box", "cut-cylinder"), marks=pytest.mark.slow),
]


@pytest.mark.parametrize("names", PAIRS)
def test_another_order_gives_the_same(names: tuple[str, str]) -> None:
    a, b = (SHAPES[name] for name in names)
    poses = random_poses(np.random.default_rng(1), a, b, 30)
    repeated = Repeated()
    repeated.ask(a, b, poses, bt.distance(a, b, poses), 1)
    assert repeated.poses in (3, 30)
    assert repeated.upper_bounds == 10
    assert repeated.crossed == repeated.upper_bounds_wrong == 0
    assert repeated.apart_m <= BRACKET
    assert repeated.overlapping_m <= DEPTH


def test_answers_that_depend_on_the_order_are_seen() -> None:
    a, b = SHAPES["box"], SHAPES["ellipsoid"]
    poses = random_poses(np.random.default_rng(3), a, b, 12)
    found = bt.distance(a, b, poses)
    assert (found.distance > 0.0).any()
    assert (found.distance < 0.0).any()
    # Needles apart were once taken for overlapping: a bracket of -0.2 to -0.1 m for 0.3 m.
    astray = replace(
        found, lower_bound=found.upper_bound - 0.2, upper_bound=found.upper_bound - 0.1
    )
    repeated = Repeated()
    repeated.compare(found, found, 1.0)
    assert repeated.crossed == 0
    repeated.compare(astray, found, 1.0)
    repeated.compare(found, astray, 1.0)
    repeated.compare(found, replace(found, distance=found.distance * np.nan), 1.0)
    assert repeated.crossed == 36
    repeated.compare(found, replace(found, distance=found.distance + 1e-3), 1.0)
    assert repeated.apart_m == pytest.approx(1e-3)
    assert repeated.overlapping_m == pytest.approx(1e-3)


def test_false_upper_bounds_are_seen() -> None:
    a, b = SHAPES["box"], SHAPES["ellipsoid"]
    poses = random_poses(np.random.default_rng(3), a, b, 12)
    found = bt.distance(a, b, poses)
    apart = found.lower_bound > 0.0
    assert not upper_bounds_wrong(found, a, poses[0], b, poses[1]).any()
    low = replace(found, upper_bound=found.upper_bound - 0.1)
    assert upper_bounds_wrong(low, a, poses[0], b, poses[1])[apart].all()
    inwards = replace(found, point_a=found.point_b)
    assert upper_bounds_wrong(inwards, a, poses[0], b, poses[1])[apart].all()
    # A sample of directions sees depths that are far too large.
    deeper = replace(found, upper_bound=found.upper_bound - 10.0)
    assert upper_bounds_wrong(deeper, a, poses[0], b, poses[1]).all()


# One pose each, of these seeds, at which less exact normals and points were off by 3e-5 to 2e-4.
HARD = [
    ("smoothed box", "cylinder", 456),
    pytest.param("cut cylinder", "lampshade", 11, marks=pytest.mark.slow),
]


@pytest.mark.parametrize(("first", "second", "seed"), HARD)
def test_gradients_hold_where_normals_are_hard_to_find(
    first: str, second: str, seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    a, b = SPACE[first], SPACE[second]
    poses = random_poses(np.random.default_rng(seed), a, b, 1)
    error, bend = _distance_checks.gradient_errors(a, b, poses)
    smooth = bend < _distance_checks.KINK
    assert smooth.all()
    assert np.max(error) < GRADIENT

    def off(*given):
        found = bt.distance(*given)
        return replace(found, gradient_b=found.gradient_b + 2e-5)

    monkeypatch.setattr(_distance_checks, "distance", off)
    wrong, _ = _distance_checks.gradient_errors(a, b, poses)
    assert np.min(wrong) > GRADIENT


def test_support_points_are_exact_beside_the_normals_of_faces() -> None:
    """The bracket to a wall is what the support point leaves open. Interior-point methods alone
    leave 1e-8 m where the wall is turned by 1e-9 rad from a face that ends in arcs."""
    shape, rng = SPACE["cut cylinder"], np.random.default_rng(8)
    at = np.array([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0])
    for face in (*TILTED.rotation.T, *-TILTED.rotation.T):
        for angle in (1e-6, 1e-7, 1e-8, 1e-9):
            wall = HalfSpace(face + angle * rng.normal(size=3), -3.0)
            found = bt.distance(shape, wall, at)
            assert found.upper_bound - found.lower_bound < 1e-12


@pytest.mark.parametrize(("seed", "gap_m"), [(37, 0.0), (46, 1e-6)])
def test_sets_that_just_touch_have_narrow_brackets_too(seed: int, gap_m: float) -> None:
    a, b = SPACE["smoothed wedge"], SPACE["lampshade"]
    pose_a, pose_b = random_poses(np.random.default_rng(seed), a, b, 60)
    first = bt.distance(a, b, (pose_a, pose_b))
    moved = pose_b.position - (first.distance - gap_m)[:, None] * first.normal
    found = bt.distance(a, b, (pose_a, bt.Pose(moved, pose_b.rotation)))
    width = (found.upper_bound - found.lower_bound)[found.lower_bound > 0.0]
    assert len(width) > 5
    assert np.max(width) <= BRACKET
    assert np.max(np.abs(found.distance - gap_m)) <= BRACKET


@pytest.mark.parametrize("x", [0.65, 0.68, 0.7])
def test_the_depth_is_that_of_the_nearest_side(x: float) -> None:
    """Newton's method keeps to the side of the pose before, which is a good one of its own."""
    y = np.linspace(0.003, -0.003, 60)
    places = np.stack([np.full_like(y, x), y, np.zeros_like(y)], axis=1)
    turns = np.broadcast_to(np.eye(3), (len(y), 3, 3))
    here, there = Pose(np.zeros_like(places), turns), Pose(places, turns)
    wide, small = bt.Ellipsoid([1.0, 0.5, 0.8]), bt.Ellipsoid([0.05, 0.06, 0.07])
    found = bt.distance(wide, small, there)
    assert np.all(found.normal[:, 1] * y > 0.0)
    assert not np.any(upper_bounds_wrong(found, wide, here, small, there))
    assert np.max(found.upper_bound - found.lower_bound) <= DEPTH


@pytest.mark.parametrize("name", ["superellipsoid cylinder – cube 0.5", "LSE cube 0.5 – ellipsoid"])
def test_depths_hold_all_along_a_path(name: str) -> None:
    """What proves the depth is taken along from pose to pose, and mended."""
    a, b = SMOOTH[name]
    along = pose_law(100_000)[400:800]
    still = np.broadcast_to(np.eye(3), (400, 3, 3))
    found = bt.distance(a, b, along)
    assert np.mean(found.distance < 0.0) > 0.1
    assert not np.any(upper_bounds_wrong(found, a, Pose(0.0 * along.position, still), b, along))
    assert np.max((found.upper_bound - found.lower_bound)[found.distance < 0.0]) <= DEPTH
