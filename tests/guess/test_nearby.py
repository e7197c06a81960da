"""Rows for what is near: nothing is lost by leaving out the rest, for verdicts know every pair."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.guess.candidates import candidates
from berthing.guess.nearby import ROOM, near_pairs
from berthing.guess.path import motion_along
from berthing.planner import plan
from berthing.refine import first_answers
from berthing.refine.refiner import BACKOFF_M
from berthing.result import CERTIFIED
from berthing.scenario.scenario import Scenario
from berthing.transcription.mesh import Mesh
from support.documents import DURATION_S, puck, scenario, structure

BALL = {"type": "sphere", "radius_m": 0.6}
POST = structure("post", [3, 0.1], BALL)
FAR = [structure(f"far{i}", [5.0 * i, 40], BALL) for i in range(30)]
MESH = Mesh.uniform("lgr", 10, 4)


def near(given: Scenario, within_m: float) -> set[str]:
    (phase,) = given.phases
    pairs = given.pairs(phase)
    motions = [motion_along(g, phase, MESH, DURATION_S) for g in candidates(given, phase, 0)]
    return {pairs[i].owner_b.name for i in near_pairs(given, pairs, MESH, motions, within_m)}


def test_what_is_far_on_every_guess_is_left_out() -> None:
    crowd = scenario(puck(), structures=[*FAR[:15], POST, *FAR[15:]])
    # Random guesses may stray towards the first of them.
    assert near(crowd, 1.5) <= {"post", "far0", "far1"}
    assert "post" in near(crowd, 1.5)
    assert len(near(crowd, 300.0)) == 31


def test_a_structure_that_comes_by_later_is_near() -> None:
    motion = {"type": "constant-velocity", "velocity_m_s": [0.0, -0.8]}
    late = structure("late", [3, 41], BALL, motion=motion)
    assert near(scenario(puck(), structures=[late]), 1.5) == {"late"}


def test_walls_without_end_are_always_near() -> None:
    wall = {"name": "wall", "parts": [{"name": "core", "shape": {
        "type": "half-space", "normal": [0, 1], "offset_m": 50}}]}  # fmt: skip
    assert near(scenario(puck(), structures=[POST, wall]), 0.0) >= {"wall"}


@pytest.fixture(scope="module")
def alone() -> float:
    result = plan(scenario(puck(), structures=[POST]))
    assert result.outcome == CERTIFIED
    assert result.plan is not None
    return result.plan.cost


def test_the_plan_is_that_of_what_is_near(alone: float) -> None:
    result = plan(scenario(puck(), structures=[*FAR, POST]))
    assert result.outcome == CERTIFIED
    assert result.plan is not None
    assert result.verification is not None
    assert result.plan.cost == pytest.approx(alone, rel=1e-6)
    # The proof is of all pairs, those without rows included.
    assert len(result.verification.pairs) == 31


def test_what_an_answer_runs_into_gets_rows(alone: float, monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[float] = []

    def forgetful(*arguments, **named) -> set[int]:
        calls.append(arguments[-1])
        found = near_pairs(*arguments, **named)
        # The first time, as if no guess came near.
        return set() if len(calls) == 1 else found

    monkeypatch.setattr(first_answers, "near_pairs", forgetful)
    result = plan(scenario(puck(), structures=[POST]))
    assert len(calls) == 4
    assert calls[1] == 0.0 < calls[0]
    assert result.outcome == CERTIFIED
    assert result.plan is not None
    assert result.plan.cost == pytest.approx(alone, rel=1e-3)
    assert np.isclose(result.plan.backoff_m, BACKOFF_M)
    assert ROOM > 0.0
