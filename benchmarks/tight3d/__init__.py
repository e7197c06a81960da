"""Tight cases in space, seven families by seed, each with a motion that solves it.

``docs/tight3d.md`` describes them, their files and how to score another planner on them.
"""

from __future__ import annotations

import argparse
import json
import time
from itertools import product
from pathlib import Path

from benchmarks._by_case import write_lines
from benchmarks.tight3d._export import export
from benchmarks.tight3d._families import FAMILIES, made
from benchmarks.tight3d._prove import proven
from benchmarks.tight3d._run import EFFORTS, LIMIT_S, planned
from benchmarks.tight3d._table import newest, table

WITNESSES = Path(__file__).parents[1] / "results" / "tight3d-witnesses.json"


def main(arguments: list[str]) -> int:
    """Plan what is missing, print the table, write the rows; or export, or prove the witnesses."""
    options = _parser().parse_args(arguments)
    # All families at each seed: a run that is cut short has some of each.
    seeds = range(options.first, options.first + options.seeds)
    keys = [(family, seed) for seed, family in product(seeds, options.family or FAMILIES)]
    if options.export:
        for family, seed in keys:
            export(made(family, seed), options.export)
        return 0
    if options.json is None:
        print("--json FILE or --export DIR is needed")
        return 2
    rows = json.loads(options.json.read_text()) if options.json.exists() else []
    until = time.monotonic() + options.seconds
    for family, seed in keys:
        if time.monotonic() > until:
            break
        if options.prove:
            if any((row["family"], row["seed"]) == (family, seed) for row in rows):
                continue
            row = proven(made(family, seed))
        else:
            known = newest(rows, options.effort).get((family, seed))
            if known and (known["outcome"] == "certified" or not options.again):
                continue
            row = planned(made(family, seed), options.effort, options.limit)
        rows.append(row)
        print(row, flush=True)
        write_lines(options.json, rows)
    if not options.prove:
        print(table(rows, options.effort, json.loads(WITNESSES.read_text())))
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m benchmarks tight3d")
    parser.add_argument("--json", type=Path, help="rows; those that it has are not run again")
    parser.add_argument("--family", action="append", choices=FAMILIES)
    parser.add_argument("--first", type=int, default=0, help="first seed")
    parser.add_argument("--seeds", type=int, default=100, help="seeds of each family")
    parser.add_argument("--effort", choices=EFFORTS, default="normal")
    parser.add_argument("--limit", type=float, default=LIMIT_S, help="seconds of one plan")
    parser.add_argument("--seconds", type=float, default=float("inf"), help="of all, about")
    parser.add_argument("--again", action="store_true", help="plan misses in FILE once more")
    parser.add_argument("--prove", action="store_true", help="certify the witnesses instead")
    parser.add_argument("--export", type=Path, metavar="DIR", help="write cases and witnesses")
    return parser
