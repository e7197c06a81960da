"""States pushed out of what they are too near to, compiled and not."""

from itertools import pairwise, product

import numpy as np
import pytest

import berthing as bt
from berthing.routes.checker import Checker
from berthing.routes.sliding import CompiledSlider, PlainSlider, slider
from berthing.routes.space import between, stride
from support import hand_made
from support.scenes import clutter, states

PAD_M, STEP_M = 1e-3, 0.1

# Damped pushes and truncated ones, after up to eight rounds.
AGREE_M = 5e-3


@pytest.fixture(scope="module", params=["one", "two"])
def both(request):
    checker = Checker(clutter(20, vehicles=1 if request.param == "one" else 2))
    quick = slider(checker, PAD_M, STEP_M)
    assert isinstance(quick, CompiledSlider)
    return checker, quick, PlainSlider(checker, PAD_M, STEP_M)


def excess(checker, state):
    """Of the pair that has the least, by the batches that other tests compare with single pairs."""
    return checker.clearance_of(state).excess_m


def at_depth(checker, count, low, high):
    """States whose excess lies between, found on the way from free ones to overlapping ones."""
    drawn = states(checker, 60)
    good = checker.valid_states(drawn, PAD_M)
    found = []
    for a, b in product(drawn[good], drawn[~good]):
        leg = between(a, b, np.linspace(0.0, 1.0, 40))
        for state in leg[~checker.valid_states(leg, PAD_M)][:2]:
            if low < excess(checker, state) - PAD_M < high:
                found.append(state)
        if len(found) >= count:
            return found
    raise AssertionError("no such states")


def test_states_are_pushed_out_by_little(both):
    checker, quick, plain = both
    for state in at_depth(checker, 4, -2.0 * STEP_M, 0.0):
        one, other = quick.settled(state), plain.settled(state)
        assert excess(checker, one) >= PAD_M - 1e-9
        assert checker.space.length(stride(one, other)) < AGREE_M


def test_what_is_in_too_deep_is_given_up(both):
    checker, quick, plain = both
    deep = at_depth(checker, 1, -np.inf, -3.5 * STEP_M)[0]
    assert quick.settled(deep) is None
    assert plain.settled(deep) is None


def test_extensions_slide_the_same_way(both):
    checker, quick, plain = both
    drawn = states(checker, 20)
    good = drawn[checker.valid_states(drawn, PAD_M)]
    lengths = []
    for a, b in zip(good[:2], good[2:4], strict=True):
        way, met = quick.extended(a, b, whole=True)
        again, also = plain.extended(a, b, whole=True)
        lengths.append(len(way))
        assert met == also
        assert quick.keeps(way[: len(way) - met])
        steps = checker.space.length(stride(np.array([a, *way[:-1]]), way))
        assert np.all(steps < 4.0 * STEP_M)
        if met:
            assert np.array_equal(way[-1], b)
        # Small differences grow along an extension.
        shared = min(len(way), len(again), 10)
        apart = checker.space.length(stride(way[:shared], again[:shared]))
        assert np.all(apart < AGREE_M)
    assert max(lengths) > 10


def test_a_leg_is_blocked_where_a_sample_is(both):
    checker, quick, plain = both
    drawn = states(checker, 40)
    good = drawn[checker.valid_states(drawn, PAD_M)]
    seen = set()
    for a, b in pairwise(good[:11]):
        at = quick.blocked(a, b)
        seen.add(at is None)
        finely = checker.valid_states(between(a, b, np.linspace(0.0, 1.0, 60)[1:-1]), PAD_M)
        if at is None:
            # Stretches of half a step are passed over.
            assert np.mean(finely) > 0.97
        else:
            assert excess(checker, between(a, b, np.array([at]))[0]) < PAD_M
        assert (at is None) == (plain.blocked(a, b) is None)
    assert seen == {True, False}


def test_limits_on_positions_block_too():
    limits = bt.Limits(np.full(6, -1.0), np.full(6, 1.0), np.full(13, -1.0), np.full(13, 1.0))
    craft = hand_made.vehicle(bt.Sphere(0.1), model=hand_made.rigid_body(), limits=limits)
    checker = Checker(hand_made.scenario([craft], []))
    home, within, beyond = (np.array([[0.0, 0.0, z, 1.0, 0.0, 0.0, 0.0]]) for z in (0.0, 0.9, 1.6))
    for own in (slider(checker, PAD_M, STEP_M), PlainSlider(checker, PAD_M, STEP_M)):
        assert own.blocked(home, within) is None
        assert own.blocked(home, beyond) is not None
        assert own.settled(beyond) is None
