"""That each case has a solution: its witness, certified for all time."""

from __future__ import annotations

from benchmarks.tight3d._scene import Case
from berthing.scenario.normal import document_sha256
from berthing.verify.verification import verify


def proven(case: Case) -> dict:
    """The case's fingerprint, and what the check says of its witness."""
    scenario = case.scenario()
    plan = case.witness(scenario)
    found = verify(scenario, plan)
    return {
        "family": case.family, "seed": case.seed, "sha256": document_sha256(case.document),
        "certified": found.certified, "cost": float(f"{plan.cost:.6g}"),
        "reasons": list(found.reasons[:3]),
    }  # fmt: skip
