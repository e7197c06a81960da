import json
import os
import subprocess
import sys

import pytest

from berthing import cli
from berthing._version import __version__
from berthing.commands.console import progress_line
from berthing.errors import InputError
from support import synthetic


@pytest.fixture
def checked(monkeypatch):
    """A check that finds what it is told."""
    from berthing.scenario.files import load

    def find(certified):
        found = synthetic.verification(load("scenario-a"), certified)
        verify_folder = "berthing.commands.verifying.verify_folder"
        monkeypatch.setattr(verify_folder, lambda folder, **options: found)

    return find


@pytest.mark.parametrize(("certified", "code"), [(True, 0), (False, 4)])
def test_verify_exits_0_or_4(run, checked, certified, code):
    checked(certified)
    done = run("verify", "plans/scenario-a")
    assert done.exit_code == code
    assert ("NOT certified" in done.stdout) is not certified
    said = json.loads(run("verify", "plans/scenario-a", "--json", "--trust").stdout)
    assert said["outcome"] == ("certified" if certified else "not_certified")
    assert said["verification"]["certified"] is certified


def test_verify_of_what_is_no_plan_exits_2(run, tmp_path):
    (tmp_path / "empty").mkdir()
    for folder in ("absent", "empty"):
        done = run("verify", folder)
        assert done.exit_code == 2
        assert folder in done.stderr
        assert done.stdout == ""


def test_scenarios_lists_every_case(run):
    from berthing.scenario.library import library

    done = run("scenarios")
    assert done.exit_code == 0
    for name, headline in library().items():
        assert name in done.stdout
        assert headline in done.stdout
    assert json.loads(run("scenarios", "--json").stdout) == library()


def test_schema_is_json(run):
    done = run("schema")
    assert done.exit_code == 0
    assert json.loads(done.stdout)["title"] == "berthing scenario"


def test_version(run):
    done = run("--version")
    assert (done.exit_code, done.stdout) == (0, f"berthing {__version__}\n")


@pytest.mark.parametrize("command", [None, *(c.name for c in cli.app.registered_commands)])
def test_help_has_examples_that_are_commands(run, command):
    done = run(*([command] if command else []), "--help")
    assert done.exit_code == 0
    examples = done.stdout.split("Examples")[1].split("╭")[0]
    assert f"berthing {command or ''}".strip() in examples


def test_an_unknown_command_exits_2(run):
    assert run("fly").exit_code == 2


def test_help_loads_nothing_heavy():
    heavy = ["casadi", "numpy", "scipy", "matplotlib", "coal", "pydantic"]
    code = f"import sys, berthing.cli; print([m for m in {heavy} if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


def test_mistakes_of_ours_keep_their_traceback(run, monkeypatch):
    def broken(folder, **options):
        raise RuntimeError("a mistake")

    monkeypatch.setattr("berthing.commands.verifying.verify_folder", broken)
    done = run("verify", "plans/scenario-a")
    assert isinstance(done.exception, RuntimeError)


def test_errors_are_one_line(run, monkeypatch):
    def refuse(folder, **options):
        raise InputError("plan.json", "is missing")

    monkeypatch.setattr("berthing.commands.verifying.verify_folder", refuse)
    assert run("verify", "x").stderr == "berthing: plan.json: is missing\n"


def test_nobody_is_told_of_progress_without_a_terminal():
    with progress_line() as progress:
        assert progress is None


@pytest.mark.parametrize(("given", "taken"), [(None, "1"), ("3", "3")])
def test_small_matrices_get_one_thread_unless_told_otherwise(monkeypatch, given, taken):
    for name in cli.BLAS_THREADS:
        # What is set here is undone, whether the command line changes it or not.
        monkeypatch.setenv(name, given or "")
        if given is None:
            monkeypatch.delenv(name)
    monkeypatch.setattr(cli, "app", lambda: None)
    cli.main()
    assert [os.environ[name] for name in cli.BLAS_THREADS] == [taken, taken]
