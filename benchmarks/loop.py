"""The loop of ``examples/14_plan_again_while_flying.py`` over many noise seeds."""

from __future__ import annotations

import argparse
import runpy
import time
from pathlib import Path
from statistics import median

from benchmarks._by_case import write

EXAMPLE = Path(__file__).parents[1] / "examples" / "14_plan_again_while_flying.py"


def main(arguments: list[str]) -> int:
    """Fly every seed; print a summary and write the rows."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks loop")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--seeds", type=int, default=100)
    options = parser.parse_args(arguments)
    example = runpy.run_path(str(EXAMPLE))
    rows = []
    for seed in range(options.seeds):
        began = time.perf_counter()
        least_m, off_m, fresh = example["fly"](seed)
        rows.append(
            {
                "seed": seed, "least_clearance_m": round(least_m, 5),
                "off_goal_m": round(off_m, 5), "new_plans": fresh,
                "seconds": round(time.perf_counter() - began, 2),
            }
        )  # fmt: skip
        print(rows[-1], flush=True)
    kept = sum(row["least_clearance_m"] >= example["KEEP_M"] for row in rows)
    print("| margin kept | least clearance | off the goal, worst | new plans, median | fewest |")
    print("|---|---|---|---|---|")
    new = [row["new_plans"] for row in rows]
    print(
        f"| {kept} of {len(rows)} | {min(r['least_clearance_m'] for r in rows):.4f} m "
        f"| {max(r['off_goal_m'] for r in rows):.4f} m | {median(new):g} | {min(new)} |"
    )
    write(options.json, rows)
    return 0 if kept == len(rows) else 1
