"""The parts of the page that are text: verdict, reasons, pairs, stages, attempts, versions."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

from berthing.report.offline.shown import Shown
from berthing.report.verdict_table import Row
from berthing.result import CERTIFIED, UNDECIDED
from berthing.verify.verdict import PairVerdict

# What the banner says of a plan, whether scripts run or not.
BANNERS: Mapping[str, str] = {UNDECIDED: "Not certified: undecided"}
NOT_CERTIFIED = "Not certified"
# Reasons listed before the rest is counted only.
MOST_REASONS = 12
ATTEMPT_COLUMNS: Mapping[str, str] = {
    "guess": "Guess",
    "outcome": "Outcome",
    "nodes": "Nodes",
    "iterations": "Iterations",
    "wall_time_s": "Time [s]",
    "cost": "Cost",
    "clearance_m": "Clearance [m]",
    "note": "Note",
}
NUMERIC = frozenset({"nodes", "iterations", "wall_time_s", "cost", "clearance_m"})


def badges(plans: Sequence[Shown]) -> str:
    """The verdict in a word, for each plan."""
    return " ".join(_badge(shown, plans) for shown in plans)


def _badge(shown: Shown, plans: Sequence[Shown]) -> str:
    row = shown.rows[0]
    who = f"{escape(shown.label)}: " if len(plans) > 1 else ""
    return f'<span class="badge {_mark(row.good)}">{who}{escape(row.value)}</span>'


def verdict_table(plans: Sequence[Shown]) -> str:
    """A row for each check, a column for each plan.

    Each cell's ``data-fields`` has the values of plan.json that its text is made of, as JSON.
    """
    head = _head(["", *(_plan_name(i, s) for i, s in enumerate(plans))]) if len(plans) > 1 else ""
    body = []
    for rows in zip(*(shown.rows for shown in plans), strict=True):
        cells = "".join(_cell(row, shown) for row, shown in zip(rows, plans, strict=True))
        body.append(f'<tr><th scope="row">{escape(rows[0].label)}</th>{cells}</tr>')
    return f'<table class="verdict">{head}<tbody>\n' + "\n".join(body) + "\n</tbody></table>"


def _cell(row: Row, shown: Shown) -> str:
    found = json.dumps({key: _looked_up(shown.document, key) for key in row.keys})
    said = f' data-fields="{escape(found)}"' if row.keys else ""
    return f'<td class="{_mark(row.good)}"{said}>{escape(row.value)}</td>'


def _looked_up(document: Mapping[str, Any], key: str) -> Any:
    value: Any = document
    for name in key.split("."):
        value = value.get(name) if isinstance(value, Mapping) else None
    return None if isinstance(value, float) and not math.isfinite(value) else value


def banner(plans: Sequence[Shown]) -> str:
    """Why plans are not certified; empty where all are."""
    return "\n".join(_reasons(shown, plans) for shown in plans if shown.outcome != CERTIFIED)


def _reasons(shown: Shown, plans: Sequence[Shown]) -> str:
    reasons = shown.verification.reasons
    items = [f"<li>{escape(reason)}</li>" for reason in reasons[:MOST_REASONS]]
    if len(reasons) > MOST_REASONS:
        items.append(f"<li>and {len(reasons) - MOST_REASONS} more, in plan.json</li>")
    who = f"{escape(shown.label)}: " if len(plans) > 1 else ""
    return (
        f'<div class="banner"><strong>{who}{BANNERS.get(shown.outcome, NOT_CERTIFIED)}.</strong>'
        f"<ul>{''.join(items)}</ul></div>"
    )


def pairs_table(plans: Sequence[Shown]) -> str:
    """What is proven of every pair; a button in each row goes to the time that matters most."""
    rows = [
        _pair_row(i, shown, pair, plans)
        for i, shown in enumerate(plans)
        for pair in shown.verification.pairs
    ]
    if not rows:
        return "<p>Nothing to keep clear of.</p>"
    several = ["Plan"] if len(plans) > 1 else []
    head = _head([*several, "Pair", "Verdict", "Proven [m]", "Required [m]", "At [s]"])
    return f"<table>{head}<tbody>\n" + "\n".join(rows) + "\n</tbody></table>"


def _pair_row(index: int, shown: Shown, pair: PairVerdict, plans: Sequence[Shown]) -> str:
    good = None if pair.required_m is None else pair.verdict == CERTIFIED
    several = f"<td>{_plan_name(index, shown)}</td>" if len(plans) > 1 else ""
    at = "" if pair.required_m is None else _seek(pair.time_s)
    return (
        f'<tr>{several}<th scope="row">{escape(pair.pair.replace("|", " – "))}</th>'
        f'<td class="{_mark(good)}">{escape(pair.verdict)}</td>'
        f'<td class="number">{_down(pair.lower_bound_m)}</td>'
        f'<td class="number">{_plain(pair.required_m)}</td><td class="number">{at}</td></tr>'
    )


def _seek(time_s: float) -> str:
    return f'<button type="button" class="seek" data-seek="{time_s!r}">{time_s:.2f}</button>'


def stages_table(plans: Sequence[Shown]) -> str:
    """Seconds spent in each stage, with a bar; the bars of all plans have one scale."""
    longest = max((s for p in plans for s in p.stages_s.values()), default=0.0) or 1.0
    tables = []
    for index, shown in enumerate(plans):
        caption = f"<caption>{_plan_name(index, shown)}</caption>" if len(plans) > 1 else ""
        rows = [
            f'<tr><th scope="row">{escape(name)}</th><td class="number">{seconds:.2f} s</td>'
            f'<td class="bar" aria-hidden="true"><div style="width:{100 * seconds / longest:.1f}%">'
            "</div></td></tr>"
            for name, seconds in shown.stages_s.items()
        ]
        tables.append(f'<table class="stages">{caption}<tbody>{"".join(rows)}</tbody></table>')
    return "\n".join(tables)


def attempts_table(plans: Sequence[Shown]) -> str:
    """What the planner tried, in its order; empty where nothing was recorded."""
    tables = []
    for index, shown in enumerate(plans):
        attempts = shown.document.get("attempts") or []
        if attempts:
            caption = f"<caption>{_plan_name(index, shown)}</caption>" if len(plans) > 1 else ""
            rows = "\n".join(_attempt_row(attempt) for attempt in attempts)
            head = _head(list(ATTEMPT_COLUMNS.values()))
            tables.append(f"<table>{caption}{head}<tbody>\n{rows}\n</tbody></table>")
    return "\n".join(tables)


def _attempt_row(attempt: Mapping[str, Any]) -> str:
    cells = "".join(
        f'<td class="{"number" if key in NUMERIC else ""}">{_attempt_cell(attempt.get(key))}</td>'
        for key in ATTEMPT_COLUMNS
    )
    return f"<tr>{cells}</tr>"


def _attempt_cell(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.4g}" if math.isfinite(value) else "–"
    return escape(str("" if value is None else value).replace("_", " "))


def versions_text(plans: Sequence[Shown]) -> str:
    """Of everything that computed, once for each different set."""
    found = [shown.document.get("versions") for shown in plans]
    lines = [
        ", ".join(f"{escape(str(k))} {escape(str(v))}" for k, v in versions.items())
        for versions in found
        if isinstance(versions, Mapping)
    ]
    return "; ".join(dict.fromkeys(lines))


def _plan_name(index: int, shown: Shown) -> str:
    return f'<span class="plan" data-plan="{index}">{escape(shown.label)}</span>'


def _head(columns: Sequence[str]) -> str:
    return "<thead><tr>" + "".join(f'<th scope="col">{c}</th>' for c in columns) + "</tr></thead>"


def _mark(good: bool | None) -> str:
    return {None: "", True: "good", False: "bad"}[good]


def _plain(value: float | None) -> str:
    return "–" if value is None else f"{value:g}"


def _down(value: float) -> str:
    """Rounded down, since it is a bound."""
    return f"{math.floor(value * 1e5) / 1e5:.5f}" if math.isfinite(value) else "–"
