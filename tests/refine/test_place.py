"""Where sites are put: near things, and around dips."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.refine.place import dip_sites, near_sites, peaks, sites_around
from berthing.refine.sampling import SampledClearance
from berthing.transcription.mesh import Mesh
from berthing.transcription.sites import Site, node_sites

MESH = Mesh.uniform("lgr", 4, 3)
TIMES = np.linspace(20.0, 120.0, 401)
SPACING_S, REACH_S = 2.0, 6.0


def clearance(*dips: tuple[float, float]) -> SampledClearance:
    """One pair for each (time, depth): a margin of 0.1 missed by ``depth`` at that time."""
    distance = np.array([0.1 - depth + 0.01 * np.abs(TIMES - t) for t, depth in dips])
    return SampledClearance(TIMES, distance, np.full_like(distance, 0.1))


def times_of(sites: list[Site], pair: int) -> np.ndarray:
    fractions = [MESH.fraction(site.segment, site.s) for site in sites if site.pair == pair]
    return np.sort(20.0 + 100.0 * np.array(fractions))


def test_peaks_are_the_local_maxima_above_what_is_allowed() -> None:
    shortfall = np.array([0.3, 0.1, 0.2, -0.1, 0.0, -0.2, -0.3, -0.1])
    np.testing.assert_array_equal(peaks(shortfall, -0.05), [0, 2, 4])
    np.testing.assert_array_equal(peaks(shortfall, -0.5), [0, 2, 4, 7])
    np.testing.assert_array_equal(peaks(shortfall, 0.25), [0])
    assert not len(peaks(shortfall, 0.3))


def test_a_pair_that_may_touch_has_no_peaks() -> None:
    assert not len(peaks(np.full(5, -np.inf), 0.0))


def test_near_sites_are_the_nodes_around_the_times_of_nearness() -> None:
    found = near_sites(MESH, 2, clearance((60.0, 0.0), (100.0, -0.5)), 0.2)
    assert set(found) <= set(node_sites(MESH, 2))
    times = times_of(found, 0)
    # Within 0.2 m for 20 s either side, and half a segment further.
    nodes = times_of(node_sites(MESH, 1), 0)
    expected = nodes[(nodes >= 40 - 12.5) & (nodes <= 80 + 12.5)]
    assert 3 < len(expected) < len(nodes)
    np.testing.assert_allclose(times, expected)
    # The second pair never comes near.
    assert not len(times_of(found, 1))


def test_with_a_wide_enough_reach_all_nodes_are_near() -> None:
    assert near_sites(MESH, 1, clearance((60.0, 0.0)), 10.0) == node_sites(MESH, 1)


def test_a_dip_is_filled_with_sites_around_its_bottom() -> None:
    found = dip_sites(MESH, [], clearance((61.0, 0.02)), 0.0, SPACING_S, REACH_S)
    expected = 61.0 + SPACING_S * np.arange(-3, 4)
    np.testing.assert_allclose(times_of(found, 0), expected, atol=1e-9)
    assert found == sorted(found)


def test_a_dip_within_what_is_allowed_is_left() -> None:
    sampled = clearance((61.0, -0.001))
    assert dip_sites(MESH, [], sampled, 0.0, SPACING_S, REACH_S) == []
    assert dip_sites(MESH, [], sampled, -0.002, SPACING_S, REACH_S) != []


def test_each_pair_gets_its_own_sites_and_the_old_ones_stay() -> None:
    before = [Site(0, 0.5, 1)]
    found = dip_sites(MESH, before, clearance((61.0, 0.02), (90.0, 0.01)), 0.0, SPACING_S, REACH_S)
    assert set(before) <= set(found)
    assert pytest.approx(np.median(times_of(found, 0))) == 61.0
    assert len(times_of(found, 0)) == 7
    assert len(times_of(found, 1)) == 8


def test_sites_that_are_there_already_are_not_asked_twice() -> None:
    once = sites_around(MESH, [], [(0, 61.0)], (20.0, 120.0), SPACING_S, REACH_S)
    assert sites_around(MESH, once, [(0, 61.0)], (20.0, 120.0), SPACING_S, REACH_S) == once
    # A little aside, only the bottom itself is new: the neighbourhood is filled already.
    moved = sites_around(MESH, once, [(0, 61.5)], (20.0, 120.0), SPACING_S, REACH_S)
    assert len(moved) == len(once) + 1
    assert np.any(np.isclose(times_of(moved, 0), 61.5))
    # Two dips in one place are one.
    twice = sites_around(MESH, [], [(0, 61.0), (0, 61.0)], (20.0, 120.0), SPACING_S, REACH_S)
    assert twice == once


def test_sites_of_one_pair_are_never_in_one_place() -> None:
    rng = np.random.default_rng(5)
    dips = [(0, float(t)) for t in rng.uniform(20.0, 120.0, size=60)]
    dips += [(0, 20.0 + 25.0 * k) for k in range(5)]
    found = sites_around(MESH, node_sites(MESH, 1), dips, (20.0, 120.0), SPACING_S, REACH_S)
    assert np.min(np.diff(times_of(found, 0))) > 0.02 * SPACING_S
    assert len(set(found)) == len(found)


def test_nothing_is_asked_outside_the_phase() -> None:
    dips = [(0, 20.5), (0, 119.5)]
    times = times_of(sites_around(MESH, [], dips, (20.0, 120.0), SPACING_S, REACH_S), 0)
    assert np.min(times) > 20.0
    assert np.max(times) < 120.0
    assert len(times) == 8
