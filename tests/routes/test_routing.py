from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

import berthing as bt
from berthing.clearance.separation import separation
from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.geometry.half_space import HalfSpace
from berthing.routes import seeking
from berthing.routes.checker import Checker
from berthing.routes.resting import at_rest
from berthing.routes.routing import route
from berthing.routes.space import stride
from berthing.routes.ways import same_way
from berthing.scenario.motion import ConstantSpin, ConstantVelocity
from support import hand_made

SAMPLES_A_LEG = 40
AGREES_M = 1e-8


def least_distance(whole, states):
    """Over all legs and pairs at rest or not, by slerp and lines written here."""
    found = np.inf
    vehicles = whole.phases[0].vehicles
    for one, other in pairwise(states):
        for s in np.linspace(0.0, 1.0, SAMPLES_A_LEG):
            frames = {}
            for own, a, b in zip(vehicles, one, other, strict=True):
                q = quaternion.slerp(a[3:], b[3:], s)
                frames[own.name] = bt.Pose.from_quaternion((1.0 - s) * a[:3] + s * b[:3], q)
            for structure in whole.structures:
                frames[structure.name] = structure.motion.pose(np.zeros(1))[0]
            for pair in whole.pairs(whole.phases[0]):
                a = frames[pair.owner_a.name].compose(pair.part_a.placement)
                b = frames[pair.owner_b.name].compose(pair.part_b.placement)
                near = separation(pair.part_a.shape, a, pair.part_b.shape, b)
                found = min(found, near.distance)
    return found


def ends(vehicle):
    return [
        np.append(end.position_m, end.attitude.nominal()) for end in (vehicle.start, vehicle.goal)
    ]


def boxed_in():
    """A point that cannot get out of a closed box of six walls, to a goal outside."""
    sizes = 2.0 * np.ones((6, 3)) - 1.8 * np.repeat(np.eye(3), 2, axis=0)
    at = [hand_made.placed(side * 1.9 * axis) for axis in np.eye(3) for side in (-1.0, 1.0)]
    wall = hand_made.structure(*(bt.Box(size) for size in sizes), at=at)
    goal = bt.End(np.array([4.0, 0.0, 0.0]))
    return hand_made.scenario([hand_made.vehicle(bt.Sphere(0.2), goal=goal)], [wall])


@pytest.mark.slow
@pytest.mark.parametrize("name", ["scenario-b-tight", "two-vehicles-swap"])
def test_a_route_keeps_the_margin_all_the_way(name):
    whole = bt.load(name)
    found = route(whole, seed=3)
    assert found.outcome == "certified"
    (own,) = found.routes
    assert own.legs.certified
    assert own.clearance_m >= whole.margins.default_m
    sampled = least_distance(whole, own.states)
    assert own.clearance_m <= sampled + AGREES_M
    for i, vehicle in enumerate(whole.phases[0].vehicles):
        for state, wanted in zip(own.states[[0, -1], i], ends(vehicle), strict=True):
            assert np.allclose(state, wanted)
    checker = Checker(whole)
    assert own.length_m == pytest.approx(
        np.sum(checker.space.length(stride(own.states[:-1], own.states[1:])))
    )
    again = checker.legs(own.states)
    assert np.array_equal(again.bound_m, own.legs.bound_m)


@pytest.fixture(scope="module")
def tight():
    """The case, and its route of seed 1."""
    whole = bt.load("scenario-b-tight")
    return whole, route(whole, seed=1).routes[0]


def test_a_leg_through_the_wall_is_refused(tight):
    whole, own = tight
    through = own.states.copy()
    through[-2, 0, :3] = [9.5, 2.0, 0.0]
    found = Checker(whole).legs(through)
    assert not found.certified
    assert "T1.box" in " ".join(found.faults)


def test_the_same_seed_gives_the_same_route_and_another_another(tight):
    whole, own = tight
    one = own.states
    again, other = (route(whole, seed=seed).routes[0].states for seed in (1, 2))
    assert np.array_equal(one, again)
    assert one.shape != other.shape or not np.allclose(one, other)


@pytest.mark.slow
def test_ways_that_differ_pass_on_other_sides():
    whole = bt.load("scenario-a")
    found = route(whole, seed=0, classes=2)
    assert len(found.routes) == 2
    checker = Checker(whole)
    states = [own.states for own in found.routes]
    for i, one in enumerate(states):
        assert same_way(checker, one, one)
        assert not any(same_way(checker, one, other) for other in states[:i])
    # A detour that is swept back with nothing in between is no other way.
    detour = states[0].copy()
    detour[1, 0, 0] -= 0.5
    assert same_way(checker, states[0], detour)


def test_where_there_is_one_way_only_one_is_found():
    whole = bt.load("free-space")
    found = route(whole, classes=2)
    assert len(found.routes) == 1
    assert {own.found for own in found.searches} == {"way", "known"}


@pytest.mark.slow
def test_what_cannot_be_left_has_no_route(monkeypatch):
    monkeypatch.setattr(seeking, "LADDER", ((0, 1.0, 10), (1, 0.5, 10)))
    found = route(boxed_in())
    assert found.outcome == "iteration_limit"
    assert found.routes == ()
    assert [own.found for own in found.searches] == ["nothing", "nothing"]
    late = route(boxed_in(), time_limit_s=1e-3)
    assert late.outcome == "time_limit"


