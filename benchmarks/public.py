"""The field's own problems from no guess: parking, a quadcopter's room, a piano around a corner.

Each is planned by the command line in a process of its own, figures and page included.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from pathlib import Path

from benchmarks._by_case import commanded, write

CASES = ("parking-backwards", "parking-parallel", "quadcopter-room", "piano-mover")


def run(name: str) -> dict:
    """Plan one case and read what came out."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "plan"
        code, seconds = commanded(["plan", name], folder)
        row = {"case": name, "exit": code, "seconds": round(seconds, 1)}
        if code == 0:
            document = json.loads((folder / "plan.json").read_text())
            found = document["verification"]
            row |= {
                "cost": document["cost"],
                "duration_s": last_time(folder),
                "bound_m": found["clearance_lower_bound_m"],
                "margin_m": found["required_clearance_m"],
                "stages_s": {k: round(v, 1) for k, v in document["wall_time_s"].items()},
            }
        return row


def last_time(folder: Path) -> float:
    """When the plan ends."""
    return float((folder / "trajectory.csv").read_text().splitlines()[-1].split(",")[0])


def table(rows: list[dict]) -> str:
    """A line a case."""
    lines = [
        "| case | certified | cost | duration s | clearance ≥ | margin | s |",
        "|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        if row["exit"]:
            lines.append(f"| {row['case']} | no, exit {row['exit']} | | | | | {row['seconds']} |")
            continue
        lines.append(
            f"| {row['case']} | yes | {row['cost']:.5g} | {row['duration_s']:.2f} "
            f"| {row['bound_m']:.5f} m | {row['margin_m']} m | {row['seconds']} |"
        )
    return "\n".join(lines)


def main(arguments: list[str]) -> int:
    """Run, print the table, write the rows."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks public")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--case", action="append", choices=CASES)
    options = parser.parse_args(arguments)
    rows = []
    for name in options.case or CASES:
        rows.append(run(name))
        print(rows[-1], flush=True)
        write(options.json, rows)
    print(table(rows))
    return 0
