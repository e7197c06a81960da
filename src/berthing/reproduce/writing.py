"""The folder of a reproduction: figures, the table of claims, and the plans behind them."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from berthing.errors import InputError
from berthing.report.folder import write_result
from berthing.reproduce import closest, motion, plans, sets
from berthing.reproduce.cases import Cases
from berthing.reproduce.figures import Drawn, draw_all
from berthing.reproduce.finding import Finding

CLAIMS_JSON, CLAIMS_MD, FIGURES, PLANS = "claims.json", "claims.md", "figures", "plans"

PAPER = "A Novel Optimization-Based Collision Avoidance For Autonomous On-Orbit Assembly"

KEPT = ("scenario-a", "scenario-a-printed", "scenario-b")
"""Cases whose plan folders are written."""


def check_folder(folder: Path) -> None:
    """InputError unless ``folder`` is empty, or nothing yet."""
    if folder.is_dir() and not any(folder.iterdir()):
        return
    if folder.exists() or folder.is_symlink():
        raise InputError(str(folder), "is there already", "another --out, or an empty folder")


def all_findings(cases: Cases) -> list[Finding]:
    """Every claim, those that need no plan first."""
    return [*sets.findings(), *closest.findings(), *motion.findings(), *plans.findings(cases)]


def write_all(folder: Path, cases: Cases) -> list[Finding]:
    """Fill ``folder``.

    Raises:
        InputError: it is not empty, cannot be written, or a case has no plan.
    """
    check_folder(folder)
    try:
        (folder / FIGURES).mkdir(parents=True)
        drawn = draw_all(cases, folder / FIGURES)
        findings = all_findings(cases)
        _write(folder, findings, drawn)
        for name in KEPT:
            case = cases[name]
            write_result(case.scenario, case.result, case.options, folder / PLANS / name)
    except OSError as error:
        where = str(error.filename or folder)
        raise InputError(where, f"cannot be written: {error.strerror or error}") from None
    return findings


def _write(folder: Path, findings: Sequence[Finding], drawn: Sequence[Drawn]) -> None:
    document = {
        "paper": PAPER,
        "claims": [asdict(f) | {"values": _plain(f.values)} for f in findings],
        "figures": [asdict(d) for d in drawn],
    }
    text = json.dumps(document, indent=1, ensure_ascii=False, allow_nan=False) + "\n"
    (folder / CLAIMS_JSON).write_text(text, encoding="utf-8")
    (folder / CLAIMS_MD).write_text(markdown(findings, drawn), encoding="utf-8")


def _plain(values: Any) -> dict[str, float | None]:
    return {key: float(v) if abs(float(v)) < float("inf") else None for key, v in values.items()}


def markdown(findings: Sequence[Finding], drawn: Sequence[Drawn]) -> str:
    """The table of claims, and the figures."""
    lines = [
        "# What the paper claims, and what was found", "",
        f"Of *{PAPER}*. Every number was computed for this table.", "",
        "| Where | Claim | Found | It |", "|---|---|---|---|",
    ]  # fmt: skip
    lines += [
        f"| {_cell(f.where)} | {_cell(f.claim)} | {_cell(f.found)} | {f.verdict} |"
        for f in findings
    ]
    lines += ["", "# Figures", "", "| Figure | Shows |", "|---|---|"]
    lines += [f"| [{d.label}]({FIGURES}/{d.file}) | {_cell(d.caption)} |" for d in drawn]
    return "\n".join(lines) + "\n"


def _cell(text: str) -> str:
    return text.replace("|", "\\|")
