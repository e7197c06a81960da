"""The table says what flies, how wide its tube is, and what keeping away costs."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from berthing.report.margin_loss import cost_lost
from berthing.report.verdict_table import plan_rows, verification_rows
from berthing.trajectory import PhaseTrajectory
from berthing.verify.verification import verify
from support import hand_made


@pytest.fixture(scope="module")
def sound():
    whole, made = hand_made.document_plan()
    return replace(made, cost=0.5, cost_per_margin=2.0), verify(whole, made)


def row(rows, label: str) -> str:
    (found,) = [r.value for r in rows if r.label == label]
    return found


def test_back_off_and_tube_both_cost(sound) -> None:
    made, found = sound
    wide = replace(found, tube_m=1e-3)
    assert made.backoff_m == 1e-3
    assert cost_lost(made, wide) == pytest.approx(2.0 * 2e-3)
    assert row(plan_rows(made, wide), "cost of back-off and tube") == "about 0.004, 0.8 %"
    assert row(verification_rows(wide), "pose tube") == "0.0010 m off every bound"


@pytest.mark.parametrize("change", [{"cost_per_margin": None}, {"cost": 0.0}])
def test_what_is_not_known_is_not_said(sound, change) -> None:
    made, found = sound
    assert row(plan_rows(replace(made, **change), found), "cost of back-off and tube") == "unknown"
    assert cost_lost(made, replace(found, tube_m=math.inf)) is None


@pytest.mark.parametrize(
    ("interpolation", "words"),
    [
        ("polynomial", "polynomials, as optimised"),
        ("linear", "linear over 5 s at a time"),
        ("constant", "held for 5 s at a time"),
    ],
)
def test_what_flies_is_named(sound, interpolation: str, words: str) -> None:
    made, found = sound
    own = replace(made.phases[0].vehicles[0], control_interpolation=interpolation)
    flown = replace(made, phases=(PhaseTrajectory("main", (own,)),))
    assert row(plan_rows(flown, found), "controls") == words
