"""Comma-separated tables: numbers that read back the same, and cells that may be empty."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.trajectory_io.strict_json import read_text

Row = dict[str, str]


def rows_of(
    header: Sequence[str], labels: Mapping[str, str], columns: Mapping[str, Array]
) -> Iterable[list[str]]:
    """Rows in the order of ``header``: labels repeated, numbers printed, the rest empty.

    NaN is printed as an empty cell: a value that is not there.
    """
    count = len(next(iter(columns.values())))
    blank = [""] * count
    cells = [
        [labels[name]] * count
        if name in labels
        else _printed(columns[name])
        if name in columns
        else blank
        for name in header
    ]
    return (list(row) for row in zip(*cells, strict=True))


def _printed(values: Array) -> list[str]:
    # repr gives the shortest digits that read back the same, 17 at most.
    return ["" if math.isnan(v) else repr(v) for v in values.tolist()]


def write_table(path: Path, header: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
    """Write a header and rows."""
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def read_table(path: Path) -> tuple[tuple[str, ...], list[Row]]:
    """The header and the rows by column.

    Raises:
        InputError: missing, not text, no header, a column twice, or a row of another length.
    """
    where = str(path)
    try:
        lines = list(csv.reader(io.StringIO(read_text(path), newline=""), strict=True))
    except csv.Error as error:
        raise InputError(where, f"is not a table: {error}") from None
    if not lines:
        raise InputError(where, "is empty")
    header = tuple(lines[0])
    if len(set(header)) < len(header):
        raise InputError(where, "names a column twice")
    for number, line in enumerate(lines[1:], start=2):
        if len(line) != len(header):
            raise InputError(f"{where}, line {number}", f"has {len(line)} cells", str(len(header)))
    return header, [dict(zip(header, line, strict=True)) for line in lines[1:]]


def column(rows: Sequence[Row], name: str, where: str) -> Array:
    """Numbers (k,) of a column; NaN for an empty cell.

    Raises:
        InputError: no such column, or a cell that is neither empty nor a finite number.
    """
    return np.array([_number(row, name, where) for row in rows], dtype=np.float64)


def _number(row: Row, name: str, where: str) -> float:
    if name not in row:
        raise InputError(where, f"has no column {name!r}")
    if row[name] == "":
        return math.nan
    try:
        value = float(row[name])
    except ValueError:
        raise InputError(
            f"{where}, column {name}", f"holds {row[name][:40]!r}", "a number"
        ) from None
    if not math.isfinite(value):
        raise InputError(f"{where}, column {name}", f"holds {row[name][:40]!r}", "a finite number")
    return value
