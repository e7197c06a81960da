"""Clearance sampled along a trajectory."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.refine.sampling import SampledClearance, sample_clearance, sample_times
from berthing.scenario.scenario import Scenario
from berthing.trajectory import PhaseTrajectory
from berthing.transcription.extract import trajectories
from support.documents import DURATION_S, box, puck, scenario, structure
from support.solving import guessed, posed

POST = structure("post", [3, 0.1], {"type": "sphere", "radius_m": 0.6})
DOCK = structure("dock", [9, 0], box(2, 2))


def straight(given: Scenario) -> PhaseTrajectory:
    """The puck straight from start to goal, at (3 s² − 2 s³) · 6 m."""
    problem = posed(given, 4, 4, sites=[])
    return trajectories(problem, guessed(problem))


def sampled(given: Scenario, near_m: float = 100.0) -> SampledClearance:
    trajectory = straight(given)
    times = sample_times(trajectory, 16)
    return sample_clearance(given, given.pairs(given.phases[0]), trajectory, times, near_m)


def x_of(times: np.ndarray) -> np.ndarray:
    s = times / DURATION_S
    return 6.0 * s**2 * (3.0 - 2.0 * s)


def test_times_are_in_every_segment_with_both_ends() -> None:
    times = sample_times(straight(scenario(puck())), 16)
    assert len(times) == 4 * 16 + 1
    np.testing.assert_allclose(times, np.linspace(0.0, DURATION_S, 65), atol=1e-12)


def test_distances_are_exact_and_shortfalls_count_from_the_margin() -> None:
    got = sampled(scenario(puck(), structures=[POST, DOCK]))
    x = x_of(got.times_s)
    post = np.hypot(x - 3.0, 0.1) - 1.1
    np.testing.assert_allclose(got.distances_m[0], post, atol=1e-6)
    np.testing.assert_allclose(got.distances_m[1], 8.0 - x - 0.5, atol=1e-6)
    np.testing.assert_allclose(got.shortfall_m, 0.1 - got.distances_m, atol=1e-15)
    assert got.worst_m == pytest.approx(1.1, abs=2e-3)


def test_far_things_get_a_lower_bound_that_is_not_below_what_was_asked() -> None:
    given = scenario(puck(), structures=[DOCK])
    exact, rough = sampled(given), sampled(given, near_m=3.0)
    assert np.all(rough.distances_m <= exact.distances_m + 1e-9)
    replaced = ~np.isclose(rough.distances_m, exact.distances_m, atol=1e-9)
    assert replaced.any()
    assert not replaced.all()
    assert np.min(rough.distances_m[replaced]) >= 3.0


def test_margins_follow_their_windows_and_contact_counts_for_nothing() -> None:
    overrides = [
        {"between": ["puck", "dock"], "margin_m": 0.02, "window_s": [50, 100]},
        {"between": ["puck", "dock"], "contact": "allowed", "window_s": [90, 100]},
    ]
    margins = {"default_m": 0.1, "overrides": overrides}
    got = sampled(scenario(puck(), structures=[DOCK], margins=margins))
    times, margin = got.times_s, got.margins_m[0]
    np.testing.assert_array_equal(margin[times < 50], 0.1)
    np.testing.assert_array_equal(margin[(times > 50) & (times < 90)], 0.02)
    assert np.isnan(margin[times > 90]).all()
    assert np.isneginf(got.shortfall_m[0, times > 90]).all()
    assert np.isfinite(got.worst_m)


def test_moving_structures_are_where_they_are_at_the_time() -> None:
    moving = POST | {"motion": {"type": "constant-velocity", "velocity_m_s": [0, 0.05]}}
    got = sampled(scenario(puck(), structures=[moving]))
    x, y = x_of(got.times_s) - 3.0, 0.1 + 0.05 * got.times_s
    np.testing.assert_allclose(got.distances_m[0], np.hypot(x, y) - 1.1, atol=1e-6)


def test_vehicles_are_sampled_against_each_other() -> None:
    other = puck("other", start={"position_m": [6, 2]}, goal={"position_m": [0, 2]})
    got = sampled(scenario(puck(), other))
    expected = np.hypot(6.0 - 2.0 * x_of(got.times_s), 2.0) - 1.0
    np.testing.assert_allclose(got.distances_m[0], expected, atol=1e-6)


def test_without_pairs_nothing_is_short() -> None:
    got = sampled(scenario(puck()))
    assert got.distances_m.shape == (0, 65)
    assert got.worst_m == -np.inf
