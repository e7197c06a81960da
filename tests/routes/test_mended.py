"""Paths that are clear at states and not in between."""

import numpy as np
import pytest

import berthing as bt
from berthing.routes.checker import Checker
from berthing.routes.mended import sampled
from berthing.routes.sliding import slider
from support import hand_made

STEP_M, PAD_M = 0.1, 1e-3


@pytest.fixture(scope="module")
def post():
    """A ball 2 m across, which the path of a small one goes around."""
    wall = hand_made.structure(bt.Sphere(1.0))
    checker = Checker(hand_made.scenario([hand_made.vehicle(bt.Sphere(0.1))], [wall]))
    return checker, slider(checker, PAD_M, STEP_M)


def around(*degrees):
    """States at 1.3 m of the middle, 0.1 m more than what the margin leaves."""
    angles = np.radians(degrees)
    path = np.zeros((len(angles), 1, 7))
    path[:, 0, 0], path[:, 0, 1], path[:, 0, 3] = 1.3 * np.cos(angles), 1.3 * np.sin(angles), 1.0
    return path


def test_a_leg_that_cuts_a_corner_is_led_around_it(post):
    checker, slides = post
    path = around(0.0, 30.0, 90.0)
    assert slides.blocked(path[1], path[2], lax=0.1) is not None
    mended = sampled(slides, path)
    assert len(mended) > len(path)
    assert np.array_equal(mended[[0, -1]], path[[0, -1]])
    between = 0.5 * (mended[1:] + mended[:-1])
    assert np.all(checker.valid_states(between, PAD_M - 0.2 * STEP_M))


def test_a_leg_that_is_clear_is_left_alone(post):
    _, slides = post
    path = around(0.0, 30.0, 60.0)
    assert np.array_equal(sampled(slides, path), path)


def test_a_leg_through_the_middle_is_given_up(post):
    _, slides = post
    assert sampled(slides, around(0.0, 180.0)) is None
