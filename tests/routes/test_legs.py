import numpy as np
import pytest

import berthing as bt
from berthing.errors import InputError
from berthing.geometry import quaternion
from berthing.routes.checker import Checker
from berthing.routes.legs import LegProver, certify_legs
from berthing.routes.space import between, moved
from berthing.verify.leg_motion import LegMotion
from support import hand_made

START = [0.0, 0.0, 0.0, np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)]
TURNED = [4.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
GOAL = [9.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
MARGIN_M, ROOM_M = 0.1, 0.25
THIN_M = 2e-4


@pytest.fixture(scope="module")
def tight():
    return Checker(bt.load("scenario-b-tight"))


def test_a_turn_and_then_straight_in_is_proven_leg_by_leg(tight):
    found = tight.legs(tight.states(np.array([START, TURNED, GOAL])))
    assert found.certified
    assert found.faults == found.trouble == ()
    # A bound is proven, and no more is asked of it than the margin.
    assert np.all(found.bound_m >= MARGIN_M)
    assert found.bound_m[1] <= ROOM_M
    assert found.closest[2] == pytest.approx(ROOM_M, abs=1e-6)
    assert np.allclose(found.excess_m, found.bound_m - MARGIN_M)
    assert found.closest[0].startswith("spacecraft.hull|")


def test_turning_in_the_mouth_is_refused(tight):
    found = tight.motion([4.5, 0, 0, *START[3:]], GOAL)
    assert not found.certified
    assert found.excess_m[0] < 0.0
    assert "spacecraft.hull" in found.faults[0]
    assert "leg 0." in found.faults[0]
    assert all(0.0 < t < 1.0 for t in found.trouble)


def test_many_motions_are_judged_as_each_by_itself(tight):
    rng = np.random.default_rng(7)
    low, high = np.array([-3.0, -6.0, -6.0]), np.array([16.0, 6.0, 6.0])
    drawn = np.array([tight.space.sample(rng, low, high) for _ in range(40)])
    free = drawn[tight.valid_states(drawn)]
    ends = moved(free, 0.3 * rng.normal(size=(len(free), 1, 6)))
    together = tight.motion(free[:, 0], ends[:, 0])
    prover = LegProver(tight.scenario, tight.phase)
    verdicts = [
        (tight.motion(a[0], b[0]).certified, prover.clear(a, b))
        for a, b in zip(free, ends, strict=True)
    ]
    assert verdicts == [(bool(good), bool(good)) for good in together.excess_m >= 0.0]
    assert 0 < np.sum(together.excess_m >= 0.0) < len(free)
    from_one = tight.motion(START, ends[:, 0])
    assert len(from_one.bound_m) == len(ends)


def test_batches_that_do_not_fit_are_refused(tight):
    home = np.array(START)
    for one, other in ((np.tile(home, (2, 1)), np.tile(home, (3, 1))),
                       (np.tile(home, (2, 2, 1)), home), (np.empty((0, 7)), home)):  # fmt: skip
        with pytest.raises(InputError, match=r"Checker\.motion"):
            tight.motion(one, other)


def test_a_wall_between_two_samples_is_seen():
    """Thinner than any sampling would catch, with both ends and the middle far from it."""
    sheet = hand_made.structure(
        bt.Box(np.array([0.5 * THIN_M, 3.0, 3.0])), at=[hand_made.placed([1.2345, 0, 0])]
    )
    craft = hand_made.vehicle(bt.Sphere(0.01))
    checker = Checker(hand_made.scenario([craft], [sheet], margins=1e-4))
    here, there = ([x, 0, 0, 1, 0, 0, 0] for x in (0.0, 4.0))
    path = between(checker.states(here), checker.states(there), np.linspace(0.0, 1.0, 65))
    assert np.all(checker.valid_states(path))
    found = checker.motion(here, there)
    assert not found.certified
    assert found.trouble[0] == pytest.approx(1.2345 / 4.0, abs=0.01)
    around = [[0, 0, 0, 1, 0, 0, 0], [0, 3.2, 0, 1, 0, 0, 0], [4, 3.2, 0, 1, 0, 0, 0], there]
    assert checker.legs(checker.states(np.array(around))).certified


def test_a_missing_structure_makes_the_refused_leg_pass(tight):
    whole = tight.scenario
    without = bt.Scenario("open", "", whole.phases, whole.structures[1:2], whole.margins)
    assert Checker(without).motion([4.5, 0, 0, *START[3:]], GOAL).certified


@pytest.mark.parametrize("seed", range(3))
def test_bounds_lie_below_what_is_sampled_and_not_far(tight, seed):
    rng = np.random.default_rng(seed)
    low, high = np.array([-3.0, -6.0, -6.0]), np.array([16.0, 6.0, 6.0])
    drawn = [tight.space.sample(rng, low, high) for _ in range(30)]
    free = [state for state in drawn if tight.valid_state(state)]
    states = np.array(free)
    found = tight.legs(states)
    for i in range(len(states) - 1):
        path = between(states[i], states[i + 1], np.linspace(0.0, 1.0, 101))
        near = tight.near(path, 20.0)
        assert found.bound_m[i] <= np.min(near.distance) + 1e-9
        if found.excess_m[i] >= 0.0:
            assert np.all(tight.valid_states(path))


def test_vehicles_that_pass_through_each_other_are_refused():
    checker = Checker(bt.load("two-vehicles-swap"))
    here, there = [-6, 0, 4, 1, 0, 0, 0], [6, 0, 4, 1, 0, 0, 0]
    assert checker.motion({"alpha": here, "beta": [6, 0, 8, 1, 0, 0, 0]},
                          {"alpha": there, "beta": [-6, 0, 8, 1, 0, 0, 0]}).certified  # fmt: skip
    found = checker.motion({"alpha": here, "beta": there}, {"alpha": there, "beta": here})
    assert not found.certified
    assert "alpha.hull, beta.hull" in found.faults[0]


def test_half_a_turn_has_no_shorter_way(tight):
    with pytest.raises(InputError, match="either way"):
        tight.motion([0, 0, 0, 1, 0, 0, 0], [0, 0, 0, 0, 1, 0, 0])


def test_what_moves_is_refused():
    whole = bt.load("spinning-structure")
    states = np.tile([0.0, 8.0, 0.0, 1.0, 0.0, 0.0, 0.0], (2, 1, 1))
    with pytest.raises(InputError, match="truss: moves"):
        certify_legs(whole, whole.phases[0], states[:1], states[1:])


def test_the_frame_of_a_leg_is_that_of_its_states():
    rng = np.random.default_rng(4)
    q = quaternion.normalise(rng.normal(size=(6, 4)))
    r = rng.normal(size=(6, 3))
    states = np.concatenate([r, q], axis=1)
    motion = LegMotion(states[:-1], states[1:])
    for side in (0, 1):
        cells = np.arange(5)
        jet = motion.jet(cells + float(side), cells)
        assert np.allclose(jet.position, r[cells + side])
        assert np.allclose(jet.rotation, quaternion.rotation_matrix(q[cells + side]), atol=1e-12)
    step = 1e-6
    cells = np.arange(5)
    before, after = (motion.jet(cells + 0.3 + e, cells).rotation for e in (-step, step))
    middle = motion.jet(cells + 0.3, cells)
    spin = (after - before) / (2.0 * step) @ np.swapaxes(middle.rotation, 1, 2)
    seen = np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], axis=1)
    assert np.allclose(seen, middle.rate, atol=1e-8)
    assert np.allclose(motion.ceilings.rate, np.linalg.norm(middle.rate, axis=1))
