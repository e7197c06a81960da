"""Comma-separated tables: numbers that read back the same, and cells that may be empty."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.trajectory_io.strict_json import read_text

# Cells of one table, at 80 bytes each: the trajectories of a hundred vehicles have 2.3 million.
MOST_CELLS = 3_000_000


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


@dataclass(frozen=True)
class Table:
    """What a file says, as text.

    Attributes:
        where: the file, for errors.
        columns: cells (k,) by the names of the header, in its order.
    """

    where: str
    columns: Mapping[str, Sequence[str]]

    @property
    def header(self) -> tuple[str, ...]:
        return tuple(self.columns)

    def cells(self, name: str) -> Sequence[str]:
        """Of the column ``name``; InputError where there is none."""
        if name not in self.columns:
            raise InputError(self.where, f"has no column {name!r}")
        return self.columns[name]

    def numbers(self, name: str, rows: Sequence[int]) -> Array:
        """Numbers (k,) of a column in these rows; NaN for an empty cell.

        Raises:
            InputError: no such column, or a cell that is neither empty nor a finite number.
        """
        cells, where = self.cells(name), f"{self.where}, column {name}"
        return np.array([_number(cells[row], where) for row in rows], dtype=np.float64)

    def rows_by(self, *names: str) -> dict[tuple[str, ...], list[int]]:
        """Numbers of the rows that have the same text in these columns, in order."""
        groups: dict[tuple[str, ...], list[int]] = {}
        for row, key in enumerate(zip(*map(self.cells, names), strict=True)):
            groups.setdefault(key, []).append(row)
        return groups


def read_table(path: Path) -> Table:
    """The table in a file.

    Raises:
        InputError: missing, not text, too large, no header, a column twice, or a row of another
            length.
    """
    where, content = str(path), read_text(path)
    if content.count(",") + content.count("\n") > MOST_CELLS:
        raise InputError(where, "has too many cells", f"at most {MOST_CELLS}")
    try:
        lines = list(csv.reader(io.StringIO(content, newline=""), strict=True))
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
    columns = zip(*lines[1:], strict=True) if len(lines) > 1 else [()] * len(header)
    return Table(where, dict(zip(header, columns, strict=True)))


def _number(cell: str, where: str) -> float:
    if cell == "":
        return math.nan
    try:
        value = float(cell)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise InputError(where, f"holds {cell[:40]!r}", "a finite number")
    return value
