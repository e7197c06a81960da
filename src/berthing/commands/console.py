"""The terminal: tables on it, and progress while there is somebody to watch."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

from rich.console import Console
from rich.progress import Progress, TextColumn, TimeElapsedColumn
from rich.table import Column, Table
from rich.text import Text

from berthing.report.verdict_table import Row
from berthing.result import ProgressEvent

STYLES = {None: "", True: "bold green", False: "bold red"}


def print_rows(rows: Sequence[Row]) -> None:
    """Two columns on standard output; elsewhere than on a terminal, lines are never broken."""
    console = Console(highlight=False)
    if console.is_terminal:
        table = Table(show_header=False, box=None, padding=(0, 2, 0, 0))
        for row in rows:
            table.add_row(Text(row.label), Text(row.value, style=STYLES[row.good]))
        console.print(table)
        return
    width = max(len(row.label) for row in rows)
    for row in rows:
        console.print(Text(f"{row.label:<{width}}  {row.value}"), soft_wrap=True)


@contextmanager
def progress_line() -> Iterator[Callable[[ProgressEvent], None] | None]:
    """A line on standard error that follows the planner; None where nobody watches.

    It is drawn anew with each event and by no thread of its own: the planner forks.
    """
    console = Console(stderr=True)
    if not console.is_terminal:
        yield None
        return
    columns = (
        TimeElapsedColumn(Column(no_wrap=True, min_width=7)),
        TextColumn("{task.description}", table_column=Column(no_wrap=True, overflow="ellipsis")),
    )
    line = Progress(
        *columns, console=console, transient=True, auto_refresh=False, redirect_stdout=False,
        redirect_stderr=False,
    )  # fmt: skip
    with line:
        task = line.add_task("starting", total=None)
        yield lambda event: line.update(task, description=describe(event), refresh=True)


def describe(event: ProgressEvent) -> str:
    """An event in one line.

    >>> describe(ProgressEvent("solve", "over T1.plate", 120, 0.0993))
    'solve · over T1.plate · 120 iterations · clearance 0.0993 m'
    """
    parts = [event.stage, event.detail]
    if event.iterations:
        parts.append(f"{event.iterations} iterations")
    if event.clearance_m is not None:
        parts.append(f"clearance {event.clearance_m:.4f} m")
    return " · ".join(part for part in parts if part)
