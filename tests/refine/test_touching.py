"""Rows at touches: the instants are those of least clearance, the answer is that of rows at sites,
and what cannot be solved so is said to be."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.planner import FINE_SEGMENTS, plan_with_answer
from berthing.refine.refiner import BACKOFF_M, Refiner, Step, make_plan
from berthing.refine.touching import Touched, Touching, touch_sites
from berthing.result import Result
from berthing.scenario.clock import begun_at
from berthing.scenario.scenario import Scenario
from berthing.solve.ipopt import Answer
from berthing.trajectory import Plan
from berthing.transcription.extract import trajectories
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion
from berthing.verify.verification import verify
from support.documents import puck, scenario, structure

POST = structure("post", [3, 0.1], {"type": "sphere", "radius_m": 0.6})
GIVEN = scenario(puck(), structures=[POST])
REACH_M = 0.5 + 0.6 + 0.1 + BACKOFF_M


@pytest.fixture(scope="module")
def found() -> tuple[Result, Answer]:
    result, answer = plan_with_answer(GIVEN)
    assert answer is not None
    return result, answer


@pytest.fixture(scope="module")
def planned(found: tuple[Result, Answer]) -> tuple[Plan, Mesh, Motion]:
    result, answer = found
    assert result.plan is not None
    return result.plan, answer.problem.mesh, answer.outcome.motion


@pytest.fixture(scope="module")
def first(planned: tuple[Plan, Mesh, Motion]) -> Touched:
    plan, mesh, motion = planned
    sites = touch_sites(GIVEN, plan.phases[0], mesh)
    touched = Touching.build(GIVEN, GIVEN.phases[0], mesh, sites).first(GIVEN, motion)
    assert touched is not None
    return touched


def ranges(whole: Scenario, touched: Touched) -> list[np.ndarray]:
    """Distances of the centres at the touches that bind, and all along."""
    answer = touched.answer
    flown = trajectories(answer.problem, answer.outcome.motion).vehicles[0]
    post = whole.structures[0].motion.pose(np.zeros(1)).position[0]
    mesh, sites = answer.problem.mesh, answer.problem.separation.sites
    at = [flown.t1_s * mesh.fraction(q.segment, q.s) for q in sites]
    binding = np.array(at)[~touched.bearing.out]
    times = (binding, np.linspace(0.0, flown.t1_s, 2001))
    return [np.linalg.norm(flown.state(t)[:, :2] - post, axis=1) for t in times]


def test_touches_are_where_the_clearance_is_least(
    planned: tuple[Plan, Mesh, Motion], first: Touched
) -> None:
    at, everywhere = ranges(GIVEN, first)
    assert at == pytest.approx(REACH_M, abs=1e-8)
    assert len(at) >= 1
    assert np.min(everywhere) > REACH_M - 1e-8
    # No dearer than with rows at sites, which ask for a little more, and hardly cheaper.
    assert planned[0].cost * (1.0 - 2e-3) < first.outcome.cost <= planned[0].cost * (1.0 + 1e-6)


def test_again_with_a_moved_start(first: Touched) -> None:
    moved = begun_at(GIVEN, np.array([0.1, -0.2, 0.0, 0.001]), 0.0, {})
    again = first.touching.again(moved, first)
    assert again is not None
    assert again.outcome.iterations <= 6
    at, _ = ranges(moved, again)
    assert at == pytest.approx(REACH_M, abs=1e-8)
    answer = again.answer
    made = make_plan(moved, answer.problem, answer.outcome, "plane", 0)
    assert verify(moved, made).certified
    (site,) = answer.problem.separation.sites
    touch_s = 100.0 * answer.problem.mesh.fraction(site.segment, site.s)
    assert [own.time_s for own in made.separations] == pytest.approx([touch_s])


def test_an_instant_hops_to_the_next_segment(first: Touched) -> None:
    # The post stands half way, where two segments meet.
    segments = set()
    for x_m in (-0.1, 0.1):
        moved = begun_at(GIVEN, np.array([x_m, 0.0, 0.0, 0.0]), 0.0, {})
        again = first.touching.again(moved, first)
        assert again is not None
        (site,) = again.answer.problem.separation.sites
        assert abs(site.s) < 1.0
        at, everywhere = ranges(moved, again)
        assert at == pytest.approx(REACH_M, abs=1e-8)
        assert np.min(everywhere) > REACH_M - 1e-8
        segments.add(site.segment)
    assert len(segments) == 2


def test_plans_are_finished_at_their_touches(found: tuple[Result, Answer]) -> None:
    result, _ = found
    assert result.attempts[-1].guess.endswith("round 1, at touches")
    assert result.second_order is not None
    assert (result.second_order.negative, result.second_order.flat) == (0, 0)


def test_what_is_not_certified_goes_on_in_rounds(found: tuple[Result, Answer]) -> None:
    _, answer = found
    phase, mesh = GIVEN.phases[0], Mesh.uniform("lgr", FINE_SEGMENTS, 4)

    def through(scenario: Scenario, step: Step) -> Answer | None:
        """The way there would be without the post."""
        touched = Touching.build(scenario, phase, step.problem.mesh, []).first(
            scenario, step.outcome.motion
        )
        return None if touched is None else touched.answer

    refiner = Refiner(
        GIVEN, phase, mesh, "plane", 0, lambda *_: None, float("inf"), finish=through
    )
    refined = refiner.run("test", answer.problem, answer.outcome.motion)
    names = [attempt.guess for attempt in refined.attempts]
    assert names[:3] == [
        "test, round 1, roughly", "test, round 1, at touches", "test, round 1",
    ]  # fmt: skip
    assert refined.certified
    assert refined.finished is None


def test_far_from_an_answer_there_is_none(first: Touched) -> None:
    # Through the post: no normal, no rows that bind.
    mesh, motion = first.touching.problem.mesh, first.outcome.motion
    straight = np.zeros_like(motion.states["puck"])
    straight[0] = 6.0 * mesh.point_fractions()
    lost = Motion(motion.duration_s, {"puck": straight}, motion.controls)
    found = first.touching.first(GIVEN, lost)
    assert found is None or found.outcome.cost > 0.999 * first.outcome.cost
