"""Rows have names, and the worst of them is told."""

from __future__ import annotations

import numpy as np
import pytest

from berthing.transcription.rows import RowBook


@pytest.fixture
def book() -> RowBook:
    made = RowBook()
    made.add(2, 0.0, 0.0, lambda i: f"dynamics[{'xy'[i]}]")
    made.add(
        3, 0.0, np.inf, lambda i: f"separation[{i}]", unit_scale=10.0, unit="m", key="separation"
    )
    made.add(1, [-1.0], [1.0], lambda i: "limit", key="limit")
    return made


def test_rows_are_numbered_and_bounded_in_order(book) -> None:
    lower, upper = book.bounds()
    np.testing.assert_array_equal(lower, [0, 0, 0, 0, 0, -1])
    np.testing.assert_array_equal(upper, [0, 0, np.inf, np.inf, np.inf, 1])
    assert book.size == 6
    np.testing.assert_array_equal(book.add(2, 0.0, 1.0, str), [6, 7])


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ([0, 0.01, 1, 1, 1, 0], "dynamics[y] short by 0.01"),
        ([0, -0.01, 1, -0.02, 1, 0], "separation[1] short by 0.2 m"),
        ([0, 0, 1, 1, 1, 1.5], "limit short by 0.5"),
        ([0, 0, 1, 1, 1, -1.25], "limit short by 0.25"),
        ([0, np.nan, 1, 1, 1, -9.0], "dynamics[y] short by nan"),
    ],
)
def test_the_worst_row_is_named_with_its_unit(book, values, expected) -> None:
    assert book.worst(np.array(values, dtype=float)) == expected


def test_where_all_hold_nothing_is_short(book) -> None:
    assert book.worst(np.array([0.0, 0, 5, 5, 5, 0])).endswith("short by 0")


def test_no_rows_at_all_are_no_failure() -> None:
    empty = RowBook()
    assert empty.worst(np.empty(0)) == "no rows"
    assert empty.bounds()[0].shape == (0,)


def test_carrying_follows_keys_and_sizes(book) -> None:
    other = RowBook()
    other.add(2, 0.0, 0.0, str)
    other.add(1, 0.0, 0.0, str, key="limit")
    other.add(2, 0.0, 0.0, str, key="separation")
    other.add(1, 0.0, 0.0, str, key="new")
    carried = book.carry(np.array([1.0, 2, 3, 4, 5, 6]), other)
    np.testing.assert_array_equal(carried, [1, 2, 6, 0, 0, 0])
