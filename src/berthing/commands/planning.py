"""``berthing plan``."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import typer

from berthing import planner
from berthing import result as outcomes
from berthing.commands.console import print_rows, progress_line
from berthing.commands.exit_codes import CERTIFIED, NO_PLAN, NOT_CERTIFIED
from berthing.report import verdict_table
from berthing.report.folder import write_result
from berthing.report.fresh_folder import check_target
from berthing.report.plan_json import summary, to_text
from berthing.result import ProgressEvent, Result
from berthing.scenario.files import load
from berthing.scenario.options import SolverOptions
from berthing.scenario.scenario import Scenario

DEFAULT_FOLDER = Path("plans")


def run(
    name: str, given: Mapping[str, Any], out: Path | None, *, force: bool, as_json: bool
) -> int:
    """Plan the scenario called ``name`` and write what comes out; the exit code.

    Args:
        name: a case that ships, or a file.
        given: options of ``SolverOptions`` by name; None leaves the scenario's own.
        out: the plan folder; None for the default.
        force: replace an older plan folder.
        as_json: print JSON only.

    Raises:
        InputError: anything wrong with the input or with the folder.
        KeyboardInterrupt: by the user; nothing is written.
    """
    scenario = load(name)
    options = chosen_options(scenario, given)
    target = DEFAULT_FOLDER / scenario.name if out is None else out
    check_target(target, force=force)
    with progress_line() as progress:
        result = planner.plan(scenario, options=options, progress=progress)
        if result.outcome == outcomes.INTERRUPTED:
            raise KeyboardInterrupt
        if progress is not None:
            progress(ProgressEvent("report", "figures and files"))
        document = write_result(scenario, result, options, target, force=force)
    if as_json:
        typer.echo(to_text(summary(document, str(target))), nl=False)
    else:
        rows = verdict_table.result_rows(scenario, result)
        print_rows([*rows, verdict_table.Row("written to", str(target))])
    return exit_code(result)


def chosen_options(scenario: Scenario, given: Mapping[str, Any]) -> SolverOptions:
    """The scenario's wishes, overruled by what is given; InputError for a value out of range."""
    return replace(scenario.solver, **{k: v for k, v in given.items() if v is not None})


def exit_code(result: Result) -> int:
    """What the shell is told of an answer that was written."""
    if result.plan is None:
        return NO_PLAN
    return CERTIFIED if result.outcome == outcomes.CERTIFIED else NOT_CERTIFIED
