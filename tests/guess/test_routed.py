"""Guesses from routes: made where every simple one is blocked, and only there."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.guess import routed as routing
from berthing.guess.blocked import is_blocked, is_detour
from berthing.guess.candidates import candidates
from berthing.guess.continuation import Continuation
from berthing.guess.first_motions import first_motions
from berthing.guess.path import Guess, VehiclePath, motion_along
from berthing.guess.routed import routed
from berthing.scenario.files import load
from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Budget
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion
from support.documents import DURATION_S, box, puck, scenario, structure

MESH = Mesh.uniform("lgr", 10, 4)

# A room around the start with a slot in its far wall, low down.
ROOM = [
    structure("left", [-1.5, 0], box(0.2, 5)),
    structure("top", [0.5, 2.5], box(4.2, 0.2)),
    structure("bottom", [0.5, -2.5], box(4.2, 0.2)),
    structure("right", [2.5, 0.5], box(0.2, 4.0)),
]
GOAL = {"position_m": [6, 2]}


def room(radius_m: float) -> Scenario:
    """The slot is 1 m wide, for a puck of this radius and margins of 0.1 m."""
    craft = puck(parts=[{"name": "rim", "shape": {"type": "sphere", "radius_m": radius_m}}])
    return scenario({**craft, "goal": GOAL}, structures=ROOM)


@pytest.fixture(scope="module")
def closed() -> Scenario:
    """One scenario for all: routes are kept with it."""
    return room(0.3)


def names(given: Scenario) -> list[str]:
    whole = Continuation(given, given.phases[0], MESH, "plane", Budget(100), 1e-3, lambda *_: None)
    return [name for name, _ in first_motions("default", whole, 0)]


def along(given: Scenario, guess: Guess) -> Motion:
    return motion_along(guess, given.phases[0], MESH, DURATION_S)


def blocked(given: Scenario, guess: Guess) -> bool:
    return is_blocked(given.pairs(given.phases[0]), MESH, along(given, guess))


def test_out_of_a_room_a_route_comes_first(closed: Scenario) -> None:
    given = closed
    assert names(given)[:2] == ["route 1", "straight"]
    (phase,) = given.phases
    assert all(blocked(given, guess) for guess in candidates(given, phase, 0))
    for guess in routed(given, phase, 0, 1, np.inf):
        assert not blocked(given, guess)
        path = guess.paths["puck"]
        np.testing.assert_allclose(path.positions_m[[0, -1]], [[0, 0], [6, 2]], atol=1e-9)
        assert np.min(path.positions_m[:, 1]) < -1.0


def test_where_a_simple_guess_is_clear_none_is_looked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(routing, "Seeker", None)
    post = structure("post", [3, 0.1], {"type": "sphere", "radius_m": 0.6})
    assert not any(name.startswith("route") for name in names(scenario(puck(), structures=[post])))
    assert not any(name.startswith("route") for name in names(load("scenario-a")))


def test_where_there_is_no_way_simple_guesses_are_left(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(routing, "LONGEST_S", 0.2)
    assert names(room(0.6))[0] == "straight"


def test_nothing_is_searched_where_structures_move_or_a_car_drives(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(routing, "Seeker", None)
    for name in ("spinning-structure", "parking-backwards"):
        given = load(name)
        assert routed(given, given.phases[0], 0, 1, np.inf) == []


def test_a_seed_draws_other_routes_and_the_same_seed_none_again(
    closed: Scenario, monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    given = closed
    (phase,) = given.phases
    first, other = (routed(given, phase, seed, 1, np.inf)[0].paths["puck"] for seed in (0, 1))
    assert first.positions_m.shape != other.positions_m.shape or not np.allclose(
        first.positions_m, other.positions_m
    )
    monkeypatch.setattr(routing, "Seeker", None)
    assert routed(given, phase, 0, 1, np.inf)[0].paths["puck"] is first


def test_of_two_slots_the_cheap_one_is_taken() -> None:
    right = [
        structure(name, [2.5, y], box(0.2, 1.0))
        for name, y in (("middle", 0.0), ("upper", 2.0), ("lower", -2.0))
    ]
    rim = {"name": "rim", "shape": {"type": "sphere", "radius_m": 0.3}}
    craft = {**puck(parts=[rim]), "goal": {"position_m": [6, 2]}}
    given = scenario(craft, structures=[*ROOM[:3], *right])
    (phase,) = given.phases
    for seed in range(3):
        (best,) = routed(given, phase, seed, 1, np.inf)
        path = best.paths["puck"]
        np.testing.assert_array_equal(path.fractions, np.linspace(0, 1, len(path.positions_m)))
        crossing = path.positions_m[np.argmin(np.abs(path.positions_m[:, 0] - 2.5)), 1]
        assert 0.8 < crossing < 1.2
    several = routed(given, phase, 0, 2, np.inf)
    assert [guess.name for guess in several] == ["route 1", "route 2"][: len(several)]


def test_a_way_far_around_is_a_detour() -> None:
    def path(*y: float) -> Guess:
        r = np.stack([np.linspace(0.0, 6.0, len(y)), y], axis=1)
        return Guess("", {"puck": VehiclePath(r, np.tile([1.0, 0.0, 0.0, 0.0], (len(y), 1)))})

    assert not is_detour(path(0.0, 5.0, 0.0))
    assert is_detour(path(0.0, 5.5, 0.0))


def test_a_shallow_overlap_is_not_blocked() -> None:
    post = structure("post", [3, 0], {"type": "sphere", "radius_m": 0.6})
    given = scenario(puck(), structures=[post])

    def past(y: float) -> Guess:
        r = np.array([[0.0, y], [3.0, y], [6.0, y]])
        return Guess("", {"puck": VehiclePath(r, np.tile([1.0, 0.0, 0.0, 0.0], (3, 1)))})

    assert not blocked(given, past(1.2))
    assert not blocked(given, past(1.06))
    assert blocked(given, past(1.04))
