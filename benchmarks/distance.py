"""``python -m benchmarks distance [--json FILE] [--only brackets|answers|speed] [--poses N]``.

Distances of all pairs of sets: proven brackets, independent answers, gradients, and time a pose
along the public pose law beside a bare loop over the collision library. The processor's time, so
that other work on the machine counts little; about ten minutes in full.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

from benchmarks._distance_checks import (
    against_conic,
    against_hulls,
    against_nlp,
    brackets,
    gradients,
)
from benchmarks._distance_speed import speed


def main(arguments: list[str]) -> int:
    """Measure, print, and write JSON, keeping the parts of the file that were not measured."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks distance")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--only", choices=("brackets", "answers", "speed"))
    parser.add_argument("--poses", type=int, default=1_000_000)
    parser.add_argument("--repeats", type=int, default=3)
    given = parser.parse_args(arguments)
    kept = json.loads(given.json.read_text()) if given.json and given.json.exists() else {}
    found: dict[str, Any] = dict(kept)
    if given.only in (None, "brackets"):
        found["brackets"] = brackets(given.poses)
    if given.only in (None, "answers"):
        found["against a conic solver (Clarabel)"] = against_conic(given.poses // 100)
        found["against an NLP solver (SLSQP)"] = against_nlp(given.poses // 1000)
        found["depths against hulls (Qhull)"] = against_hulls(given.poses // 1000)
        found["gradients against differences"] = gradients(given.poses // 100)
    if given.only in (None, "speed"):
        found["speed"] = speed(max(given.poses // 10, 100), given.repeats)
    print(json.dumps(found, indent=1, ensure_ascii=False))
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
        "µs a pose on one core, gradients included; the pose law in order.",
        "",
    ]
    lines += ["| pair | ours | coal, bare loop | ratio | overlapping |", "|---|---|---|---|---|"]
    for name, row in found["speed"].items():
        coal, ratio = (f"{row[k]:.2f}" if k in row else "" for k in ("coal_us", "ratio"))
        share = f"{100.0 * row['overlapping_share']:.0f}%"
        lines.append(f"| {name} | {row['ours_us']:.2f} | {coal} | {ratio} | {share} |")
    return "\n".join(lines) + "\n"


def _shown(value: object) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)
