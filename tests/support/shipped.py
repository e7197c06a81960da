"""The cases that ship: which of them must come out certified, and one plan of each a test run."""

from __future__ import annotations

import fcntl
import os
from pathlib import Path

import pytest
from typer.testing import CliRunner

from berthing.cli import app
from berthing.scenario.files import load
from berthing.scenario.library import library

LONG = frozenset({"parking-parallel", "quadcopter-room"})
"""Cases that take a minute and more: ``python -m benchmarks public`` plans and checks them."""


def to_be_certified() -> list[str]:
    """All but the long ones, and those that are planned by models inside their shapes, to show
    what comes of it."""
    return [name for name in library() if name not in LONG and not planned_smaller(name)]


def planned_smaller(name: str) -> bool:
    """Whether a part of the case is planned smaller than it is."""
    scenario = load(name)
    pairs = [pair for phase in scenario.phases for pair in scenario.pairs(phase)]
    return any(part.planned_smaller for pair in pairs for part in (pair.part_a, pair.part_b))


def planned_folder(name: str, factory: pytest.TempPathFactory) -> Path:
    """The plan folder of a case, made by the command line when first asked for; not to be changed.

    All workers of a run share it: they have one base folder between them.
    """
    base = factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        base = base.parent
    folder = base / "shipped" / name
    folder.parent.mkdir(exist_ok=True)
    with (folder.parent / f"{name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not folder.exists():
            done = CliRunner().invoke(app, ["plan", name, "--out", str(folder), "--json"])
            assert done.exit_code == 0, done.output
    return folder
