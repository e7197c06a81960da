"""Planning again: from moved starts and structures, later, too late, and to no avail."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.refine.remaining import remaining, remaining_sites, shifted
from berthing.replanning import INSIDE_MARGIN, SITES, TOUCHES, Planner, Replanned
from berthing.result import CERTIFIED, TIME_LIMIT
from berthing.transcription.mesh import Mesh
from berthing.transcription.sites import Site, node_sites
from berthing.verify.verification import verify
from support.documents import DURATION_S, puck, scenario, structure

POST = structure("post", [3, 0.1], {"type": "sphere", "radius_m": 0.6})
GIVEN = scenario(puck(), structures=[POST])
REST = np.zeros(4)


def planned() -> Planner:
    planner = Planner(GIVEN)
    assert planner.plan().outcome == CERTIFIED
    return planner


@pytest.fixture(scope="module")
def first() -> Planner:
    """For tests that leave it as it is."""
    return planned()


def check(found: Replanned, start: Array) -> None:
    """A new plan that begins in ``start`` and is certified by a check made here."""
    assert found.fresh
    assert verify(found.scenario, found.plan).certified
    own = found.plan.phases[0].vehicle("puck")
    assert own.state(np.zeros(1))[0] == pytest.approx(start, abs=1e-7)
    assert own.state(np.array([own.t1_s]))[0] == pytest.approx([6, 0, 0, 0], abs=1e-7)


def test_a_moved_start_and_structure() -> None:
    planner, start = planned(), np.array([0.1, -0.2, 0.0, 0.001])
    pose = Pose(np.array([3.05, 0.02]), np.eye(2))
    found = planner.replan(start, 0.0, structures={"post": pose})
    check(found, start)
    assert found.rows == TOUCHES
    assert found.begins_s == 0.0
    (post,) = found.scenario.structures
    assert post.motion.pose(np.zeros(1)).position[0] == pytest.approx([3.05, 0.02])


def test_again_on_what_is_left() -> None:
    planner = planned()
    at_s = 20.0
    last = planner.replan(REST, 0.0)
    start = last.state("puck", at_s) + np.array([0.01, -0.005, 1e-4, 0.0])
    found = planner.replan({"puck": start}, at_s)
    check(found, start)
    assert found.rows == TOUCHES
    assert found.plan.phases[0].t1_s == pytest.approx(DURATION_S - at_s)
    assert found.state("puck", DURATION_S) == pytest.approx([6, 0, 0, 0], abs=1e-7)
    assert found.control("puck", at_s).shape == (2,)
    # The clock does not run backwards.
    with pytest.raises(InputError, match="time_s"):
        planner.replan(start, 0.0)


@pytest.mark.slow
def test_touches_that_were_not_there_take_rows_at_sites() -> None:
    # A second one comes from out of sight, 0.02 m too far into the way.
    far = structure("buoy", [4.6, -3.0], {"type": "sphere", "radius_m": 0.3})
    planner = Planner(scenario(puck(), structures=[POST, far]))
    assert planner.plan().outcome == CERTIFIED
    pose = Pose(np.array([4.6, -1.691]), np.eye(2))
    found = planner.replan(REST, 0.0, structures={"buoy": pose})
    check(found, REST)
    assert found.rows == SITES


def test_past_the_deadline_the_last_plan_goes_on(first: Planner) -> None:
    before = first.replan(REST, 0.0, deadline_s=1e-9)
    assert not before.fresh
    assert before.outcome == TIME_LIMIT
    assert before.begins_s == 0.0
    assert before.verification.certified
    start = np.array([0.1, 0.3, 0.0, 0.0])
    after = first.replan(start, 10.0, deadline_s=1e-9)
    assert after.plan is before.plan


def test_where_no_way_is_found_the_last_plan_goes_on() -> None:
    # Limits that cannot stop it any more: far too fast towards the post.
    limited = scenario(puck(limits={"max_force_n": 0.01}), structures=[POST])
    planner = Planner(limited)
    result = planner.plan()
    assert result.outcome == CERTIFIED
    found = planner.replan(np.array([1.0, 0.1, 0.5, 0.0]), 0.0)
    assert not found.fresh
    assert found.outcome not in (CERTIFIED, TIME_LIMIT)
    assert found.plan is result.plan


def test_a_start_in_collision_is_an_error(first: Planner) -> None:
    with pytest.raises(InputError, match="overlaps"):
        first.replan(np.array([2.5, 0.1, 0.0, 0.0]), 0.0)


def test_a_start_inside_the_margin_flies_on(first: Planner) -> None:
    # 0.05 m from the post, where 0.1 m is asked for: no plan begins there.
    found = first.replan(np.array([3.0 - 1.15, 0.1, 0.0, 0.0]), 5.0)
    assert found.outcome == INSIDE_MARGIN
    assert not found.fresh


@pytest.mark.parametrize(
    ("state", "time_s", "structures", "message"),
    [
        (np.zeros(3), 0.0, {}, "state"),
        ({"pack": REST}, 0.0, {}, "pack"),
        ({}, 0.0, {}, "missing"),
        (REST, DURATION_S, {}, "time_s"),
        (REST, -1.0, {}, "time_s"),
        (REST, 0.0, {"mast": Pose.identity(2)}, "mast"),
    ],
)
def test_bad_input(first: Planner, state, time_s, structures, message) -> None:
    with pytest.raises(InputError, match=message):
        first.replan(state, time_s, structures=structures)


def test_nothing_to_go_on_from() -> None:
    with pytest.raises(InputError, match="plan\\(\\) first"):
        Planner(GIVEN).replan(REST, 0.0)


def test_what_remains_of_a_mesh_is_where_it_was() -> None:
    mesh = Mesh.uniform("lgr", 8, 4)
    done = 0.3
    left = remaining(mesh, done)
    later = [b for b in mesh.breaks if b > done]
    assert [done + (1 - done) * b for b in left.breaks[1:]] == pytest.approx(later)
    sites = node_sites(mesh, 2)
    kept = remaining_sites(mesh, sites, left, done)
    at = sorted((s.pair, done + (1 - done) * left.fraction(s.segment, s.s)) for s in kept)
    expected = sorted((s.pair, mesh.fraction(s.segment, s.s)) for s in sites)
    expected = [place for place in expected if place[1] > done]
    assert np.allclose(at, expected, atol=1e-12)
    # A sliver of a segment is joined to the next.
    assert len(remaining(mesh, 0.249).breaks) == len(remaining(mesh, 0.25).breaks)
    # Nodes stay nodes: only those of the segment that was cut need variables of their own.
    nodes = [k for k in kept if np.min(np.abs(left.node_set(k.segment).points - k.s)) == 0.0]
    assert {k.segment for k in kept if k not in nodes} <= {0}
    assert Site(left.segments - 1, 1.0, 0) in kept


def test_the_motion_that_remains_is_the_plan(first: Planner) -> None:
    last = first.replan(REST, 0.0, deadline_s=1e-9)
    mesh = Mesh.uniform("lgr", 3, 4)
    motion = shifted(last.plan, mesh, 40.0, DURATION_S)
    assert motion.duration_s == 60.0
    at = 40.0 + 60.0 * mesh.point_fractions()
    assert pytest.approx(last.plan.phases[0].vehicle("puck").state(at)) == motion.states["puck"].T
