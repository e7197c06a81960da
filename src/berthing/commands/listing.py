"""``berthing scenarios`` and ``berthing schema``."""

from __future__ import annotations

import json

import typer

from berthing.commands.exit_codes import CERTIFIED
from berthing.scenario.files import json_schema
from berthing.scenario.library import library


def print_scenarios(*, as_json: bool) -> int:
    """Names and one line about each."""
    cases = library()
    if as_json:
        typer.echo(json.dumps(cases, indent=2, ensure_ascii=False))
        return CERTIFIED
    width = max(map(len, cases), default=0)
    for name, headline in cases.items():
        typer.echo(f"{name:{width}}  {headline}")
    return CERTIFIED


def print_schema() -> int:
    """JSON Schema of the scenario file."""
    typer.echo(json.dumps(json_schema(), indent=2, ensure_ascii=False))
    return CERTIFIED
