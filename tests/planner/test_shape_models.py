"""What stands for shapes while a motion is planned, and shapes that nothing else plans with."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import berthing as bt
from berthing.refine.begin_with import beginning
from berthing.scenario.options import SolverOptions
from berthing.scenario.scenario import Scenario
from berthing.transcription.problem import planned_shapes, true_shapes
from support.documents import Document, box, puck, scenario, structure

EXPONENT = 8.0
INNER, OUTER = {"side": "inner", "exponent": EXPONENT}, {"side": "outer", "exponent": 40.0}


def square(**changes: Any) -> Document:
    """A square that has to pass another, corner by corner."""
    start, goal = {"position_m": [0, 0.2]}, {"position_m": [6, 0]}
    parts = [{"name": "rim", "shape": box(1, 1)}]
    return puck(parts=parts, start=start, goal=goal, **changes)


def passing(model: Document | None, formulation: str = "kkt") -> Scenario:
    solver: Document = {"formulation": formulation}
    if model is not None:
        solver["shape_model"] = model
    return scenario(square(), structures=[structure("block", [3, 0], box(1, 1))], solver=solver)


def test_an_inner_model_is_planned_and_rejected_with_the_parts_that_overlap() -> None:
    options = SolverOptions("kkt", "lgl-global", nodes=12)
    result = bt.plan(passing(INNER), options=options)
    assert result.outcome == "not_certified"
    assert result.plan is not None
    assert result.verification is not None
    # The model keeps its margin at the nodes; the squares do not.
    assert result.verification.closest_pair == "puck.rim|block.core"
    assert result.verification.closest_distance_m < 0.05
    assert "puck.rim, block.core" in result.verification.reasons[0]
    assert "models inside the shapes of puck.rim, block.core" in result.advice
    assert sum("as it is" in attempt.guess for attempt in result.attempts) == 1


@pytest.mark.slow
def test_an_outer_model_keeps_the_squares_apart() -> None:
    result = bt.plan(passing(OUTER))
    assert result.outcome == "certified"
    exact = bt.plan(passing(None))
    assert result.plan is not None
    assert exact.plan is not None
    # A wider berth costs more.
    assert exact.plan.cost < result.plan.cost < 1.1 * exact.plan.cost


def test_what_a_form_begins_with_follows_from_the_shapes() -> None:
    smoothed, plain = passing(INNER), passing(None)
    for made, shapes_of in ((smoothed, true_shapes), (plain, planned_shapes)):
        pairs = made.pairs(made.phases[0])
        begun = beginning("kkt", pairs)
        assert (begun.formulation, begun.shapes_of) == ("plane", shapes_of)
        again = beginning("kkt-complementarity", pairs)
        assert (again.formulation, again.shapes_of) == ("kkt-complementarity", planned_shapes)
    pair = smoothed.pairs(smoothed.phases[0])[0]
    assert beginning("plane", [pair]).shapes_of is planned_shapes


def test_a_ground_without_end_is_kept_clear_of() -> None:
    """A straight line would pass through the ground: the goal lies behind a bump in it."""
    ground = structure("ground", [0, -1], {"type": "half-space", "normal": [0, 1]})
    bump = structure("bump", [3, -1], {"type": "sphere", "radius_m": 1.2})
    made = scenario(puck(), structures=[ground, bump], solver={"formulation": "kkt"})
    result = bt.plan(made)
    assert result.outcome == "certified", result.advice
    assert result.verification is not None
    bounds = {pair.pair: pair.lower_bound_m for pair in result.verification.pairs}
    assert bounds["puck.rim|ground.core"] >= 0.1
    assert np.isfinite(bounds["puck.rim|ground.core"])
