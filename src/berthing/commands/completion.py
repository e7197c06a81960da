"""What the shell offers while a command is typed."""

from __future__ import annotations

from pathlib import Path

SCENARIO_FILES = (".yaml", ".yml", ".json")


def scenarios(incomplete: str) -> list[str]:
    """Cases that ship, and scenario files and folders, that begin like this."""
    from berthing.scenario.library import library

    cases = [name for name in library() if name.startswith(incomplete)]
    return cases + _files(incomplete)


def formats(incomplete: str) -> list[str]:
    """Export formats that begin like this."""
    from berthing.export.formats import FORMATS

    return [name for name in FORMATS if name.startswith(incomplete)]


def _files(incomplete: str) -> list[str]:
    parent, start = Path(incomplete).parent, Path(incomplete).name
    if incomplete.endswith("/"):
        parent, start = Path(incomplete), ""
    if not parent.is_dir():
        return []
    shown = [
        path
        for path in sorted(parent.iterdir())
        if path.name.startswith(start)
        and (start.startswith(".") or not path.name.startswith("."))
        and (path.is_dir() or path.suffix in SCENARIO_FILES)
    ]
    return [f"{path}/" if path.is_dir() else str(path) for path in shown]
