"""Convex steps with planes held: their rows are true, and what they end at keeps the margins."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.guess.normals import exact_normals
from berthing.scenario.files import load
from berthing.solve.convex_steps import MET_M, ConvexSteps
from berthing.solve.held_planes import HeldPlanes
from berthing.solve.held_rows import held_rows
from berthing.solve.ipopt import Budget, Start
from berthing.solve.outcome import LOCALLY_INFEASIBLE, SOLVED
from berthing.solve.samples import Samples, spread_evenly
from berthing.transcription.problem import Problem
from support.documents import box, puck, scenario, spacecraft, structure
from support.solving import BACKOFF_M, guessed, posed

POST = structure("post", [3, 0.1], {"type": "sphere", "radius_m": 0.6})


def planes_of(problem: Problem) -> HeldPlanes:
    samples = Samples(problem, spread_evenly(problem.mesh, 1))
    return HeldPlanes(samples, problem.scenario, BACKOFF_M)


@pytest.fixture(scope="module")
def turning() -> Problem:
    """Two bodies in space that turn, past each other and a block."""
    return posed(load("two-vehicles-swap"), 3, 3, sites=[])


def test_rows_foretell_distances(turning) -> None:
    planes, rng = planes_of(turning), np.random.default_rng(0)
    straight = guessed(turning)
    x = turning.start_vector(turning.scenario, straight, exact_normals(turning.pairs))
    # Where faces lie along each other the distance has a kink.
    x, duration_s = x + 0.05 * rng.normal(size=len(x)), straight.duration_s
    around = planes.around(turning.motion(x, duration_s), 100.0)
    rows = held_rows(planes.samples, around, 0.0, -100.0)
    count = len(turning.pairs) * len(planes.samples.fractions)
    assert rows.groups == len(rows.gap) == count
    change = 1e-6 * rng.normal(size=len(x))
    moved = planes.around(turning.motion(x + change, duration_s), 100.0)
    shorter = np.concatenate([b.short_m - a.short_m
                              for a, b in zip(around.near, moved.near, strict=True)])  # fmt: skip
    foretold = rows.slope @ (rows.places @ change) * turning.layout.scale.length_m
    # Depths are known to less than distances are.
    apart = np.concatenate([one.required_m - one.short_m for one in around.near]) > 0.0
    np.testing.assert_allclose(-shorter[apart], foretold[apart], atol=1e-9)
    np.testing.assert_allclose(-shorter, foretold, atol=1e-5)
    assert np.sum(apart) > 30
    assert np.max(np.abs(foretold[apart])) > 1e-6


def test_a_face_along_its_plane_has_rows_for_all_its_corners() -> None:
    floor = structure("floor", [5, 0, -2.5], box(40.0, 40.0, 1.0))
    problem = posed(scenario(spacecraft(), structures=[floor]), 2, 2, sites=[])
    planes = planes_of(problem)
    around = planes.around(guessed(problem), 10.0)
    plain = held_rows(planes.samples, around, 0.0, -10.0)
    tilted = held_rows(planes.samples, around, 0.2, 10.0)
    assert len(plain.gap) == plain.groups == tilted.groups
    assert plain.plane.shape[1] == 0
    # The body's four corners below a plane, the floor's four above, or the other way about: it
    # tilts about two axes, and shifts.
    assert len(tilted.gap) == 8 * tilted.groups
    assert tilted.plane.shape[1] == 3 * tilted.groups
    below = tilted.group < 0
    assert np.sum(below) == 4 * tilted.groups
    np.testing.assert_allclose(tilted.gap[below], 0.0, atol=1e-9)
    np.testing.assert_allclose(tilted.gap[~below], plain.gap[0], atol=1e-9)
    # What it shifts by, those on the one side gain and those on the other lose.
    shift = tilted.plane[:, 2 * tilted.groups :]
    np.testing.assert_allclose(shift @ np.ones(tilted.groups), np.where(below, 1.0, -1.0))
    # A plane that leans by 0.01 is that much further from a corner 20 m away, to either side.
    leaning = 0.01 * tilted.plane[:, 0].toarray().ravel() * problem.layout.scale.length_m
    assert np.max(leaning) > 0.15
    assert np.min(leaning) < -0.15
    # Far from the plane they are not asked for.
    assert len(held_rows(planes.samples, around, 0.2, 0.5).gap) == plain.groups


@pytest.mark.parametrize("half_width", [0.0, 60.0])
def test_steps_end_clear_of_things_or_say_that_they_are_not(half_width) -> None:
    things = [POST]
    if half_width:
        # Thicker than any step from one sample to the next.
        things = [structure("wall", [3, 0.1], box(3.0, 2.0 * half_width))]
    problem = posed(scenario(puck(limits={"max_force_n": 0.01}), structures=things), 4, 3, sites=[])
    start = Start(guessed(problem, 0), exact_normals(problem.pairs))
    outcome = ConvexSteps(problem, Budget(30, 30.0)).solve(
        problem.scenario, start, backoff_m=BACKOFF_M
    )
    left = planes_of(problem).around(outcome.motion, 1.0)
    if half_width:
        assert outcome.status == LOCALLY_INFEASIBLE
        assert left.worst_m > MET_M
        return
    assert outcome.status == SOLVED
    assert left.worst_m <= MET_M
    rows = problem.nlp["g"]
    assert rows.numel() == len(outcome.multipliers)
    values = np.asarray(problem.nlp["jac_g"](outcome.x, outcome.parameters)[0]).ravel()
    lower, upper = problem.layout.rows.bounds()
    np.testing.assert_allclose(values, np.clip(values, lower, upper), atol=1e-8)


def test_a_round_body_touches_a_plane_in_one_point() -> None:
    ball = {"name": "hull", "shape": {"type": "sphere", "radius_m": 1.0}}
    post = structure("post", [5, 0, -3.0], {"type": "sphere", "radius_m": 1.5})
    problem = posed(scenario(spacecraft(parts=[ball]), structures=[post]), 2, 2, sites=[])
    planes = planes_of(problem)
    rows = held_rows(planes.samples, planes.around(guessed(problem), 10.0), 0.2, 10.0)
    assert len(rows.gap) == rows.groups
    assert rows.plane.shape[1] == 0


def test_the_line_on_which_a_cylinder_lies_is_among_its_points() -> None:
    shape = {"type": "cylinder", "radius_m": 1.0, "length_m": 3.0, "axis": "x"}
    floor = structure("floor", [5, 0, -2.5], box(40.0, 40.0, 1.0))
    lying = spacecraft(parts=[{"name": "hull", "shape": shape}])
    problem = posed(scenario(lying, structures=[floor]), 2, 2, sites=[])
    planes = planes_of(problem)
    around = planes.around(guessed(problem), 10.0)
    plain, tilted = (held_rows(planes.samples, around, tilt, 10.0) for tilt in (0.0, 0.2))
    # Those that tilted normals find lie higher up its side, by 2 cm.
    below = tilted.group < 0
    room = np.min(tilted.gap[below]) + np.min(tilted.gap[~below])
    assert room == pytest.approx(plain.gap[0], abs=1e-9)
