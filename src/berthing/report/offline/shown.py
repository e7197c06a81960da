"""A plan as the page shows it, fresh from the planner or read from its folder."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from berthing.errors import InputError
from berthing.report.recorded import recorded_verification
from berthing.report.verdict_table import Row, headline, plan_rows, verification_rows
from berthing.result import OUTCOMES
from berthing.scenario.scenario import Scenario
from berthing.trajectory import Plan
from berthing.trajectory_io import read_object
from berthing.verify.claims import Claims, read_claims
from berthing.verify.folder import CERTIFICATE_JSON, PLAN_JSON, read_plan
from berthing.verify.verification import Verification


@dataclass(frozen=True)
class Shown:
    """One plan of a page.

    Attributes:
        label: what it is called among those that it is compared with.
        scenario, plan, verification: as planned and checked.
        claims: what is proven, interval by interval.
        document: plan.json, from which outcome, times and attempts are taken.
    """

    label: str
    scenario: Scenario
    plan: Plan
    verification: Verification
    claims: Claims
    document: Mapping[str, Any]

    @property
    def outcome(self) -> str:
        """As in plan.json."""
        return str(self.document["outcome"])

    @property
    def stages_s(self) -> dict[str, float]:
        """Wall time of each stage, the total last."""
        stages = dict(self.document["wall_time_s"])
        total = stages.pop("total", None)
        return stages if total is None else {**stages, "total": total}

    @property
    def rows(self) -> list[Row]:
        """The verdict table."""
        timed = replace(self.plan, wall_time_s=self.stages_s)
        found = self.verification
        return [headline(self.outcome), *verification_rows(found), *plan_rows(timed, found)]


def shown_folder(folder: Path, label: str, *, trust: bool = False) -> Shown:
    """The plan in a folder with its verdict as recorded; nothing is checked again.

    Args:
        trust: run code of the user's own that the folder holds.

    Raises:
        InputError: a file is missing or malformed, the plan does not belong to its scenario, or
            the folder holds code that is not trusted.
    """
    scenario, plan = read_plan(folder, trust=trust)
    document, where = read_object(folder / PLAN_JSON), str(folder / PLAN_JSON)
    if document.get("outcome") not in OUTCOMES:
        raise InputError(f"{where}.outcome", f"is {document.get('outcome')!r}", ", ".join(OUTCOMES))
    _check_stages(document.get("wall_time_s"), f"{where}.wall_time_s")
    _check_attempts(document.setdefault("attempts", []), f"{where}.attempts")
    verification = recorded_verification(document, where)
    certificate = folder / CERTIFICATE_JSON
    claims = read_claims(certificate) if certificate.exists() else Claims("", ())
    return Shown(label, scenario, plan, verification, claims, document)


def _check_stages(stages: Any, where: str) -> None:
    numbers = isinstance(stages, dict) and all(isinstance(s, int | float) for s in stages.values())
    if not numbers:
        raise InputError(where, "is not an object of seconds")


def _check_attempts(attempts: Any, where: str) -> None:
    if not isinstance(attempts, list) or not all(isinstance(a, dict) for a in attempts):
        raise InputError(where, "is not a list of objects")
