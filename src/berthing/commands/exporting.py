"""``berthing export``."""

from __future__ import annotations

from pathlib import Path

import typer

from berthing.export.exporting import export
from berthing.export.formats import format_named
from berthing.export.meta import read_meta


def run(
    folder: Path,
    format_name: str | None,
    out: Path | None,
    vehicle: str | None,
    meta_file: Path | None,
    *,
    trust: bool = False,
) -> int:
    """Write the plan in a folder as a file of another format; the exit code.

    Args:
        folder: a plan folder.
        format_name: a key of ``FORMATS``; None is refused, with the options.
        out: the file; None for a name in the working folder.
        vehicle: only this one.
        meta_file: a file with keys of ``meta:`` that overrule the scenario's.
        trust: run code of the user's own that the folder holds.

    Raises:
        InputError: anything wrong with the input, or a package missing.
    """
    kind = format_named(format_name)
    given = {} if meta_file is None else read_meta(meta_file)
    for path in export(folder, kind, out, vehicle=vehicle, extra_meta=given, trust=trust):
        typer.echo(path)
    return 0
