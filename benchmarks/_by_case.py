"""What benchmarks over cases share: options, rows that are printed and kept, timed commands."""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

Rows = Callable[[str, int], Iterable[Iterable[dict]]]


def commanded(words: Sequence[str], folder: Path) -> tuple[int, float]:
    """Exit code and seconds of ``berthing WORDS --out FOLDER`` as a process of its own."""
    command = [sys.executable, "-m", "berthing", *words, "--out", str(folder)]
    began = time.perf_counter()
    done = subprocess.run(command, capture_output=True, check=False)
    return done.returncode, time.perf_counter() - began


def write(path: Path | None, rows: object) -> None:
    """Keep what was measured, where there is a file to keep it in."""
    if path:
        path.write_text(json.dumps(rows, indent=1) + "\n")


def write_lines(path: Path, rows: Sequence[dict]) -> None:
    """Likewise, a line a row."""
    path.write_text("[\n" + ",\n".join(map(json.dumps, rows)) + "\n]\n")


def run(
    name: str, cases: Sequence[str], rows_of: Rows, table: Callable[[list[dict]], str],
    arguments: list[str],
) -> int:  # fmt: skip
    """Take ``rows_of(case, seeds)`` group by group, print the table, write the rows."""
    parser = argparse.ArgumentParser(prog=f"python -m benchmarks {name}")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--case", action="append", choices=cases)
    options = parser.parse_args(arguments)
    rows: list[dict] = []
    for case in options.case or cases:
        for group in rows_of(case, options.seeds):
            rows += group
            print(rows[-1], flush=True)
    print(table(rows))
    write(options.json, rows)
    return 0
