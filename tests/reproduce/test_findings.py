"""Claims that need no plan: each verdict follows from numbers that the test knows otherwise."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.geometry.box import Box
from berthing.geometry.shape_model import ShapeModel
from berthing.reproduce import closest, motion, sets
from berthing.reproduce.finding import FAILS, HOLDS, PARTLY, Finding
from berthing.reproduce.smoothing import corner_error, recession


def verdicts(findings: list[Finding]) -> list[str]:
    return [finding.verdict for finding in findings]


def test_what_is_claimed_of_smoothed_sets() -> None:
    found = sets.findings()
    assert verdicts(found) == [HOLDS, FAILS, HOLDS, HOLDS, PARTLY, HOLDS]
    corner = found[1].values
    # Three faces meet at a corner, the others are far: ln 3/8 along each normal.
    assert corner["corner_m"] == pytest.approx(np.sqrt(3) * np.log(3) / 8, abs=1e-6)
    assert corner["edge_m"] == pytest.approx(np.sqrt(2) * np.log(2) / 8, abs=1e-6)
    assert found[2].values == {"smoothed": 8, "exact": 18}
    assert found[4].values["empty_below_m"] == pytest.approx(np.log(4) / 8)


def test_what_is_claimed_of_closest_points() -> None:
    found = closest.findings()
    assert verdicts(found) == [HOLDS, FAILS, HOLDS]
    assert found[1].values["points_m"] == pytest.approx(np.sqrt(18))
    assert found[1].values["distance_m"] == pytest.approx(2.0, abs=1e-6)


def test_what_is_claimed_of_the_equations_of_motion() -> None:
    found = motion.findings()
    assert verdicts(found) == [FAILS, FAILS]
    assert found[0].values["plus"] < 1e-7
    assert found[1].values["printed"] > 1.0
    assert found[1].values["corrected"] < 1e-8


def test_without_the_faults_the_verdicts_would_be_others(monkeypatch: pytest.MonkeyPatch) -> None:
    """Sharper corners hold, and a body whose centre is its reference point loses nothing."""
    monkeypatch.setattr(sets, "EXPONENT", 40.0)
    monkeypatch.setattr(sets, "INNER", ShapeModel("inner", exponent=40.0))
    assert sets._sharp_enough().verdict == HOLDS
    plain = motion.RigidBody(3.0, np.diag([5.0, 6.0, 7.0]))
    monkeypatch.setattr(motion, "BODY", plain)
    assert motion._loads().verdict == HOLDS


def test_a_corner_recedes_as_far_as_the_smooth_function_says() -> None:
    for exponent, half, dim in ((8.0, 1.0, 3), (4.0, 0.7, 2), (30.0, 0.2, 2)):
        gone = recession(exponent, half, dim)
        model = ShapeModel("inner", exponent=exponent).of(Box(np.full(dim, half)))
        reach, _ = model.support(np.ones(dim) / np.sqrt(dim))
        assert reach == pytest.approx(np.sqrt(dim) * (half - gone), abs=1e-8)


def test_small_squares_are_empty_and_errors_fall() -> None:
    found = corner_error(np.array([4.0, 8.0, 16.0]), np.array([0.15, 0.5, 3.0]))
    assert np.isnan(found.recession_m[:, 0]).tolist() == [True, True, False]
    assert np.all(np.diff(found.recession_m[:, 1:], axis=0) < 0.0)
    assert np.all(found.relative[:, 1] > found.relative[:, 2])
    assert np.log(4) / 8 > 0.15 > np.log(4) / 16
