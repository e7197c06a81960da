"""Closing in on touches: which stretch comes next, and the mesh and sites that go with it."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.refine.sampling import SampledClearance
from berthing.refine.touches import (
    FIRST,
    NARROWEST,
    SHRINK,
    Bottom,
    Pull,
    Touch,
    bottoms,
    closed_in,
    cut,
    downhill,
    touch_sites,
)
from berthing.transcription.mesh import Mesh

NODE = 0.02


def never(touch: Touch) -> bool:
    return False


def bottom(at: float, *pulls: tuple[float, float]) -> Bottom:
    return Bottom(0, at, tuple(Pull(0, t, force) for t, force in pulls))


def follow(truth: float, share: float, rounds: int) -> list[Touch]:
    """Rounds on a model of one touch: two active rows about it balance as levers do; a single one
    leaves the least clearance ``share`` of its own miss from the truth."""
    begun = truth + 0.3 * NODE
    low = bottom(truth + share * (begun - truth), (begun, 1.0))
    touches: list[Touch] = []
    history = []
    for _ in range(rounds):
        touches = [closed_in(touches, low, NODE, never)]
        history += touches
        begin, end = touches[0].begin, touches[0].end
        if begin < truth < end:
            low = bottom(truth, (begin, end - truth), (end, truth - begin))
        else:
            row = end if truth > end else begin
            low = bottom(truth + share * (row - truth), (row, 1.0))
    return history


@pytest.mark.parametrize("share", [-1.0, -0.5, 0.0, 0.3, 0.6])
def test_stretches_close_in_on_the_touch(share: float) -> None:
    truth = 0.4321
    history = follow(truth, share, 9)
    assert abs(0.5 * (history[-1].begin + history[-1].end) - truth) < 1e-3 * NODE
    assert history[-1].width < 1e-2 * NODE


def test_a_stretch_that_holds_its_touch_shrinks_onto_where_its_rows_balance() -> None:
    old = Touch(0, 0.50, 0.51)
    new = closed_in([old], bottom(0.506, (0.50, 1.0), (0.51, 3.0)), NODE, never)
    assert new.width == pytest.approx(SHRINK * old.width)
    assert 0.5 * (new.begin + new.end) == pytest.approx(0.5075)


def test_a_stretch_that_is_narrow_enough_stays() -> None:
    old = Touch(0, 0.50, 0.51)
    low = bottom(0.506, (0.50, 1.0), (0.51, 3.0))
    assert closed_in([old], low, NODE, lambda touch: True) == old
    # But not where a row outside is active: the touch is elsewhere.
    outside = bottom(0.515, (0.51, 1.0), (0.52, 3.0))
    assert closed_in([old], outside, NODE, lambda touch: True) != old


def test_widths_have_bounds() -> None:
    first = closed_in([], bottom(0.3, (0.3, 1.0)), NODE, never)
    assert first.width == pytest.approx(FIRST * NODE)
    far = closed_in([], bottom(0.3, (0.6, 1.0)), NODE, never)
    assert far.width == pytest.approx(NODE)
    tiny = Touch(0, 0.5, 0.5 + 2.0 * NARROWEST)
    low = bottom(0.5, (tiny.begin, 1.0), (tiny.end, 1.0))
    assert closed_in([tiny], low, NODE, never).width == pytest.approx(NARROWEST)
    edge = closed_in([], bottom(0.0, (0.001, 1.0)), NODE, never)
    assert edge.begin == 0.0


def test_other_pairs_stretches_are_not_its_own() -> None:
    other = Touch(1, 0.49, 0.52)
    low = bottom(0.5, (0.49, 1.0), (0.52, 1.0))
    assert closed_in([other], low, NODE, never).width == pytest.approx(SHRINK * 0.03)


def test_rows_on_one_slope_belong_to_one_least_clearance() -> None:
    at = np.linspace(0.0, 1.0, 101)
    distance = np.minimum((at - 0.3) ** 2, (at - 0.8) ** 2 + 0.01)[None]
    sampled = SampledClearance(100.0 * at, distance, np.zeros_like(distance))
    found = [Pull(0, 0.2, 1.0), Pull(0, 0.35, 2.0), Pull(0, 0.9, 3.0)]
    lows = bottoms(found, sampled, at, lambda pair, low, high: 0.5 * (low + high))
    assert [low.at for low in lows] == pytest.approx([0.3, 0.8])
    assert [len(low.pulls) for low in lows] == [2, 1]
    assert downhill(np.array([3.0, 2.0, 2.0, 1.0]), 0) == 1


def test_breaks_stand_at_both_ends_of_a_touch_and_crowd_nothing() -> None:
    base = Mesh.uniform("lgr", 10, 4)
    mesh = cut(base, [Touch(0, 0.301, 0.302), Touch(1, 0.45, 0.451)])
    assert {0.301, 0.302, 0.45, 0.451} <= set(mesh.breaks)
    # 0.3 made room; 0.4 and 0.5 are far enough.
    assert set(base.breaks) - set(mesh.breaks) == {base.breaks[3]}
    assert cut(base, []) == base
    # Ends that all but coincide are one: three new ones, for which 0.4 makes room.
    assert len(cut(base, [Touch(0, 0.35, 0.36), Touch(1, 0.36 + 1e-9, 0.37)]).breaks) == 13


def test_rows_stand_at_the_ends_and_others_keep_clear() -> None:
    touch = Touch(0, 0.30, 0.31)
    mesh = cut(Mesh.uniform("lgr", 10, 4), [touch])
    guards = {(0, 0.305), (0, 0.296), (0, 0.314), (0, 0.29), (0, 0.33), (1, 0.305)}
    sites = touch_sites(mesh, [touch], guards)
    places = {(site.pair, round(mesh.fraction(site.segment, site.s), 9)) for site in sites}
    assert places == {(0, 0.30), (0, 0.31), (0, 0.29), (0, 0.33), (1, 0.305)}
    ends = [site for site in sites if site.s == -1.0]
    assert len(ends) == 2
