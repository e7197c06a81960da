"""What the certificate says of random passes whose truth is known, and how long it takes.

Each pass is asked for with a margin that it violates, or keeps, by a known amount. No pass that
violates its margin may be certified; those that are clear by 1e-4 m or more should be.
"""

from __future__ import annotations

import argparse
import json
import time
from collections import Counter
from pathlib import Path
from statistics import median

import numpy as np

from benchmarks._passes import DURATION_S, Pass, random_pass
from benchmarks._timed_cases import timed_cases
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.verify.certificate import certify
from support import hand_made

# Distance that every pass keeps, so that every margin asked for is positive.
NEAREST_M = 0.02
# Of the passes: those that violate by 1e-6 m to 1e-2 m, a fifth of them by 1e-6 m exactly; clear
# by 1e-4 m to 1e-2 m, a fifth by 1e-4 m exactly; and clear by 1e-6 m to 1e-4 m.
SHARES = {"violating": 0.5, "clear": 0.4, "barely clear": 0.1}
RANGES_M = {"violating": (1e-6, 1e-2), "clear": (1e-4, 1e-2), "barely clear": (1e-6, 1e-4)}
EXACT_SHARE = 0.2
REPEATS = 9
COLUMNS = ("seed", "kind", "two_vehicles", "by_m", "least_m", "verdict", "intervals", "seconds")


def amount(kind: str, rng: np.random.Generator) -> float:
    """How far the margin is from the least distance (m), logarithmically even."""
    low, high = RANGES_M[kind]
    if kind != "barely clear" and rng.random() < EXACT_SHARE:
        return low
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def scenario_of(case: Pass, margin_m: float) -> Scenario:
    owners = (case.craft.owner, case.other.owner)
    structures = [o for o in owners if isinstance(o, Structure)]
    vehicles = [o for o in owners if not isinstance(o, Structure)]
    return hand_made.scenario(vehicles, structures, margin_m, DURATION_S)


def judged(seed: int, kind: str) -> dict:
    """One pass: what is true of it, what the certificate says, and by how much."""
    rng = np.random.default_rng([seed, 20])
    case, by = random_pass(rng, NEAREST_M), amount(kind, rng)
    margin = case.least_m + (by if kind == "violating" else -by)
    whole = scenario_of(case, margin)
    began = time.perf_counter()
    found = certify(whole, whole.phases[0], case.trajectory)
    seconds = time.perf_counter() - began
    (verdict,) = found.verdicts
    return {
        "seed": seed,
        "kind": kind,
        "by_m": float(f"{by:.6g}"),
        "least_m": round(case.least_m, 9),
        "two_vehicles": case.other.flown is not None,
        "verdict": verdict.verdict,
        "intervals": len(found.evidence[0].leaves.pair),
        "seconds": round(seconds, 4),
    }


def kinds(count: int) -> list[str]:
    """Of so many passes, in a fixed order."""
    out = [kind for kind, share in SHARES.items() for _ in range(round(share * count))]
    return out[:count]


def passes_table(rows: list[dict]) -> str:
    """A line a kind."""
    lines = ["| passes | count | certified | violated | undecided | median intervals | median ms |"]
    lines.append("|---|---|---|---|---|---|---|")
    for kind, (low, high) in RANGES_M.items():
        mine = [row for row in rows if row["kind"] == kind]
        if not mine:
            continue
        said = Counter(row["verdict"] for row in mine)
        effort = median(row["intervals"] for row in mine), median(row["seconds"] for row in mine)
        lines.append(
            f"| {kind} by {low:.0e} to {high:.0e} m | {len(mine)} | {said['certified']} "
            f"| {said['violated']} | {said['undecided']} "
            f"| {effort[0]:.0f} | {1e3 * effort[1]:.0f} |"
        )
    return "\n".join(lines)


def timings() -> list[dict]:
    """Of the cases whose time is promised: the search, and the check of what it found."""
    out = []
    for case in timed_cases():
        searched, checked = (
            [_seconds(work) for _ in range(REPEATS)] for work in (case.search, case.check)
        )
        out.append(
            {
                "case": case.name,
                "pairs": case.pairs,
                "intervals": case.intervals,
                "verdicts": case.verdicts,
                "promised_ms": case.promised_ms,
                "search_ms": round(1e3 * median(searched), 1),
                "check_ms": round(1e3 * median(checked), 1),
            }
        )
    return out


def _seconds(work) -> float:
    began = time.perf_counter()
    work()
    return time.perf_counter() - began


def timings_table(rows: list[dict]) -> str:
    """A line a case."""
    lines = ["| case | pairs | intervals | verdicts | promised ms | search ms | check ms |"]
    lines.append("|---|---|---|---|---|---|---|")
    lines += ["| " + " | ".join(str(value) for value in row.values()) + " |" for row in rows]
    return "\n".join(lines)


def as_text(rows: list[dict], times: list[dict]) -> str:
    """JSON with a line a pass."""
    lines = ",\n".join(json.dumps([row[key] for key in COLUMNS]) for row in rows)
    head = f'"columns": {json.dumps(COLUMNS)},\n"timings": {json.dumps(times, indent=1)}'
    return f'{{{head},\n"passes": [\n{lines}\n]}}\n'


def read_rows(path: Path | None) -> list[dict]:
    """The passes of an earlier run; none where there was none."""
    if path is None or not path.exists():
        return []
    document = json.loads(path.read_text())
    return [dict(zip(document["columns"], row, strict=True)) for row in document["passes"]]


def main(arguments: list[str]) -> int:
    """Judge the passes, time the cases, print both tables; 1 where a promise is broken."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks certificate")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument(
        "--seconds",
        type=float,
        default=float("inf"),
        help="stop after these; the next run with the same FILE goes on",
    )
    options = parser.parse_args(arguments)
    asked = kinds(options.count)
    rows, times, began = read_rows(options.json), [], time.monotonic()
    while len(rows) < len(asked) and time.monotonic() - began < options.seconds:
        rows.append(judged(len(rows), asked[len(rows)]))
    print(f"{len(rows)} of {len(asked)} passes")
    if len(rows) == len(asked):
        times = timings()
    if options.json:
        options.json.write_text(as_text(rows, times))
    print(passes_table(rows), timings_table(times), sep="\n\n")
    false = [row for row in rows if row["kind"] == "violating" and row["verdict"] == "certified"]
    clear = [row for row in rows if row["kind"] == "clear"]
    open_ = [row for row in clear if row["verdict"] != "certified"]
    print(f"false certificates: {len(false)}; clear and not certified: {len(open_)}")
    return int(bool(false) or len(open_) > 1e-3 * len(clear))
