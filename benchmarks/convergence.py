"""Cost, defects and lower Hamiltonian by scheme and nodes: on a smooth case, and on Scenario A.

The smooth case is ``tests/support/smooth.py``: nothing in the way, no limits. Scenario A's answer
touches its obstacles, so that its costates jump there.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import asdict, replace
from pathlib import Path

from benchmarks._by_case import write
from berthing.planner import plan
from berthing.scenario.files import load

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from support.smooth import EXACT, found

MESHES = (
    [("lgr", 1, d) for d in (5, 10, 15, 20)]
    + [("lgl-global", 1, d) for d in (4, 9, 14, 19)]
    + [("lgr", n, 4) for n in (2, 4, 8, 16)]
    + [("lgl", n, 4) for n in (2, 4, 8, 16)]
)
"""Scheme, segments, degree."""

TOUCHING = (("lgr", None), ("lgl", None), ("lgl-global", 20))
"""Scheme and nodes for Scenario A; None is what the planner takes."""

TIME_LIMIT_S = 120.0


def smooth() -> list[dict]:
    """A row a mesh, with the error of its cost."""
    exact = found(*EXACT).cost
    rows = []
    for mesh in MESHES:
        here = found(*mesh)
        rows.append(asdict(here) | {"case": "smooth", "cost_error": abs(here.cost / exact - 1.0)})
        print(rows[-1], flush=True)
    return rows


def touching() -> list[dict]:
    """A row a scheme: what the planner ends with on Scenario A."""
    scenario, rows = load("scenario-a"), []
    for scheme, nodes in TOUCHING:
        options = replace(scenario.solver, scheme=scheme, nodes=nodes, time_limit_s=TIME_LIMIT_S)
        result = plan(scenario, options=options)
        row = {"case": "scenario-a", "scheme": scheme, "outcome": result.outcome}
        if result.plan is not None and result.verification is not None:
            row |= {
                "nodes": len(result.plan.nodes[0].times_s),
                "cost": result.plan.cost,
                "drift": result.verification.hamiltonian_relative_drift,
                "reasons": list(result.verification.reasons),
            }
        rows.append(row)
        print(row, flush=True)
    return rows


def table(rows: list[dict]) -> str:
    """Both cases as Markdown."""
    lines = [
        "| scheme | segments × degree | nodes | error of the cost | defect between nodes "
        "| drift of the Hamiltonian |",
        "|---|---|---|---|---|---|",
    ]
    lines += [
        f"| {r['scheme']} | {r['segments']} × {r['degree']} | {r['nodes']} "
        f"| {r['cost_error']:.0e} | {r['defect']:.0e} | {r['drift']:.0e} |"
        for r in rows
        if r["case"] == "smooth"
    ]
    lines += ["", "| scheme | state points | outcome | cost | drift of the Hamiltonian |"]
    lines += ["|---|---|---|---|---|"]
    lines += [
        f"| {r['scheme']} | {r['nodes']} | {r['outcome']} | {r['cost']:.6f} | {r['drift']:.2f} |"
        if "cost" in r
        else f"| {r['scheme']} | | {r['outcome']} | | |"
        for r in rows
        if r["case"] == "scenario-a"
    ]
    return "\n".join(lines)


def main(arguments: list[str]) -> int:
    """Run, print the tables, write the rows."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks convergence")
    parser.add_argument("--json", type=Path)
    options = parser.parse_args(arguments)
    rows = smooth() + touching()
    print(table(rows))
    write(options.json, rows)
    return 0
