"""The plan folder: everything about one answer, so that it stands alone."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

from berthing.errors import InputError
from berthing.report.figures import draw_figures
from berthing.report.fresh_folder import FAILURE_JSON, FIGURES, REPORT_HTML, fresh_folder
from berthing.report.offline.content import Content
from berthing.report.offline.page import page
from berthing.report.offline.shown import Shown
from berthing.report.plan_json import failure_document, optimality_document, plan_document, to_text
from berthing.result import Result
from berthing.scenario.normal import document_sha256
from berthing.scenario.options import SolverOptions
from berthing.scenario.scenario import Scenario
from berthing.trajectory import Plan
from berthing.trajectory_io import write_interpolant, write_nodes, write_trajectory
from berthing.verify.claims import claims_of, write_claims
from berthing.verify.folder import (
    CERTIFICATE_JSON,
    INTERPOLANT_JSON,
    NODES_CSV,
    PLAN_JSON,
    TRAJECTORY_CSV,
)
from berthing.verify.verification import Verification


def write_result(
    scenario: Scenario, result: Result, options: SolverOptions, target: Path, *, force: bool = False
) -> dict[str, Any]:
    """Write the folder of a plan, or of a failure, whole or not at all; return its JSON.

    Args:
        scenario: what was asked.
        result: the answer.
        options: those that were in force.
        target: the folder.
        force: replace an older plan folder.

    Raises:
        InputError: the folder may not or cannot be written.
    """
    try:
        with fresh_folder(target, force=force) as folder:
            if result.plan is None or result.verification is None:
                document = failure_document(scenario, result, options)
                _write(folder / FAILURE_JSON, to_text(document))
            else:
                document = _write_plan(folder, scenario, result, result.plan, result.verification)
    except OSError as error:
        where = str(error.filename or target)
        raise InputError(where, f"cannot be written: {error.strerror or error}") from None
    return document


def _write_plan(
    folder: Path, scenario: Scenario, result: Result, plan: Plan, verification: Verification
) -> dict[str, Any]:
    start = time.perf_counter()
    fingerprint = document_sha256(scenario.document)
    write_interpolant(folder / INTERPOLANT_JSON, plan.phases, fingerprint)
    write_trajectory(folder / TRAJECTORY_CSV, scenario, plan.phases)
    write_nodes(folder / NODES_CSV, scenario, plan.nodes, plan.separations)
    claims = claims_of(verification.certificates, fingerprint)
    write_claims(folder / CERTIFICATE_JSON, claims)
    figures = folder / FIGURES
    figures.mkdir()
    draw_figures(scenario, plan, verification, figures)
    content = Content()
    content.add(scenario.name, scenario, plan, verification, claims)
    document = plan_document(scenario, plan, verification, result.outcome, result.attempts)
    document["optimality"] = optimality_document(result)
    # The page shows the times that plan.json has, so its own text, quickly made, is not in them.
    seconds = time.perf_counter() - start
    stages = document["wall_time_s"]
    total = stages.pop("total", 0.0) + seconds
    document["wall_time_s"] = {**stages, "report": seconds, "total": total}
    shown = Shown(scenario.name, scenario, plan, verification, claims, document)
    _write(folder / REPORT_HTML, page([shown], content))
    _write(folder / PLAN_JSON, to_text(document))
    return document


def _write(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8")
