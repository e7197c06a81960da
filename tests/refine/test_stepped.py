"""Crowded scenes, planned by convex steps alone."""

from __future__ import annotations

from contextlib import closing
from math import inf

import numpy as np
import pytest

from berthing.guess.search import EFFORTS
from berthing.planner import plan
from berthing.refine import first_answers
from berthing.refine.first_answers import Coarse, Wave
from berthing.result import CERTIFIED
from berthing.transcription.mesh import Mesh
from support.documents import puck, scenario, structure

FIELD = [
    structure(f"post-{i}", [1.5 + 0.5 * i, (-1) ** i * 0.75], {"type": "sphere", "radius_m": 0.3})
    for i in range(EFFORTS["normal"].exact + 1)
]


@pytest.mark.slow
def test_a_crowd_is_passed_and_certified_without_planes_as_variables() -> None:
    result = plan(scenario(puck(), structures=FIELD))
    assert result.outcome == CERTIFIED
    assert result.verification is not None
    assert result.verification.clearance_lower_bound_m >= result.verification.required_clearance_m
    # Multipliers at hand are those of a problem without things in the way.
    assert result.plan is not None
    assert np.all(np.isnan(result.plan.nodes[0].costates))
    assert result.plan.cost_per_margin is None
    assert result.second_order is None
    assert result.extremality is None


def test_a_few_things_are_left_to_the_exact_form(monkeypatch) -> None:
    def refused(*_: object) -> None:
        raise AssertionError("convex steps were asked for")

    monkeypatch.setattr(first_answers, "ConvexSteps", refused)
    given = scenario(puck(), structures=FIELD[:1])
    (phase,) = given.phases
    notes: list[str] = []
    mesh = Mesh.uniform("lgr", 3, 3)
    coarse = Coarse(
        given, phase, mesh, given.solver, lambda name, *_: notes.append(name), inf
    )
    assert coarse.first(Wave(patient=False, steps="crowded")) is None
    assert notes == []


def test_where_the_exact_form_finds_nothing_steps_are_taken_for_a_few_things_too() -> None:
    given = scenario(puck(), structures=FIELD[:1])
    coarse = Coarse(
        given, given.phases[0], Mesh.uniform("lgr", 3, 3), given.solver, lambda *_: None, inf
    )
    found = coarse.first(Wave(", in steps", patient=False, steps="other"))
    assert found is not None
    with closing(found.search.pool):
        assert not found.problem.separation.sites
        candidate = found.search.next_candidate(None, more=True)
    assert candidate is not None
    assert candidate[0].endswith(", in steps")
