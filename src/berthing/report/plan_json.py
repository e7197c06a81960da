"""What plan.json and failure.json say."""

from __future__ import annotations

import dataclasses
import json
import math
import platform
from collections.abc import Mapping, Sequence
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from berthing._version import __version__
from berthing.report.margin_loss import cost_lost
from berthing.result import Attempt, Result
from berthing.scenario.normal import document_sha256
from berthing.scenario.options import SolverOptions
from berthing.scenario.scenario import Scenario
from berthing.trajectory import Plan
from berthing.trajectory_io.separation_costates import KEY, separations_document
from berthing.verify.folder import SCHEMA_VERSION
from berthing.verify.verification import Verification

# Whoever computes: what else runs does not change a plan.
LIBRARIES = ("casadi", "numpy", "scipy", "coal")


def plan_document(
    scenario: Scenario,
    plan: Plan,
    verification: Verification,
    outcome: str,
    attempts: Sequence[Attempt] = (),
) -> dict[str, Any]:
    """The content of plan.json."""
    return {
        "schema_version": SCHEMA_VERSION,
        "name": scenario.name,
        "outcome": outcome,
        "formulation": plan.formulation,
        "scheme": plan.scheme,
        "cost": plan.cost,
        "cost_per_margin": plan.cost_per_margin,
        "cost_lost_to_margins": cost_lost(plan, verification),
        "nodes": plan.node_count,
        "iterations": plan.iterations,
        "seed": plan.seed,
        "wall_time_s": dict(plan.wall_time_s),
        "attempts": [dataclasses.asdict(attempt) for attempt in attempts],
        "verification": verification.to_json(),
        "versions": versions(),
        "scenario_sha256": document_sha256(scenario.document),
        "scenario": dict(scenario.document),
    }


def optimality_document(result: Result) -> dict[str, Any] | None:
    """Residuals, costs on finer meshes and multipliers of separation rows; None where unknown."""
    if result.plan is None or result.extremality is None:
        return None
    return {
        **result.extremality.to_json(),
        "observed_order": None if result.order is None else result.order.order,
        "order_check": None if result.order is None else result.order.to_json(),
        "second_order": None if result.second_order is None else result.second_order.to_json(),
        KEY: separations_document(result.plan.separations),
    }


def failure_document(scenario: Scenario, result: Result, options: SolverOptions) -> dict[str, Any]:
    """The content of failure.json: what was tried, and what to try next."""
    return {
        "schema_version": SCHEMA_VERSION,
        "name": scenario.name,
        "outcome": result.outcome,
        "advice": result.advice,
        "attempts": [dataclasses.asdict(attempt) for attempt in result.attempts],
        "options": dataclasses.asdict(options),
        "versions": versions(),
        "scenario": dict(scenario.document),
    }


def summary(document: Mapping[str, Any], folder: str | None = None) -> dict[str, Any]:
    """plan.json or failure.json without the scenario, and where it was written."""
    short = {key: value for key, value in document.items() if key != "scenario"}
    return short if folder is None else {**short, "folder": folder}


def to_text(document: Mapping[str, Any]) -> str:
    """JSON with what is not finite as null, since JSON has no infinities."""
    return json.dumps(_finite(document), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def versions() -> dict[str, str]:
    """Of berthing, Python and the libraries that compute."""
    return {
        "berthing": __version__,
        "python": platform.python_version(),
        **{name: _version(name) for name in LIBRARIES},
    }


def _version(library: str) -> str:
    try:
        return version(library)
    except PackageNotFoundError:
        return "absent"


def _finite(value: Any) -> Any:
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, Mapping):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [_finite(item) for item in value]
    return value
