"""The paper's continuation: sub-problems, their sum, and the plan that begins there."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.guess.continuation import AGAIN, Continuation, bowed, superposed
from berthing.guess.first_motions import GUESSES, first_motions
from berthing.planner import plan
from berthing.result import CERTIFIED, ITERATION_LIMIT, LOCALLY_INFEASIBLE, Result
from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Budget
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion
from support.documents import DURATION_S, box, puck, scenario, spacecraft, structure

MESH = Mesh.uniform("lgr", 5, 3)
WALLS = [structure("low", [3, -1.0], box(0.5, 2.5)), structure("high", [3, 4.0], box(0.5, 2.0))]


def among(given: Scenario) -> tuple[Continuation, list[str]]:
    told: list[str] = []

    def report(name, problem, outcome):
        told.append(f"{name}: {outcome.status}")

    whole = Continuation(given, given.phases[0], MESH, "plane", Budget(100), 1e-3, report)
    return whole, told


def test_each_part_is_alone_once() -> None:
    whole, told = among(scenario(puck(), structures=WALLS))
    (motion,) = (m for _, m in first_motions("paper-continuation", whole, 0))
    assert told == ["nothing in the way: solved", "only low.core: solved", "only high.core: solved"]
    # Only the lower wall stands in the way: its detour is the whole sum.
    middle = motion.states["puck"][:2, np.argmin(np.abs(motion.states["puck"][0] - 3.0))]
    assert middle[1] >= 0.25 + 0.5 + 0.05
    np.testing.assert_allclose(motion.states["puck"][:2, [0, -1]].T, [[0, 0], [6, 0]], atol=1e-7)


def test_other_vehicles_are_in_the_way_too() -> None:
    other = puck("other", start={"position_m": [6, 0]}, goal={"position_m": [0, 0]})
    whole, told = among(scenario(puck(), other))
    whole.motion(0)
    names = [name.split(":")[0] for name in told]
    assert names[:2] == ["nothing in the way", "only other.rim"]
    # Head on it may take a bow to decide on a side.
    assert set(names[2:]) <= {"only other.rim, bowed"}


def motion_of(given: Scenario, value: float, duration_s: float = DURATION_S) -> Motion:
    states, controls = {}, {}
    for v in given.phases[0].vehicles:
        states[v.name] = np.full((len(v.model.state_names), MESH.point_count), value)
        controls[v.name] = np.full((len(v.model.control_names), MESH.control_count), value)
    return Motion(duration_s, states, controls)


def test_deviations_add_up() -> None:
    given = scenario(puck())
    free, one, two = (motion_of(given, v) for v in (1.0, 1.5, 3.0))
    found = superposed(free, [one, two], given.phases[0])
    np.testing.assert_allclose(found.states["puck"], 3.5)
    np.testing.assert_allclose(found.controls["puck"], 3.5)
    np.testing.assert_allclose(superposed(free, [], given.phases[0]).states["puck"], 1.0)


def test_quaternions_stay_unit_and_durations_within_the_horizon() -> None:
    given = scenario(spacecraft(), horizon={"min_s": 50, "max_s": 120})
    free, slow = motion_of(given, 1.0), motion_of(given, 2.0, DURATION_S + 90)
    found = superposed(free, [slow], given.phases[0])
    np.testing.assert_allclose(np.linalg.norm(found.states["spacecraft"][6:10], axis=0), 1.0)
    assert found.duration_s == 120.0


def test_a_seed_bows_the_way_and_keeps_its_ends() -> None:
    given = scenario(puck())
    x = np.zeros((4, MESH.point_count))
    x[0] = 6 * MESH.point_fractions()
    straight = Motion(DURATION_S, {"puck": x}, {"puck": np.zeros((2, MESH.control_count))})
    ways = [
        bowed(straight, given.phases[0], MESH, np.random.default_rng(seed)).states["puck"]
        for seed in (1, 1, 2)
    ]
    np.testing.assert_array_equal(ways[0], ways[1])
    assert np.max(np.abs(ways[0] - ways[2])) > 1e-3
    np.testing.assert_allclose(ways[0][:, [0, -1]], x[:, [0, -1]], atol=1e-12)
    assert 1e-3 < np.max(np.abs(ways[0][1])) < 3.0


def test_an_unknown_guess_is_refused() -> None:
    whole, _ = among(scenario(puck()))
    with pytest.raises(InputError, match="one of default, paper-continuation"):
        first_motions("oracle", whole, 0)
    assert set(GUESSES) == {"default", "routes", "paper-continuation"}


def attempts_of(given: Scenario, seed: int) -> tuple[Result, list[str]]:
    result = plan(given, options=replace(given.solver, guess="paper-continuation", seed=seed))
    return result, [attempt.guess for attempt in result.attempts]


def test_a_plan_begins_there() -> None:
    result, names = attempts_of(scenario(puck(), structures=WALLS), 1)
    assert result.outcome == CERTIFIED
    assert names[:4] == ["nothing in the way", "only low.core", "only high.core",
                         "paper continuation"]  # fmt: skip


@pytest.mark.slow
def test_a_part_that_leaves_the_solver_undecided_is_tried_from_its_sides() -> None:
    """The straight line of seed 0 passes through the lower wall."""
    result, names = attempts_of(scenario(puck(), structures=WALLS), 0)
    assert result.outcome == CERTIFIED, (result.advice, result.attempts)
    assert names.index("only low.core, bowed") == names.index("only low.core") + 1
    first = {attempt.guess: attempt.outcome for attempt in result.attempts}
    assert first["only low.core"] != "solved"
    assert names.count("only high.core") == 1


@pytest.mark.slow
def test_where_no_sub_problem_has_an_answer_the_failure_says_so() -> None:
    """The way is held within 0.1 m of a line that a wall closes."""
    held = {"position_m": {"lower": [-1, -0.1], "upper": [7, 0.1]}}
    given = scenario(puck(limits=held), structures=[structure("low", [3, 0], box(0.5, 2.5))])
    result, names = attempts_of(given, 0)
    assert result.plan is None
    assert result.outcome in (ITERATION_LIMIT, LOCALLY_INFEASIBLE)
    assert result.advice
    assert names[-1].startswith("paper continuation")
    # A second, more patient round of all of it follows the first.
    first = result.attempts[: names.index("paper continuation") + 1]
    assert [attempt.guess for attempt in first].count("only low.core, bowed") == AGAIN
    failed = [attempt for attempt in first if attempt.outcome != "solved"]
    assert len(failed) == len(first) - 1
    assert all("low.core" in attempt.note for attempt in failed)
