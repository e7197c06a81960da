import numpy as np
import pytest

import berthing as bt
from berthing.errors import InputError
from berthing.routes.broad_phase import FEW
from berthing.routes.checker import Checker
from berthing.routes.space import between, moved, stride
from berthing.scenario.motion import ConstantVelocity
from support import hand_made
from support.scenes import clutter, least_excess, states

AGREES_M = 1e-8
"""Two implementations of one distance."""


def tight():
    return bt.load("scenario-b-tight")


@pytest.mark.parametrize(
    ("make", "count"),
    [(tight, 40), (lambda: clutter(FEW + 6), 12), (lambda: clutter(20, vehicles=2), 20)],
    ids=["tight", "clutter", "two vehicles"],
)
def test_it_says_what_every_pair_says(make, count):
    checker = Checker(make())
    many = states(checker, count)
    truth = np.array([least_excess(checker, state) for state in many])
    assert 0 < np.sum(truth > 0.0) < len(truth)
    assert np.array_equal(checker.valid_states(many), truth >= 0.0)
    assert [checker.valid_state(state) for state in many] == (truth >= 0.0).tolist()
    for state, excess in zip(many[:10], truth[:10], strict=True):
        poses = {v.name: row for v, row in zip(checker.vehicles, state, strict=True)}
        found = checker.clearance(poses)
        if excess > 0.0:
            assert found.excess_m == pytest.approx(excess, abs=AGREES_M)
        assert found.excess_m == found.distance_m - found.required_m
        assert checker.valid(poses) == (excess >= 0.0)


def test_what_is_dropped_from_the_scenario_is_missed():
    whole = tight()
    without = bt.Scenario(
        whole.name, "", whole.phases, whole.structures[1:], whole.margins, document=whole.document
    )
    beside = [9.5, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0]
    assert not Checker(whole).valid(beside)
    assert Checker(without).valid(beside)
    assert Checker(whole).clearance(beside).pair == "spacecraft.hull|T1.box"
    nothing = bt.Scenario("empty", "", whole.phases, (), whole.margins)
    assert Checker(nothing).clearance(beside).excess_m == np.inf
    assert Checker(nothing).valid(beside)


def test_gradients_are_those_of_the_distance():
    checker = Checker(clutter(30))
    apart = states(checker, 60)
    apart = apart[checker.valid_states(apart)][:5]
    found = checker.near(apart, 0.5, gradients=True)
    step = 1e-5
    for at, pair, gradient in zip(found.state, found.pair, found.gradient, strict=True):
        for axis in range(6):
            by = np.zeros((1, 6))
            by[0, axis] = step
            both = np.stack([moved(apart[at], by), moved(apart[at], -by)])
            near = checker.near(both, 0.6)
            values = near.distance[near.pair == pair]
            slope = (values[0] - values[1]) / (2.0 * step)
            assert gradient[0, axis] == pytest.approx(slope, abs=1e-4)


def test_structures_move_and_margins_change_with_time():
    law = ConstantVelocity(bt.Pose.identity(), np.array([1.0, 0.0, 0.0]))
    wall = hand_made.structure(bt.Box(np.ones(3)), motion=law)
    override = bt.MarginOverride("craft", "wall", None, (4.0, 6.0))
    policy = bt.MarginPolicy(0.1, (override,))
    whole = hand_made.scenario([hand_made.vehicle(bt.Box(np.ones(3)))], [wall], policy)
    here = [3.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
    assert Checker(whole, time_s=0.0).clearance(here).excess_m == pytest.approx(0.9)
    assert not Checker(whole, time_s=3.0).valid(here)
    assert Checker(whole, time_s=5.0).clearance(here).pair is None
    with pytest.raises(InputError, match="moves"):
        Checker(whole)
    with pytest.raises(InputError, match="knows the time"):
        Checker(whole, time_s=0.0).motion(here, here)


def test_a_state_for_all_times_keeps_the_largest_margin():
    override = bt.MarginOverride("craft", "wall", 0.5, (4.0, 6.0))
    wall = hand_made.structure(bt.Box(np.ones(3)))
    policy = bt.MarginPolicy(0.1, (override,))
    whole = hand_made.scenario([hand_made.vehicle(bt.Box(np.ones(3)))], [wall], policy)
    here = [2.3, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
    assert Checker(whole, time_s=0.0).valid(here)
    assert not Checker(whole).valid(here)


def test_limits_on_positions_count():
    model = hand_made.rigid_body()
    limits = bt.Limits(np.full(6, -1.0), np.full(6, 1.0), np.full(13, -1.0), np.full(13, 1.0))
    craft = hand_made.vehicle(bt.Sphere(0.1), model=model, limits=limits)
    checker = Checker(hand_made.scenario([craft], []))
    assert checker.valid([0.9, 0, 0, 1, 0, 0, 0])
    assert checker.valid([[0.9, 0, 0, 1, 0, 0, 0], [1.1, 0, 0, 1, 0, 0, 0]]).tolist() == [
        True,
        False,
    ]


def test_the_plane_is_a_special_case_of_space():
    checker = Checker(bt.load("piano-mover"))
    assert checker.clearance([1.5, 1.5, 0.0]).excess_m == pytest.approx(0.415, abs=1e-6)
    assert checker.valid(bt.Pose.planar(np.array([1.5, 1.5]), 0.0))
    assert not checker.valid([1.5, 1.5, 1.0])
    rng = np.random.default_rng(1)
    drawn = checker.space.sample(rng, np.zeros(3), np.ones(3))
    assert np.all(drawn[:, [2, 4, 5]] == 0.0)


@pytest.mark.parametrize(
    ("poses", "says"),
    [
        ([0, 0, 0, 1, 0, 0, np.nan], "NaN"),
        ([0, 0, 0, 2, 0, 0, 0], "length 2"),
        ([0, 0, 0.5], r"shape \(3,\)"),
        (bt.Pose.identity(2), "2 dimensions"),
        ({"tug": [0, 0, 0, 1, 0, 0, 0]}, "tug"),
        ("here", "neither"),
    ],
)
def test_poses_that_are_none_are_refused(poses, says):
    checker = Checker(tight())
    with pytest.raises(InputError, match=says):
        checker.valid(poses)
    with pytest.raises(InputError, match=says):
        checker.clearance(poses)


def test_what_else_is_refused():
    checker, home = Checker(tight()), [0, 0, 0, 1, 0, 0, 0]
    with pytest.raises(InputError, match="batch"):
        checker.clearance([home, home])
    with pytest.raises(InputError, match="time_s"):
        Checker(tight(), time_s=np.nan)
    with pytest.raises(InputError, match="a mapping"):
        Checker(bt.load("two-vehicles-swap")).valid(home)
    with pytest.raises(InputError, match=r"positive|half"):
        hand_made.vehicle(bt.Box(np.array([1.0, 0.0, 1.0])))


def test_a_stride_leads_where_it_says():
    checker = Checker(bt.load("two-vehicles-swap"))
    one, other = states(checker, 2)
    assert np.allclose(between(one, other, np.array([0.0]))[0], one)
    there = between(one, other, np.array([1.0]))[0]
    assert np.allclose(stride(there, other), 0.0, atol=1e-12)
    assert checker.space.length(stride(one, one)) == 0.0
