"""Routes over many seeds, as whole processes: success, time, length, clearance.

Each route is found by the command line in a process of its own; its folder is checked by
``tests/support/outside.py``, which shares no code with the package, at samples of each leg.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from pathlib import Path
from statistics import median

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from benchmarks._by_case import commanded
from support import outside

CASE = "scenario-b-tight"
OTHERS = (
    "scenario-a", "scenario-b", "offset-mass-wrench", "spinning-structure", "two-vehicles-swap",
    "piano-mover", "parking-backwards", "point-mass-2d", "point-mass-3d",
)  # fmt: skip
# What the checker from outside knows: one vehicle in space among boxes and cylinders at rest.
SEEN_FROM_OUTSIDE = (CASE, "scenario-a", "scenario-b")
SAMPLES_A_LEG = 41


def run(name: str, seed: int) -> dict:
    """Find one route and look at what came out."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "route"
        code, seconds = commanded(["route", name, "--seed", str(seed)], folder)
        row = {"case": name, "seed": seed, "exit": code, "seconds": round(seconds, 2)}
        if code == 0:
            document = json.loads((folder / "route.json").read_text())
            (own,) = document["routes"]
            row |= {
                "search_seconds": round(document["wall_time_s"], 2),
                "legs": len(own["legs"]),
                "length_m": own["length_m"],
                "bound_m": own["clearance_lower_bound_m"],
            }
            if name in SEEN_FROM_OUTSIDE:
                row["outside_m"] = outside.least_distance(folder, SAMPLES_A_LEG)
        return row


def table(rows: list[dict]) -> str:
    """A line a case: counts, medians and worst values."""
    lines = [
        "| case | certified | median s | worst s | worst search s | legs, median and most "
        "| length m, least to most | bound ≥ m | outside ≥ m |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for name in dict.fromkeys(row["case"] for row in rows):
        mine = [row for row in rows if row["case"] == name]
        good = [row for row in mine if row["exit"] == 0]
        if not good:
            lines.append(f"| {name} | 0 of {len(mine)} | | | | | | | |")
            continue
        seconds, lengths = [r["seconds"] for r in mine], [r["length_m"] for r in good]
        legs, seen = [r["legs"] for r in good], [r["outside_m"] for r in good if "outside_m" in r]
        lines.append(
            f"| {name} | {len(good)} of {len(mine)} | {median(seconds):.2f} | {max(seconds):.2f} "
            f"| {max(r['search_seconds'] for r in good):.2f} | {median(legs):.0f}, {max(legs)} "
            f"| {min(lengths):.2f} to {max(lengths):.2f} | {min(r['bound_m'] for r in good):.5f} "
            f"| {f'{min(seen):.5f}' if seen else ''} |"
        )
    return "\n".join(lines)


def main(arguments: list[str]) -> int:
    """Run, print the table, write the rows."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks routes")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--seeds", type=int, default=50, help=f"of {CASE}")
    parser.add_argument("--others", type=int, default=3, help="seeds of the other cases")
    options = parser.parse_args(arguments)
    wanted = [(CASE, seed) for seed in range(options.seeds)]
    wanted += [(name, seed) for name in OTHERS for seed in range(options.others)]
    rows = []
    for name, seed in wanted:
        rows.append(run(name, seed))
        print(rows[-1], flush=True)
    print(table(rows))
    if options.json:
        options.json.write_text(json.dumps(rows, indent=1))
    return 0
