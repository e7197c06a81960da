"""The terminal: tables on it, and progress while there is somebody to watch."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

from rich.console import Console
from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn
from rich.table import Table
from rich.text import Text

from berthing.report.verdict_table import Row
from berthing.result import ProgressEvent

STYLES = {None: "", True: "bold green", False: "bold red"}


def print_rows(rows: Sequence[Row]) -> None:
    """A table of two columns on standard output; plain text where that is no terminal."""
    table = Table(show_header=False, box=None, padding=(0, 2, 0, 0))
    for row in rows:
        table.add_row(Text(row.label), Text(row.value, style=STYLES[row.good]))
    console = Console(highlight=False)
    console.print(table, soft_wrap=not console.is_terminal)


@contextmanager
def progress_line() -> Iterator[Callable[[ProgressEvent], None] | None]:
    """A line on standard error that follows the planner; None where nobody watches."""
    console = Console(stderr=True)
    if not console.is_terminal:
        yield None
        return
    columns = (SpinnerColumn(), TextColumn("{task.description}"), TimeElapsedColumn())
    with Progress(*columns, console=console, transient=True) as progress:
        task = progress.add_task("starting", total=None)
        yield lambda event: progress.update(task, description=describe(event))


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
