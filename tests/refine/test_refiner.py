"""Rounds of the refinement."""

from __future__ import annotations

import pytest

from berthing import planner
from berthing.planner import plan
from berthing.result import CERTIFIED
from berthing.solve import ipopt, quick
from support.documents import box, puck, scenario, structure


@pytest.mark.slow
def test_a_round_that_fails_is_tried_again_with_a_high_barrier(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    # Convex steps, which take over where that solver finds nothing, have no rounds of this kind.
    exact = [wave for wave in planner.WAVES if not wave.steps]
    monkeypatch.setattr(planner, "WAVES", exact)
    monkeypatch.setattr(quick, "ITERATIONS", 1)
    monkeypatch.setitem(ipopt.PRESETS, "near", {"max_iter": 1})
    result = plan(scenario(puck(), structures=[structure("low", [3, -1.0], box(0.5, 2.5))]))
    assert result.outcome == CERTIFIED
    (rough,) = [a for a in result.attempts if a.guess.endswith("round 1, roughly")]
    assert rough.outcome != "solved"
    (first, *_) = [a for a in result.attempts if a.guess.endswith("round 1")]
    assert first.outcome == "solved"
    # Those of both solves are counted.
    assert first.iterations > 5
