"""Planning time and memory against the number of parts, of which always the same twelve are near.

Each plan is made in a process of its own, all in one run, the sizes taken in turn.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import time
from pathlib import Path
from statistics import median

import numpy as np

from benchmarks._by_case import write

NEAR, SIZES = 12, (12, 100, 300, 1000)
GOAL_M = np.array([10.0, 3.0, 0.0])
NEAR_M, CLEAR_ENDS_M, FAR_M, FIELD_M = (2.9, 4.0), 3.2, 12.0, 40.0
"""Twelve cubes of 1 m lie this far from the straight line and no nearer to its ends; the others
at least so far from it, in a box of this half-size."""


def field(total: int, seed: int = 0) -> dict:
    """The scenario of Scenario A's spacecraft among ``total`` cubes turned at random."""
    rng = np.random.default_rng(seed)
    places: list[np.ndarray] = []
    while len(places) < NEAR:
        side = rng.normal(size=3)
        at = rng.random() * GOAL_M + rng.uniform(*NEAR_M) * side / np.linalg.norm(side)
        if min(np.linalg.norm(at), np.linalg.norm(at - GOAL_M)) >= CLEAR_ENDS_M:
            places.append(at)
    while len(places) < total:
        at = 0.5 * GOAL_M + rng.uniform(-FIELD_M, FIELD_M, 3)
        share = np.clip(at @ GOAL_M / (GOAL_M @ GOAL_M), 0.0, 1.0)
        if np.linalg.norm(at - share * GOAL_M) >= FAR_M:
            places.append(at)
    turns = np.random.default_rng(seed + 1).normal(size=(total, 4))
    turns /= np.linalg.norm(turns, axis=1, keepdims=True)
    cube = {"type": "box", "size_m": [1, 1, 1]}
    return {
        "schema_version": 1,
        "name": f"field-of-{total}",
        "horizon": {"duration_s": 150},
        "margins": {"default_m": 0.1},
        "vehicles": [
            {
                "name": "spacecraft",
                "parts": [{"name": "hull", "shape": {"type": "box", "size_m": [4, 2, 2]}}],
                "dynamics": {"model": "rigid-body", "mass_kg": 3, "inertia_kg_m2": [5, 5, 5]},
                "limits": {"max_force_n": 0.02, "max_torque_nm": 0.01},
                "start": {"position_m": [0, 0, 0]},
                "goal": {"position_m": GOAL_M.tolist()},
            }
        ],
        "structures": [
            {
                "name": "field",
                "parts": [
                    {
                        "name": f"cube-{i}", "shape": cube, "position_m": at.tolist(),
                        "attitude": turn.tolist(),
                    }
                    for i, (at, turn) in enumerate(zip(places, turns, strict=True))
                ],
            }
        ],
    }  # fmt: skip


def here(total: int) -> dict:
    """One plan in this process, after another that loads what is loaded when first used."""
    import berthing as bt
    from berthing.scenario.files import from_document

    bt.plan(bt.load("free-space"))
    scenario = from_document(field(total), "field")
    began = time.perf_counter()
    result = bt.plan(scenario)
    seconds = time.perf_counter() - began
    return {
        "parts": total, "outcome": result.outcome, "seconds": round(seconds, 3),
        "cost": result.plan.cost if result.plan else None,
        "memory_mib": round(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024),
    }  # fmt: skip


def apart(total: int) -> dict:
    """The same in a process of its own."""
    code = f"import json; from benchmarks.scale import here; print(json.dumps(here({total})))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return dict(json.loads(done.stdout.splitlines()[-1]))


def table(rows: list[dict]) -> str:
    """A line a size."""
    lines = [
        "| parts | certified | s, median | s, worst | of the time of 12 | cost | memory, MiB |",
        "|---|---|---|---|---|---|---|",
    ]
    alone = median(row["seconds"] for row in rows if row["parts"] == NEAR)
    for total in dict.fromkeys(row["parts"] for row in rows):
        mine = [row for row in rows if row["parts"] == total]
        seconds = [row["seconds"] for row in mine]
        good = sum(row["outcome"] == "certified" for row in mine)
        costs = ", ".join(sorted({f"{row['cost']:.7f}" for row in mine if row["cost"]}))
        lines.append(
            f"| {total} | {good} of {len(mine)} | {median(seconds):.2f} | {max(seconds):.2f} "
            f"| {median(seconds) / alone:.2f} | {costs} | {max(r['memory_mib'] for r in mine)} |"
        )
    return "\n".join(lines)


def main(arguments: list[str]) -> int:
    """Run, print the table, write the rows."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks scale")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--times", type=int, default=3)
    options = parser.parse_args(arguments)
    rows = []
    for _ in range(options.times):
        for total in SIZES:
            rows.append(apart(total))
            print(rows[-1], flush=True)
    print(table(rows))
    write(options.json, rows)
    return 0
