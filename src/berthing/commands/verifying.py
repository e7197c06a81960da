"""``berthing verify``."""

from __future__ import annotations

from pathlib import Path

import typer

from berthing import result as outcomes
from berthing.commands.console import print_rows
from berthing.commands.exit_codes import CERTIFIED, NOT_CERTIFIED
from berthing.report.plan_json import to_text
from berthing.report.verdict_table import (
    Row,
    extremality_rows,
    headline,
    reason_rows,
    verification_rows,
)
from berthing.verify.folder import verify_folder
from berthing.verify.verification import Verification


def run(folder: Path, *, as_json: bool, trust: bool = False, search: bool = False) -> int:
    """Check the plan in a folder; the exit code.

    Args:
        folder: a plan folder.
        as_json: print JSON only.
        trust: run code of the user's own that the folder holds.
        search: prove clearance anew, whatever certificate.json says.

    Raises:
        InputError: the folder holds no plan that can be read, or code that is not trusted.
    """
    verification = verify_folder(folder, trust=trust, search=search)
    outcome = outcome_of(verification)
    if as_json:
        found = verification.optimality
        document = {
            "outcome": outcome,
            "verification": verification.to_json(),
            "optimality": None if found is None else found.to_json(),
        }
        typer.echo(to_text(document), nl=False)
    else:
        rows = [Row("folder", str(folder)), headline(outcome), *verification_rows(verification)]
        rows += extremality_rows(verification.optimality)
        print_rows([*rows, *reason_rows(verification)])
    return CERTIFIED if verification.certified else NOT_CERTIFIED


def outcome_of(verification: Verification) -> str:
    """The outcome of a check alone."""
    if verification.certified:
        return outcomes.CERTIFIED
    return outcomes.UNDECIDED if verification.undecided else outcomes.NOT_CERTIFIED
