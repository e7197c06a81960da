"""``berthing route``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import typer

from berthing.commands.console import print_rows, progress_line
from berthing.commands.exit_codes import CERTIFIED, NO_PLAN
from berthing.report.fresh_folder import check_target
from berthing.report.plan_json import summary, to_text
from berthing.report.route_folder import write_routes
from berthing.report.verdict_table import Row, headline
from berthing.routes.routing import Routes, route
from berthing.scenario.files import load

DEFAULT_FOLDER = Path("routes")


def run(
    name: str, seed: int, classes: int, time_limit_s: float | None, out: Path | None,
    *, force: bool, figures: bool, as_json: bool,
) -> int:  # fmt: skip
    """Find routes through the scenario called ``name`` and write them; the exit code.

    Args:
        seed, classes, time_limit_s: of ``route``.
        out: the folder; None for the default.
        force: replace an older folder.
        figures: draw each route too.
        as_json: print JSON only.

    Raises:
        InputError: anything wrong with the input or with the folder.
        KeyboardInterrupt: by the user; nothing is written.
    """
    scenario = load(name)
    target = DEFAULT_FOLDER / scenario.name if out is None else out
    check_target(target, force=force)
    options: dict[str, Any] = {"seed": seed, "classes": classes, "time_limit_s": time_limit_s}
    with progress_line() as progress:
        found = route(scenario, **options, progress=progress)
        document = write_routes(scenario, found, options, target, force=force, figures=figures)
    if as_json:
        typer.echo(to_text(summary(document, str(target))), nl=False)
    else:
        print_rows([*rows(found), Row("written to", str(target))])
    return CERTIFIED if found.routes else NO_PLAN


def rows(found: Routes) -> list[Row]:
    """What was found, as a table."""
    lines = [headline(found.outcome)]
    if found.frame is not None:
        lines.append(Row("frame", f"of {found.frame}, which moves"))
    for number, own in enumerate(found.routes):
        legs = own.legs.closest
        nearest = "" if legs is None else f", {legs[0].replace('|', ', ')} the closest"
        clearance = f"clearance ≥ {own.clearance_m:.6g} m" if legs else "nothing in the way"
        value = f"{len(own.legs.bound_m)} legs, {own.length_m:.4g} m, {clearance}{nearest}"
        lines.append(Row(f"route {number}", value, True))
    if not found.routes:
        lines.append(Row("searches", f"{len(found.searches)}, with no way found", False))
    return [*lines, Row("time", f"{found.wall_time_s:.2f} s")]
