"""Scenario A from no guess, verification included; and ``kkt-complementarity`` from the same guess.

Times are of ``berthing.plan`` in one process after the imports, and of whole processes with figures
and page. The paper's form is solved by IPOPT on the planner's coarse mesh from the planner's first
guess, to its last relaxation, without refinement or verification, which only favours it.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from pathlib import Path
from statistics import median

import berthing as bt
from benchmarks._by_case import commanded, write
from benchmarks._coarse import coarse_problem
from berthing.guess.candidates import candidates
from berthing.guess.normals import exact_normals
from berthing.guess.path import motion_along
from berthing.refine.refiner import BACKOFF_M
from berthing.solve.homotopy import solve_by_stages
from berthing.solve.ipopt import Budget, Start

CASE = "scenario-a"
REFERENCE_BUDGET = Budget(1500, 60.0)


def inside(seed: int) -> dict:
    """One plan in this process."""
    scenario = bt.load(CASE)
    began = time.perf_counter()
    result = bt.plan(scenario, options=bt.SolverOptions(seed=seed))
    seconds = time.perf_counter() - began
    cost = result.plan.cost if result.plan else None
    stages = dict(result.plan.wall_time_s) if result.plan else {}
    return {"kind": "in process", "seed": seed, "outcome": result.outcome,
            "seconds": round(seconds, 3), "cost": cost,
            "stages": {k: round(v, 3) for k, v in stages.items()}}  # fmt: skip


def whole(seed: int) -> dict:
    """One plan as a process of its own."""
    with tempfile.TemporaryDirectory() as scratch:
        code, seconds = commanded(["plan", CASE, "--seed", str(seed)], Path(scratch, "plan"))
    return {"kind": "whole process", "seed": seed, "exit": code,
            "seconds": round(seconds, 3)}  # fmt: skip


def reference() -> dict:
    """``kkt-complementarity`` from the first guess, nodes only."""
    scenario = bt.load(CASE)
    began = time.perf_counter()
    problem = coarse_problem(scenario, "kkt-complementarity")
    phase = problem.phase
    guess = candidates(scenario, phase, 0)[0]
    motion = motion_along(guess, phase, problem.mesh, phase.horizon.nominal_s)
    start = Start(motion, exact_normals(problem.pairs))
    outcome = solve_by_stages(
        problem, scenario, start, preset="cold", budget=REFERENCE_BUDGET, backoff_m=BACKOFF_M
    )
    return {"kind": "kkt-complementarity", "guess": guess.name, "outcome": outcome.status,
            "iterations": outcome.iterations, "cost": outcome.cost,
            "seconds": round(time.perf_counter() - began, 3)}  # fmt: skip


def table(rows: list[dict]) -> str:
    """A line a kind."""
    lines = ["| what | good | median s | worst s | cost |", "|---|---|---|---|---|"]
    for kind in dict.fromkeys(row["kind"] for row in rows):
        mine = [row for row in rows if row["kind"] == kind]
        seconds = [row["seconds"] for row in mine]
        good = sum(
            row.get("outcome") in ("certified", "solved") or row.get("exit") == 0 for row in mine
        )
        costs = sorted({f"{row['cost']:.7f}" for row in mine if row.get("cost")})
        lines.append(
            f"| {kind} | {good} of {len(mine)} | {median(seconds):.2f} | {max(seconds):.2f} "
            f"| {', '.join(costs)} |"
        )
    return "\n".join(lines)


def main(arguments: list[str]) -> int:
    """Run, print the table, write the rows."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks cold")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--processes", type=int, default=5, help="whole processes")
    options = parser.parse_args(arguments)
    inside(0)  # What is loaded when first used counts as import.
    rows = [inside(seed) for seed in range(options.seeds)]
    rows += [whole(seed) for seed in range(options.processes)]
    rows.append(reference())
    print(table(rows))
    write(options.json, rows)
    return 0
