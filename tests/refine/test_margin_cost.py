"""The slope of the cost in the margins is that of two answers with margins a little apart."""

from __future__ import annotations

import pytest

from berthing.refine.margin_cost import cost_per_margin
from support import documents
from support.solving import BACKOFF_M, solved

WIDER_M = 2e-3


def around(margin_m: float, offset_m: float = 0.3):
    """A body whose straight way is blocked."""
    block = documents.structure("block", [5, offset_m, 0], documents.box(1, 2, 6))
    return documents.scenario(structures=[block], margin_m=margin_m)


def test_it_is_the_difference_of_two_costs() -> None:
    narrow, wide = solved(around(0.1)), solved(around(0.1 + WIDER_M))
    assert narrow.outcome.solved
    assert wide.outcome.solved
    slope = cost_per_margin(around(0.1), narrow.problem, narrow.outcome, BACKOFF_M)
    assert slope > 0.0
    measured = (wide.outcome.cost - narrow.outcome.cost) / WIDER_M
    assert slope == pytest.approx(measured, rel=0.05)


def test_margins_that_do_not_act_cost_nothing() -> None:
    free = solved(around(0.1, offset_m=9.0))
    assert free.outcome.solved
    slope = cost_per_margin(around(0.1, offset_m=9.0), free.problem, free.outcome, BACKOFF_M)
    assert abs(slope) < 1e-4 * free.outcome.cost
