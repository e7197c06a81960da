"""Formulations side by side: ``scenario-b-tight`` and ten cases of each family of ``tight3d``.

Every form begins with the same guesses, those of the planner, on the same mesh with rows at the
nodes only (``berthing compare``). Times are of the solver alone, each within its limit. Rows are
written as they come, and cases that the file has are not compared again.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from statistics import median

from benchmarks._by_case import write_lines
from benchmarks.tight3d._families import FAMILIES, made
from berthing.comparison import METHODS, compare
from berthing.scenario.files import load
from berthing.scenario.scenario import Scenario

SHIPPED = "scenario-b-tight"
LIMITS_S = {SHIPPED: 30.0}
OTHERS_LIMIT_S = 10.0
"""Of one solve."""

GUESSES = {SHIPPED: 6}
OTHERS_GUESSES = 2


def cases(seeds: int) -> Iterator[tuple[str, int]]:
    """All families at each seed, so that a run that is cut short has some of each."""
    yield SHIPPED, 0
    for seed in range(seeds):
        for family in FAMILIES:
            yield family, seed


def scenario_of(case: str, seed: int) -> Scenario:
    """By its name."""
    return load(case) if case == SHIPPED else made(case, seed).scenario()


def rows_of(case: str, seed: int, forms: tuple[str, ...]) -> list[dict]:
    """One a formulation."""
    guesses, limit_s = GUESSES.get(case, OTHERS_GUESSES), LIMITS_S.get(case, OTHERS_LIMIT_S)
    found = compare(scenario_of(case, seed), forms, guesses=guesses, limit_s=limit_s)
    return [
        {"case": case, "seed": seed, "limit_s": limit_s, **asdict(s)} for s in found.summaries()
    ]


def table(rows: list[dict]) -> str:
    """A part a family; a case is found where one guess led to an answer that keeps the margins."""
    lines = []
    for case in dict.fromkeys(row["case"] for row in rows):
        own = [row for row in rows if row["case"] == case]
        least = {
            seed: min((r["cost"] for r in own if r["seed"] == seed and r["cost"]), default=None)
            for seed in {r["seed"] for r in own}
        }
        lines += [
            "", f"## {case}", "",
            f"{len(least)} case{'s' * (len(least) > 1)}, limit {own[0]['limit_s']:.0f} s a solve.",
            "",
            "| formulation | cases answered | guesses answered | cost over the least | "
            "iterations | s | least spare between nodes [m] |",
            "|---|---|---|---|---|---|---|",
            *(_line(form, [r for r in own if r["formulation"] == form], least)
              for form in dict.fromkeys(r["formulation"] for r in own)),
        ]  # fmt: skip
    return "\n".join(lines)


def _line(form: str, rows: list[dict], least: dict[int, float | None]) -> str:
    if all(row["refused"] for row in rows):
        return f"| {form} | cannot take it |" + " – |" * 5
    good = [row for row in rows if row["cost"] is not None]
    guesses = f"{sum(r['solved'] for r in rows)} of {sum(r['trials'] for r in rows)}"
    start = f"| {form} | {len(good)} of {len(rows)} | {guesses} |"
    if not good:
        return start + " – |" * 4
    over = median(row["cost"] / (least[row["seed"]] or 1.0) for row in good)
    return (
        f"{start} {over:.3f} | {median(r['iterations'] for r in good):.0f} | "
        f"{median(r['seconds'] for r in good):.2f} | "
        f"{min(r['spare_between_m'] for r in good):+.3f} |"
    )


def main(arguments: list[str]) -> int:
    """Compare what is missing, print the table, write the rows."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks compare")
    parser.add_argument("--json", type=Path, required=True, help="rows; kept cases are not run")
    parser.add_argument("--seeds", type=int, default=10, help="of each family")
    parser.add_argument("--family", action="append", choices=[SHIPPED, *FAMILIES])
    parser.add_argument("--formulation", action="append", choices=METHODS)
    options = parser.parse_args(arguments)
    rows = json.loads(options.json.read_text()) if options.json.exists() else []
    for case, seed in cases(options.seeds):
        known = any((row["case"], row["seed"]) == (case, seed) for row in rows)
        if known or case not in (options.family or (SHIPPED, *FAMILIES)):
            continue
        rows += rows_of(case, seed, tuple(options.formulation or METHODS))
        for row in rows[-len(options.formulation or METHODS) :]:
            print(row, flush=True)
        write_lines(options.json, rows)
    print(table(rows))
    return 0
