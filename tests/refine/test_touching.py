"""Rows at touches: the instants are those of least clearance, the answer is that of rows at sites,
and what cannot be solved so is said to be."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.planner import plan_with_answer
from berthing.refine.refiner import BACKOFF_M, make_plan
from berthing.refine.touching import Touched, Touching, touch_sites
from berthing.scenario.clock import begun_at
from berthing.scenario.scenario import Scenario
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
def planned() -> tuple[Plan, Mesh, Motion]:
    result, answer = plan_with_answer(GIVEN)
    assert result.plan is not None
    assert answer is not None
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


def test_far_from_an_answer_there_is_none(first: Touched) -> None:
    # Through the post: no normal, no rows that bind.
    mesh, motion = first.touching.problem.mesh, first.outcome.motion
    straight = np.zeros_like(motion.states["puck"])
    straight[0] = 6.0 * mesh.point_fractions()
    lost = Motion(motion.duration_s, {"puck": straight}, motion.controls)
    found = first.touching.first(GIVEN, lost)
    assert found is None or found.outcome.cost > 0.999 * first.outcome.cost