def test_an_end_that_may_turn_is_turned_out_of_the_way():
    slot = hand_made.structure(
        bt.Box(np.array([4.0, 1.0, 4.0])), bt.Box(np.array([4.0, 1.0, 4.0])),
        at=[hand_made.placed([0.0, y, 0.0]) for y in (-1.6, 1.6)],
    )  # fmt: skip
    start = bt.End(np.array([-8.0, 0.0, 0.0]))
    long = bt.Box(np.array([0.3, 1.0, 0.3]))
    free = bt.End(np.zeros(3), attitude=bt.FreeAttitude())
    fixed = bt.End(np.zeros(3))
    whole = hand_made.scenario([hand_made.vehicle(long, start=start, goal=free)], [slot])
    (own,) = route(whole).routes
    assert own.clearance_m >= 0.1
    stuck = hand_made.scenario([hand_made.vehicle(long, start=start, goal=fixed)], [slot])
    with pytest.raises(InputError, match="overlaps"):
        route(stuck)


def test_the_largest_margin_counts_at_the_ends():
    override = bt.MarginOverride("craft", "wall", 2.0, (4.0, 6.0))
    wall = hand_made.structure(bt.Box(np.ones(3)), at=[hand_made.placed([5.0, 3.0, 0.0])])
    goal = bt.End(np.array([5.0, 0.0, 0.0]))
    policy = bt.MarginPolicy(0.1, (override,))
    whole = hand_made.scenario([hand_made.vehicle(bt.Box(np.ones(3)), goal=goal)], [wall], policy)
    with pytest.raises(InputError, match="largest margin"):
        route(whole)


def test_a_structure_that_moves_alone_is_its_own_frame():
    whole = bt.load("spinning-structure")
    found = route(whole)
    assert found.frame == "truss"
    still, _ = at_rest(whole)
    (own,) = found.routes
    assert own.clearance_m <= least_distance(still, own.states) + AGREES_M
    assert np.allclose(own.states[0, 0], [-9, 0, 0, 1, 0, 0, 0])
    assert np.allclose(own.states[-1, 0, :3], [2, -1.2, 0])


def moving(law, goal_frame="wall", extra=(), **options):
    wall = hand_made.structure(bt.Box(np.ones(3)), motion=law)
    goal = bt.End(np.array([0.0, 5.0, 0.0]), frame=goal_frame)
    start = bt.End(np.array([6.0, 0.0, 0.0]))
    craft = hand_made.vehicle(bt.Box(np.ones(3)), start=start, goal=goal, **options)
    return hand_made.scenario([craft], [wall, *extra])


ALONG_Y, ABOUT_Z = np.array([0.0, 0.1, 0.0]), np.array([0.0, 0.0, 1.0])
SPIN = ConstantSpin(bt.Pose.identity(), ABOUT_Z, 0.1, ALONG_Y)
DRIFT = ConstantVelocity(bt.Pose.identity(), ALONG_Y)


def test_starts_are_seen_from_the_frame():
    turned = bt.Pose.from_quaternion(
        np.array([1.0, 0.0, 0.0]), np.array([np.sqrt(0.5), 0, 0, np.sqrt(0.5)])
    )
    still, frame = at_rest(moving(replace(SPIN, pose0=turned)))
    start = still.phases[0].vehicles[0].start
    assert frame == "wall"
    assert np.allclose(start.position_m, [0.0, -5.0, 0.0])
    assert np.allclose(
        quaternion.rotation_matrix(start.attitude.nominal()), turned.rotation.T, atol=1e-12
    )


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: moving(SPIN, goal_frame=None), "not in the frame of wall"),
        (lambda: moving(DRIFT, extra=[hand_made.structure(bt.Sphere(1.0), name="rock")]), "moves"),
        (lambda: moving(SPIN, model=bt.PointMass(1.0, 3)), "does not turn"),
        (
            lambda: moving(
                SPIN, limits=bt.Limits(-np.ones(6), np.ones(6), -9 * np.ones(13), 9 * np.ones(13))
            ),
            "limits on its position",
        ),
    ],
)
def test_motion_that_no_frame_stops_is_refused(make, says):
    with pytest.raises(InputError, match=says):
        route(make())


def test_a_start_that_is_the_goal_is_a_route():
    whole = hand_made.scenario([hand_made.vehicle(bt.Sphere(0.5))], [])
    (own,) = route(whole).routes
    assert own.length_m == 0.0
    assert own.clearance_m == np.inf


def test_options_and_phases_that_are_refused():
    whole = bt.load("free-space")
    with pytest.raises(InputError, match="classes: is 0"):
        route(whole, classes=0)
    with pytest.raises(InputError, match="time_limit_s"):
        route(whole, time_limit_s=0.0)
    twice = replace(whole, phases=(*whole.phases, replace(whole.phases[0], name="next")))
    with pytest.raises(InputError, match="2 phases"):
        route(twice)


def test_a_ground_without_end_is_kept_clear_of():
    ground = hand_made.structure(HalfSpace(np.array([0.0, 0.0, 1.0]), -1.0), name="ground")
    rock = hand_made.structure(
        bt.Box(np.array([1.0, 9.0, 1.0])), name="rock", at=[hand_made.placed([4.0, 0.0, -0.5])]
    )
    goal = bt.End(np.array([8.0, 0.0, 0.0]))
    whole = hand_made.scenario([hand_made.vehicle(bt.Sphere(0.5), goal=goal)], [ground, rock])
    (own,) = route(whole).routes
    assert own.clearance_m >= 0.1
    assert np.all(own.states[:, 0, 2] >= -0.4)
    assert np.max(own.states[:, 0, 2]) >= 1.0
