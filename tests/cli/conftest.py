from types import SimpleNamespace

import pytest
from typer.testing import CliRunner

from berthing import cli, planner
from berthing.result import ProgressEvent
from support import synthetic


@pytest.fixture
def run(tmp_path, monkeypatch):
    """Runs the command line in an empty folder, output and errors apart."""
    monkeypatch.chdir(tmp_path)
    return lambda *words: CliRunner().invoke(cli.app, list(words))


@pytest.fixture
def answer(monkeypatch):
    """A planner that gives what it is told, and remembers how it was asked."""
    asked = SimpleNamespace(answer=synthetic.certified, options=None, calls=0, progress=None)

    def plan(scenario, *, options=None, progress=None):
        asked.calls += 1
        asked.options, asked.progress = options, progress
        if progress is not None:
            progress(ProgressEvent("solve", "straight", 12, 0.02))
        return asked.answer(scenario)

    monkeypatch.setattr(planner, "plan", plan)
    return asked
