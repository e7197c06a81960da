"""``berthing reproduce``."""

from __future__ import annotations

from pathlib import Path

from berthing.commands.console import print_rows, progress_line
from berthing.commands.exit_codes import CERTIFIED
from berthing.report.verdict_table import Row
from berthing.reproduce.cases import Cases
from berthing.reproduce.finding import FAILS, HOLDS
from berthing.reproduce.writing import CLAIMS_MD, check_folder, write_all

GOOD = {HOLDS: True, FAILS: False}


def run(out: Path) -> int:
    """Write the paper's figures and the table of its claims into ``out``; the exit code.

    Raises:
        InputError: the folder is not empty or cannot be written, or a case has no plan.
    """
    check_folder(out)
    with progress_line() as progress:
        findings = write_all(out, Cases(progress))
    rows = [Row(f.where, f"{f.claim}: {f.verdict}", GOOD.get(f.verdict)) for f in findings]
    print_rows([*rows, Row("written to", str(out / CLAIMS_MD))])
    return CERTIFIED
