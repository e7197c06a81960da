"""Searches that are told how far around they may go."""

import time

import numpy as np
import pytest

import berthing as bt
from berthing.routes.checker import Checker
from berthing.routes.region import Region
from berthing.routes.seeking import Seeker
from berthing.routes.sliding import slider
from berthing.routes.trees import Trees
from support import hand_made

FAR_M = 6.0


@pytest.fixture(scope="module")
def windowed():
    """A wall 12 m wide with a window 1.4 m wide in its middle, and a ball on each side of it."""
    sides = [hand_made.placed([3.0, y, 0.0]) for y in (-3.35, 3.35)]
    lintels = [hand_made.placed([3.0, 0.0, z]) for z in (-3.35, 3.35)]
    high, wide = np.array([0.1, 2.65, FAR_M]), np.array([0.1, 0.7, 2.65])
    wall = hand_made.structure(
        bt.Box(high), bt.Box(high), bt.Box(wide), bt.Box(wide), at=[*sides, *lintels]
    )
    goal = bt.End(np.array([6.0, 0.0, 0.0]))
    return Checker(hand_made.scenario([hand_made.vehicle(bt.Sphere(0.4), goal=goal)], [wall]))


def state(x):
    return np.array([[x, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]])


@pytest.mark.parametrize("detour", [0.2, 0.5])
def test_draws_are_where_ways_are_no_longer(windowed, detour):
    start, goal = state(0.0), state(6.0)
    region = Region.of(windowed, start, goal)
    narrow = Region(region.lower_m, region.upper_m, region.step_m, region.pads_m, detour)
    slides = slider(windowed, region.pads_m[0], region.step_m)
    trees = Trees(windowed.space, slides, narrow, np.random.default_rng(0), np.inf)
    trees.path(start, goal, 1)
    drawn = np.array([trees._drawn()[0, :3] for _ in range(400)])
    ways = sum(np.linalg.norm(drawn - end[0, :3], axis=1) for end in (start, goal))
    most = 6.0 + 2.0 * detour * (3.0 + windowed.space.arm_m[0])
    assert 0.95 * most < np.max(ways) <= most * (1.0 + 1e-12)


def test_with_little_detour_a_route_leads_through_the_window(windowed):
    seeker = Seeker(windowed, state(0.0), state(6.0), shortcuts=0)
    for number in range(3):
        (first, *_) = seeker.searches(0, number, time.monotonic() + 60.0, 0.3)
        path = first.paths[0]
        across = path[np.argmin(np.abs(path[:, 0, 0] - 3.0)), 0, 1:3]
        assert np.all(np.abs(across) < 1.0)
