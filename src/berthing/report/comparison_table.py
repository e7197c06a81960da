"""A comparison of formulations as a table and as JSON."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from berthing.comparison import Comparison, Summary

HEADERS = (
    "formulation", "solved", "least cost", "iterations", "s",
    "spare at nodes [m]", "spare between [m]",
)  # fmt: skip

NOTE = (
    "Rows are at the nodes only. Cost and spare distance (the least distance of the true shapes "
    "less the margin; below zero it is missed) are those of the cheapest answer; iterations and "
    "seconds are medians over what was solved."
)


def table_rows(comparison: Comparison) -> list[tuple[str, ...]]:
    """A line a formulation under ``HEADERS``."""
    return [_row(summary) for summary in comparison.summaries()]


def markdown(comparison: Comparison) -> str:
    """Headed by the case, with every refusal under it."""
    lines = [
        f"# {comparison.scenario}: formulations compared",
        "",
        f"{comparison.nodes} nodes, the same guesses for each, seed {comparison.seed}. {NOTE}",
        "",
        "| " + " | ".join(HEADERS) + " |",
        "|" + "---|" * len(HEADERS),
        *("| " + " | ".join(row) + " |" for row in table_rows(comparison)),
    ]
    for name, why in comparison.refused.items():
        lines += ["", f"`{name}`: {why}"]
    return "\n".join(lines) + "\n"


def document(comparison: Comparison) -> dict[str, Any]:
    """Everything, for machines."""
    return {
        "schema_version": 1,
        "scenario": comparison.scenario,
        "nodes": comparison.nodes,
        "seed": comparison.seed,
        "summaries": [asdict(summary) for summary in comparison.summaries()],
        "trials": [asdict(trial) for trial in comparison.trials],
    }


def _row(s: Summary) -> tuple[str, ...]:
    if s.refused:
        return (s.formulation, "cannot take it", *("–" for _ in HEADERS[2:]))
    return (
        s.formulation, f"{s.solved} of {s.trials}", _number(s.cost, ".5g"),
        _number(s.iterations, ".0f"), _number(s.seconds, ".2f"),
        _number(s.spare_nodes_m, "+.4f"), _number(s.spare_between_m, "+.4f"),
    )  # fmt: skip


def _number(value: float | None, form: str) -> str:
    return "–" if value is None else format(value, form)
