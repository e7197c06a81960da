"""Margins by pair and by time."""

from __future__ import annotations

import pytest

from berthing.errors import InputError
from berthing.scenario.margin import MarginOverride, MarginPolicy

POLICY = MarginPolicy(
    0.1,
    (
        MarginOverride("tug", "dock", 0.05),
        MarginOverride("dock.port", "tug.nose", 0.02, (100.0, 140.0)),
        MarginOverride("tug.nose", "dock.port", None, (130.0, 150.0)),
    ),
)


def test_later_overrides_win_and_order_does_not_matter() -> None:
    assert POLICY.margin("tug.hull", "truss.bay", 0.0) == 0.1
    assert POLICY.margin("tug.hull", "dock.port", 120.0) == 0.05
    for pair in (("tug.nose", "dock.port"), ("dock.port", "tug.nose")):
        assert POLICY.margin(*pair, 50.0) == 0.05
        assert POLICY.margin(*pair, 120.0) == 0.02
        assert POLICY.margin(*pair, 135.0) is None
        assert POLICY.margin(*pair, 150.0) is None
        assert POLICY.margin(*pair, 150.1) == 0.05


def test_names_are_matched_whole() -> None:
    assert POLICY.margin("tug2.nose", "dock.port", 120.0) == 0.1
    assert POLICY.margin("tug.nose2", "dock.port", 120.0) == 0.05


def test_windows_cut_the_span_where_the_margin_changes() -> None:
    assert POLICY.windows("tug.nose", "dock.port", (0.0, 160.0)) == [
        (0.0, 100.0, 0.05),
        (100.0, 130.0, 0.02),
        (130.0, 150.0, None),
        (150.0, 160.0, 0.05),
    ]
    assert POLICY.windows("tug.nose", "dock.port", (110.0, 120.0)) == [(110.0, 120.0, 0.02)]
    assert POLICY.windows("tug.nose", "dock.port", (100.0, 130.0)) == [(100.0, 130.0, 0.02)]
    assert POLICY.windows("tug.hull", "truss.bay", (0.0, 160.0)) == [(0.0, 160.0, 0.1)]


def test_equal_neighbours_are_one_window() -> None:
    policy = MarginPolicy(
        0.1, (MarginOverride("a", "b", 0.1, (1, 2)), MarginOverride("a", "b", 0.2, (3, 4)))
    )
    assert policy.windows("a.x", "b.y", (0.0, 5.0)) == [
        (0.0, 3.0, 0.1),
        (3.0, 4.0, 0.2),
        (4.0, 5.0, 0.1),
    ]


def test_bad_margins_are_refused() -> None:
    with pytest.raises(InputError, match="default_m"):
        MarginPolicy(-0.1)
    with pytest.raises(InputError, match="margin_m"):
        MarginOverride("a", "b", float("nan"))
    with pytest.raises(InputError, match="window_s"):
        MarginOverride("a", "b", 0.1, (5.0, 5.0))
