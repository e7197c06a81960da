"""Rows as a table: a line a family, and a line a miss."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from statistics import median

import numpy as np

from berthing.result import CERTIFIED

NEAR_BEST = 1.05
"""Costs up to this, over the best known, count as the best."""

Key = tuple[str, int]


def newest(rows: Iterable[dict], effort: str) -> dict[Key, dict]:
    """The last row of each case at this effort."""
    return {(r["family"], r["seed"]): r for r in rows if r["effort"] == effort}


def best_known(rows: Iterable[dict], witnesses: Iterable[dict]) -> dict[Key, float]:
    """The least cost of a certified motion, at whatever effort; witnesses count."""
    best: dict[Key, float] = {}
    for row in [*witnesses, *rows]:
        key = row["family"], row["seed"]
        if row.get("certified") or row.get("outcome") == CERTIFIED:
            best[key] = min(best.get(key, np.inf), row["cost"])
    return best


def table(rows: list[dict], effort: str, witnesses: Iterable[dict] = ()) -> str:
    """Of the newest row of each case; times include the misses, costs do not."""
    best, mine = best_known(rows, witnesses), newest(rows, effort)
    families = dict.fromkeys(family for family, _ in mine)
    lines = [
        "| family | certified | median s | 95 % s | worst s | processor s, median "
        "| cost / best known, median | within 5 % of it |",
        "|---|---|---|---|---|---|---|---|",
        *(_line(f, {k: r for k, r in mine.items() if k[0] == f}, best) for f in families),
    ]
    if len(families) > 1:
        lines.append(_line("all", mine, best))
    misses = [r for r in mine.values() if r["outcome"] != CERTIFIED]
    if misses:
        lines += ["", "| miss | s | outcome | cause |", "|---|---|---|---|"]
    for r in sorted(misses, key=lambda r: (r["family"], r["seed"])):
        cause = r["cause"].replace("|", "/")
        lines.append(f"| {r['family']} {r['seed']} | {r['seconds']} | {r['outcome']} | {cause} |")
    return "\n".join(lines)


def _line(name: str, rows: Mapping[Key, dict], best: Mapping[Key, float]) -> str:
    good = {key: row for key, row in rows.items() if row["outcome"] == CERTIFIED}
    seconds, cpu = (
        [row[key] for row in rows.values() if row.get(key) is not None] or [np.nan]
        for key in ("seconds", "cpu_s")
    )
    ratios = [row["cost"] / best[key] for key, row in good.items()]
    cost = f"{median(ratios):.3f}" if ratios else "–"
    near = sum(ratio <= NEAR_BEST for ratio in ratios)
    return (
        f"| {name} | {len(good)} of {len(rows)} | {median(seconds):.2f} "
        f"| {np.percentile(seconds, 95):.2f} | {max(seconds):.2f} | {median(cpu):.2f} "
        f"| {cost} | {near} of {len(good)} |"
    )
