"""The shipped cases over many seeds, as whole processes: success, time, cost, clearance, replay.

Each plan is made by the command line in a process of its own, and its folder is checked by
``tests/support/outside.py``, which shares no code with the package.
"""

from __future__ import annotations

import json
import math
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from statistics import median

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from benchmarks._by_case import commanded, run
from support import outside

CASES = ("scenario-a", "scenario-b", "scenario-b-tight")
SAMPLES = 6001


def planned(name: str, seed: int) -> dict:
    """Plan one case and look at what came out."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "plan"
        code, seconds = commanded(["plan", name, "--seed", str(seed)], folder)
        row = {"case": name, "seed": seed, "exit": code, "seconds": round(seconds, 2)}
        if (folder / "plan.json").exists():
            document = json.loads((folder / "plan.json").read_text())
            found = document["verification"]
            replay, goal = found["replays"][0], found["ends"][-1]
            row |= {
                "cost": document["cost"],
                "bound_m": found["clearance_lower_bound_m"],
                "outside_m": outside.least_distance(folder, SAMPLES),
                "replay_m": replay["end_position_error_m"],
                "replay_deg": math.degrees(replay["end_attitude_error_rad"]),
                "goal_m": goal["position_m"],
                "hamiltonian_drift": found["hamiltonian_relative_drift"],
            }
        return row


def table(rows: list[dict]) -> str:
    """A line a case: counts, medians and worst values."""
    lines = [
        "| case | certified | median s | worst s | cost, least to most | bound ≥ | outside ≥ "
        "| replay ≤ |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for name in dict.fromkeys(row["case"] for row in rows):
        mine = [row for row in rows if row["case"] == name]
        good = [row for row in mine if row["exit"] == 0]
        seconds = [row["seconds"] for row in mine]
        if not good:
            lines.append(f"| {name} | 0 of {len(mine)} | {median(seconds):.1f} | | | | | |")
            continue
        costs = [row["cost"] for row in good]
        lines.append(
            f"| {name} | {len(good)} of {len(mine)} | {median(seconds):.1f} | {max(seconds):.1f} "
            f"| {min(costs):.7f} to {max(costs):.7f} | {min(r['bound_m'] for r in good):.5f} m "
            f"| {min(r['outside_m'] for r in good):.5f} m "
            f"| {max(r['replay_m'] for r in good):.1e} m, "
            f"{max(r['replay_deg'] for r in good):.1e}° |"
        )
    return "\n".join(lines)


def rows_of(name: str, seeds: int) -> Iterator[list[dict]]:
    """Of one case: a plan a seed."""
    return ([planned(name, seed)] for seed in range(seeds))


def main(arguments: list[str]) -> int:
    """Run, print the table, write the rows."""
    return run("seeds", CASES, rows_of, table, arguments)
