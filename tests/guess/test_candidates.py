"""Which paths are tried, and that they lead where they say."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.geometry import quaternion
from berthing.geometry.body import Body, Part
from berthing.geometry.box import Box
from berthing.geometry.pose import Pose
from berthing.guess.candidates import _sides, body_support, candidates
from berthing.guess.path import Guess
from berthing.scenario.files import load
from berthing.scenario.scenario import Scenario
from support.documents import box, puck, scenario, spacecraft, structure

BLOCK = structure("block", [5, 0, 0], box(2, 6, 6))
SHIPPED = ["scenario-a", "scenario-b", "scenario-b-tight"]


def made(given: Scenario, seed: int = 0) -> dict[str, Guess]:
    guesses = candidates(given, given.phases[0], seed)
    assert len({guess.name for guess in guesses}) == len(guesses)
    return {guess.name: guess for guess in guesses}


def middle(guess: Guess, vehicle: str = "spacecraft") -> np.ndarray:
    positions = guess.paths[vehicle].positions_m
    assert len(positions) == 3
    return positions[1]


def test_in_free_space_straight_is_all() -> None:
    assert list(made(scenario())) == ["straight"]


@pytest.mark.parametrize("name", SHIPPED)
def test_every_path_leads_from_start_to_goal(name) -> None:
    given = load(name)
    vehicle = given.phases[0].vehicles[0]
    guesses = made(given)
    assert len(guesses) >= 6
    for guess in guesses.values():
        path = guess.paths[vehicle.name]
        np.testing.assert_allclose(path.positions_m[0], vehicle.start.position_m)
        np.testing.assert_allclose(path.positions_m[-1], vehicle.goal.position_m)
        assert vehicle.start.attitude.error_rad(path.q_IB[0]) < 1e-7
        assert vehicle.goal.attitude.error_rad(path.q_IB[-1]) < 1e-7
        np.testing.assert_allclose(np.linalg.norm(path.q_IB, axis=1), 1.0, atol=1e-12)


def test_a_seed_gives_the_same_guesses_again_and_another_others() -> None:
    given = scenario(structures=[BLOCK])
    first, again, other = made(given, 3), made(given, 3), made(given, 4)
    assert list(first) == list(again) == list(other)
    for name, guess in first.items():
        same = np.array_equal(
            guess.paths["spacecraft"].positions_m, other[name].paths["spacecraft"].positions_m
        )
        assert same != name.startswith("random")
        for kind in ("positions_m", "q_IB"):
            mine, theirs = (getattr(g[name].paths["spacecraft"], kind) for g in (first, again))
            np.testing.assert_array_equal(mine, theirs)


@pytest.mark.parametrize(
    "along", [[1, 0, 0], [0, 0, -1], [1, 1, 1], [0.2, -0.9, 0.1], [0, 1], [3, -1]], ids=str
)
def test_sides_are_across_the_way_and_opposite_in_pairs(along) -> None:
    way = np.array(along, dtype=float) / np.linalg.norm(along)
    sides = dict(_sides(way))
    assert len(sides) == 2 * (len(way) - 1)
    for label, side in sides.items():
        assert np.linalg.norm(side) == pytest.approx(1.0)
        assert side @ way == pytest.approx(0.0, abs=1e-12)
        opposite = ("-" if label[0] == "+" else "+") + label[1]
        np.testing.assert_allclose(sides[opposite], -side)
        # A side is near the axis that it is named after.
        assert side["xyz".index(label[1])] * (1 if label[0] == "+" else -1) > 0.5
    if len(way) == 3:
        across = [side for label, side in sides.items() if label[0] == "+"]
        assert across[0] @ across[1] == pytest.approx(0.0, abs=1e-12)


def test_the_way_around_clears_the_thing_by_its_margin_and_no_more() -> None:
    guesses = made(scenario(structures=[BLOCK]))
    # Half the block, half the hull, the margin.
    np.testing.assert_allclose(middle(guesses["+y past block"]), [5, 3 + 1 + 0.1, 0])
    np.testing.assert_allclose(middle(guesses["-z past block"]), [5, 0, -(3 + 1 + 0.1)])
    assert {name for name in guesses if "past" in name} == {
        f"{side} past block" for side in ("+y", "-y", "+z", "-z")
    }


def test_the_way_around_passes_the_thing_wherever_its_frame_lies() -> None:
    # The same block, its frame 30 m away from it.
    far = structure("block", [5, 0, 30], box(2, 6, 6))
    far["parts"][0]["position_m"] = [0, 0, -30]
    near, moved = made(scenario(structures=[BLOCK])), made(scenario(structures=[far]))
    assert list(near) == list(moved)
    for name, guess in near.items():
        path, other = guess.paths["spacecraft"], moved[name].paths["spacecraft"]
        np.testing.assert_allclose(path.positions_m, other.positions_m, atol=1e-12)


def test_things_are_met_where_they_are_at_half_time() -> None:
    drifting = BLOCK | {"motion": {"type": "constant-velocity", "velocity_m_s": [0, 0.1, 0]}}
    guesses = made(scenario(structures=[drifting]))
    np.testing.assert_allclose(middle(guesses["+z past block"]), [5, 5, 4.1])


def test_the_nearest_three_things_are_gone_around_nearest_first() -> None:
    things = [structure(f"at{y}", [5, y, 0], box(1, 1, 1)) for y in (7, 2, 8, 5)]
    names = [name for name in made(scenario(structures=things)) if "past" in name]
    assert [name.split(" past ")[1] for name in names] == ["at2"] * 4 + ["at5"] * 4 + ["at7"] * 4


def test_what_is_far_from_the_way_is_not_gone_around() -> None:
    things = [structure(f"at{y}", [5, y, 0], box(1, 1, 1)) for y in (2, 12)]
    names = [name for name in made(scenario(structures=things)) if "past" in name]
    assert [name.split(" past ")[1] for name in names] == ["at2"] * 4


def test_random_middles_lie_in_the_box_around_everything() -> None:
    # Far from the origin, which is no part of it.
    away = np.array([100.0, 200.0, -50.0])
    goal, at = (away + np.array([x, 0.0, 0.0]) for x in (10.0, 5.0))
    vehicle = spacecraft(start={"position_m": away.tolist()}, goal={"position_m": goal.tolist()})
    thing = structure("block", at.tolist(), box(2, 6, 6))
    given = scenario(vehicle, structures=[thing])
    drawn = [
        middle(guess) - away
        for seed in range(40)
        for name, guess in made(given, seed).items()
        if name.startswith("random")
    ]
    assert np.all(np.min(drawn, axis=0) >= [-1, -4, -4])
    assert np.all(np.max(drawn, axis=0) <= [11, 4, 4])
    # And they fill it.
    assert np.all(np.ptp(drawn, axis=0) > [9, 6, 6])


def test_the_long_side_is_turned_along_the_way() -> None:
    vehicle = spacecraft(goal={"position_m": [0, 10, 0]})
    guess = made(scenario(vehicle, structures=[structure("block", [0, 5, 0], box(6, 2, 6))]))[
        "turned along the way"
    ]
    q = guess.paths["spacecraft"].q_IB[1]
    long_side = quaternion.rotation_matrix(q) @ [1.0, 0.0, 0.0]
    assert abs(long_side @ [0.0, 1.0, 0.0]) == pytest.approx(1.0)
    # Where it lies that way already it stays.
    ahead = made(scenario(structures=[BLOCK]))["turned along the way"]
    np.testing.assert_allclose(ahead.paths["spacecraft"].q_IB[1], [1, 0, 0, 0])


def test_a_point_mass_is_not_turned_and_a_plane_has_two_sides() -> None:
    names = list(made(scenario(puck(), structures=[structure("wall", [3, 0], box(1, 1))])))
    assert "turned along the way" not in names
    assert [name for name in names if "past" in name] == ["+y past wall", "-y past wall"]


def test_two_vehicles_make_room_for_each_other() -> None:
    other = puck("other", start={"position_m": [6, 0]}, goal={"position_m": [0, 0]})
    guesses = made(scenario(puck(), other))
    apart = guesses["apart +y"]
    one, two = (middle(apart, name) for name in ("puck", "other"))
    np.testing.assert_allclose(one, [3, 0.5])
    np.testing.assert_allclose(two, [3, -0.5])


def test_vehicles_that_cross_go_around_things_all_the_same() -> None:
    # The second one's way has other sides than the first one's.
    other = puck("other", start={"position_m": [3, -6]}, goal={"position_m": [3, 6]})
    guesses = made(scenario(puck(), other, structures=[structure("wall", [3, 0], box(1, 1))]))
    past = guesses["+y past wall"]
    np.testing.assert_allclose(middle(past, "puck"), [3, 0.5 + 0.5 + 0.1])
    assert np.isfinite(middle(past, "other")).all()


def test_a_goal_of_the_other_sign_is_approached_the_shorter_way() -> None:
    vehicle = spacecraft(goal={"position_m": [10, 0, 0], "attitude": [-1, 0, 0, 0]})
    q = made(scenario(vehicle))["straight"].paths["spacecraft"].q_IB
    assert q[0] @ q[-1] > 0.99


def test_the_support_of_a_placed_body_is_that_of_its_furthest_part() -> None:
    parts = (
        Part("a", Box([1.0, 1.0, 1.0]), Pose.identity(3)),
        Part("b", Box([0.5, 0.5, 0.5]), Pose(np.array([3.0, 0, 0]), np.eye(3))),
    )
    pose = Pose(np.array([0.0, 10.0, 0.0]), np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]))
    assert body_support(Body(parts), pose, np.array([0.0, 1.0, 0.0])) == pytest.approx(13.5)
    assert body_support(Body(parts), pose, np.array([0.0, -1.0, 0.0])) == pytest.approx(-9.0)
