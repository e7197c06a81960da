"""``python -m benchmarks distance [--json FILE] [--only PART …] [--missing] [--poses N]``.

Distances of all pairs of sets: proven brackets, contacts of all kinds, independent answers,
gradients, and time a pose along the public pose law beside a bare loop over the collision library.
The processor's time, so that other work on the machine counts little; about twenty minutes in full.
The file is written after each part, and ``--missing`` goes on with those that it lacks.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from benchmarks._distance_checks import (
    against_conic,
    against_hulls,
    against_nlp,
    brackets,
    gradients,
)
from benchmarks._distance_contacts import contacts, touching
from benchmarks._distance_speed import speed

# Draws of poses for gradients; of intersections fewer, for they take a hundred times as long.
GRADIENT_DRAWS, CUT_DRAWS = 3, 2

# Each by its name on the command line: its heading, and what measures it, given poses and repeats.
PARTS: dict[str, tuple[str, Callable[[int, int], dict[str, Any]]]] = {
    "brackets": ("brackets", lambda n, _: brackets(n)),
    "contacts": ("contacts known by hand", lambda n, _: contacts()),
    "touching": ("touching, and about one centre", lambda n, _: touching(n // 10)),
    "conic": ("against a conic solver (Clarabel)", lambda n, _: against_conic(n // 100)),
    "nlp": ("against an NLP solver (SLSQP)", lambda n, _: against_nlp(n // 100)),
    "hulls": ("depths against hulls (Qhull)", lambda n, _: against_hulls(n // 1000)),
    "gradients": (
        "gradients against differences",
        lambda n, _: gradients(n // 100, False, GRADIENT_DRAWS),
    ),
    "cut": (
        "gradients against differences, one set an intersection",
        lambda n, _: gradients(n // 1000, True, CUT_DRAWS),
    ),
    "speed": ("speed", lambda n, repeats: speed(max(n // 10, 100), repeats)),
}


def main(arguments: list[str]) -> int:
    """Measure, print, and write JSON, keeping the parts of the file that were not measured."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks distance")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--only", choices=PARTS, nargs="+", default=list(PARTS))
    parser.add_argument("--missing", action="store_true")
    parser.add_argument("--poses", type=int, default=1_000_000)
    parser.add_argument("--repeats", type=int, default=9)
    given = parser.parse_args(arguments)
    kept = json.loads(given.json.read_text()) if given.json and given.json.exists() else {}
    for part in given.only:
        heading, measure = PARTS[part]
        if given.missing and heading in kept:
            continue
        kept[heading] = measure(given.poses, given.repeats)
        print(json.dumps({heading: kept[heading]}, indent=1, ensure_ascii=False), flush=True)
        found = {name: kept[name] for name, _ in PARTS.values() if name in kept}
        if given.json:
            given.json.write_text(json.dumps(found, indent=1, ensure_ascii=False) + "\n")
            given.json.with_suffix(".md").write_text(_table(found))
    return 0


def _table(found: dict[str, Any]) -> str:
    lines = ["# Distances", "", "By `python -m benchmarks distance`.", ""]
    for name, values in found.items():
        if name == "speed":
            continue
        lines += [f"## {name[0].upper()}{name[1:]}", ""]
        lines += [f"- {key.replace('_', ' ')}: {_shown(value)}" for key, value in values.items()]
        lines.append("")
    if "speed" not in found:
        return "\n".join(lines)
    lines += [
        "## Speed",
        "",
        "µs a pose on one core, gradients included; the pose law in order, by stretches of 5,000",
        "poses. The best of several repeats of each, in turns with the loop's; the median in",
        "brackets.",
        "",
    ]
    lines += ["| pair | ours | coal, bare loop | ratio | overlapping |", "|---|---|---|---|---|"]
    for name, row in found["speed"].items():
        ours, coal, ratio = (_best(row, k) for k in ("ours_us", "coal_us", "ratio"))
        share = f"{100.0 * row['overlapping_share']:.0f}%"
        lines.append(f"| {name} | {ours} | {coal} | {ratio} | {share} |")
    return "\n".join(lines) + "\n"


def _best(row: dict[str, float], key: str) -> str:
    """And the median; nothing where it was not measured."""
    return f"{row[key]:.2f} ({row[f'{key}_median']:.2f})" if key in row else ""


def _shown(value: object) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)
