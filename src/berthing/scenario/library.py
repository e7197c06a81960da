"""The cases that ship."""

from __future__ import annotations

from pathlib import Path

from berthing.scenario.reading import read

CASES = Path(__file__).parent / "cases"


def library() -> dict[str, str]:
    """Names of the cases and their descriptions of one line, sorted by name."""
    return {path.stem: _headline(path) for path in sorted(_cases(), key=lambda p: p.stem)}


def case_path(name: str) -> Path | None:
    """The file of the case called ``name``; None where there is none."""
    return next((path for path in _cases() if path.stem == name), None)


def _cases() -> list[Path]:
    return list(CASES.glob("*.yaml"))


def _headline(path: Path) -> str:
    description = str(read(path).raw["description"])
    return description.strip().splitlines()[0]
