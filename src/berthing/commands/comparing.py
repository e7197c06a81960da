"""``berthing compare``."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import typer
from rich.console import Console
from rich.table import Table

from berthing.commands.console import progress_line
from berthing.commands.exit_codes import CERTIFIED
from berthing.comparison import METHODS, Comparison, compare
from berthing.errors import InputError
from berthing.report.comparison_table import HEADERS, NOTE, document, markdown, table_rows
from berthing.scenario.files import load
from berthing.whole_file import write_whole

ENDINGS = (".json", ".md")

WIDTH = 140
"""Columns where nobody watches: no name is cut."""


def run(
    name: str, formulations: Sequence[str], guesses: int | None, seed: int, limit_s: float,
    out: Path | None, *, as_json: bool,
) -> int:  # fmt: skip
    """Compare formulations on the scenario called ``name``; the exit code.

    Args:
        formulations: which; all of them where empty.
        guesses: how many; all of the planner's where None.
        out: a file to write, JSON or Markdown by its ending; None for none.
        as_json: print JSON only.

    Raises:
        InputError: anything wrong with the input, or a file that cannot be written.
    """
    _check(guesses, limit_s, out)
    scenario = load(name)
    with progress_line() as progress:
        found = compare(
            scenario, tuple(formulations) or METHODS, guesses=guesses, seed=seed, limit_s=limit_s,
            progress=progress,
        )  # fmt: skip
    if out is not None:
        _write(out, found)
    if as_json:
        typer.echo(json.dumps(document(found), indent=2, ensure_ascii=False))
    else:
        _print(found)
    return CERTIFIED


def _check(guesses: int | None, limit_s: float, out: Path | None) -> None:
    if guesses is not None and guesses < 1:
        raise InputError("--guesses", f"is {guesses}", "1 or more")
    if not limit_s > 0.0:
        raise InputError("--time-limit", f"is {limit_s:g}", "more than zero seconds")
    if out is None:
        return
    if out.suffix not in ENDINGS:
        raise InputError(str(out), "has no ending that is known", " or ".join(ENDINGS))
    if not out.parent.is_dir():
        raise InputError(str(out.parent), "is no folder", "a folder that exists")


def _write(out: Path, found: Comparison) -> None:
    text = json.dumps(document(found), indent=2, ensure_ascii=False) + "\n"
    if out.suffix == ".md":
        text = markdown(found)
    try:
        write_whole(out, text)
    except OSError as error:
        raise InputError(str(out), f"cannot be written: {error.strerror or error}") from None


def _print(found: Comparison) -> None:
    console = Console(highlight=False)
    if not console.is_terminal:
        console = Console(highlight=False, width=WIDTH)
    table = Table(box=None, padding=(0, 2, 0, 0))
    for i, header in enumerate(HEADERS):
        table.add_column(header, justify="left" if i == 0 else "right", no_wrap=True)
    for row in table_rows(found):
        table.add_row(*row)
    console.print(f"{found.scenario}: {found.nodes} nodes, the same guesses for each")
    console.print(table, soft_wrap=True)
    for name, why in found.refused.items():
        console.print(f"{name}: {why}", soft_wrap=True)
    console.print(NOTE, soft_wrap=True)
