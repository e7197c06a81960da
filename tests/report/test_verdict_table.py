"""The table says what flies, how wide its tube is, and what keeping away costs."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from berthing.report.margin_loss import cost_lost
from berthing.report.verdict_table import (
    CONDITIONS,
    extremality_rows,
    optimality_rows,
    plan_rows,
    verification_rows,
)
from berthing.result import Result
from berthing.trajectory import PhaseTrajectory
from berthing.verify.extremal import Extremality
from berthing.verify.observed_order import OrderCheck, Study
from berthing.verify.second_order import SecondOrder
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


FINE = Study(4, 7, (21, 42, 84), (1.0 + 7e-11, 1.0 + 5e-13, 1.0))
COARSE = Study(3, 5, (21, 42, 84), (1.0 + 33e-9, 1.0 + 1e-9, 1.0))


@pytest.mark.parametrize(
    ("shown", "words"),
    [
        (COARSE, "5.00 with degree 3, 21 to 84 segments (5 expected of smooth motion)"),
        (None, "none to be seen: every mesh gives the same cost"),
    ],
)
def test_the_order_of_the_cost_is_printed_with_where_it_was_seen(shown, words: str) -> None:
    known = Extremality(1e-9, 1e-4, 0.0, 0.0, 0.0, 0.0, None)
    result = Result("certified", None, None, extremality=known, order=OrderCheck(FINE, shown))
    rows = optimality_rows(result)
    assert row(rows, "cost, mesh halved twice") == "moves by 7e-11, then 5e-13"
    assert row(rows, "observed order of the cost") == words
    unasked = optimality_rows(replace(result, order=None))
    assert not [r for r in unasked if r.label.startswith(("cost", "observed"))]


@pytest.mark.parametrize(
    ("found", "words", "good"),
    [
        (SecondOrder(9, 5, 0, 0, 1e-7, 1e-3),
         "a minimum: inertia (9, 5, 0), least curvature above 1e-03", True),
        (SecondOrder(9, 5, 2, 1, 1e-7, None),
         "NOT shown to be a minimum: inertia (6, 7, 1) in place of (9, 5, 0)", False),
    ],
)  # fmt: skip
def test_the_inertia_is_printed_with_what_it_means(found, words: str, good: bool) -> None:
    (only,) = [
        r for r in optimality_rows(Result("certified", None, None, second_order=found))
        if r.label == "second order"
    ]  # fmt: skip
    assert (only.value, only.good) == (words, good)
    assert found.to_json()["minimum"] is good


def test_every_condition_has_its_row() -> None:
    known = Extremality(1e-3, 2e-4, 3e-5, 4e-6, 5e-7, 6e-8, 0.1)
    rows = extremality_rows(known)
    assert row(rows, "Pontryagin extremal") == "to 1e-3.0: worst is stationarity, 0.001 of the cost"
    said = [row(rows, label) for label in CONDITIONS.values()]
    assert said == [f"off by {v} of the cost" for v in
                    ("0.001", "0.0002", "3e-05", "4e-06", "5e-07", "6e-08")]  # fmt: skip
    bad = extremality_rows(replace(known, adjoint=8.0))
    assert row(bad, "Pontryagin extremal") == "not: worst is adjoint, 8 of the cost"
    assert extremality_rows(None) == []
