"""Every example is short; those that plan run, and end with a certified plan.

Those that check a plan folder have tests of their own, in ``test_checkers``.
"""

from __future__ import annotations

import runpy
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("[0-9]*.py"))
# A checker in NumPy alone has everything that berthing has in its library.
CHECKERS = {"09": 150, "10": 150}
LONGEST = 60
SLOW = {"01", "02", "06", "07", "08", "11", "12", "13", "14", "15", "16", "18"}
# OMPL takes its seed once in a process.
ALONE = {"15", "16"}


def number(path: Path) -> str:
    return path.stem.split("_")[0]


def marked(path: Path):
    slow = number(path) in SLOW
    return pytest.param(path, id=path.stem, marks=pytest.mark.slow if slow else ())


PLANNERS = [path for path in EXAMPLES if number(path) not in {*CHECKERS, *ALONE}]


@pytest.mark.parametrize("path", [marked(path) for path in PLANNERS])
def test_it_ends_with_a_certified_plan(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(path), run_name="__main__")
    assert "certified" in capsys.readouterr().out.replace("not_certified", "")


@pytest.mark.parametrize("path", [marked(path) for path in EXAMPLES if number(path) in ALONE])
def test_it_ends_with_a_certified_path(path: Path) -> None:
    done = subprocess.run([sys.executable, path], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.endswith(": certified\n")


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_it_is_short_and_says_what_it_shows(path: Path) -> None:
    lines = path.read_text(encoding="utf-8").splitlines()
    assert len(lines) < CHECKERS.get(number(path), LONGEST)
    assert lines[0].startswith('"""')


def test_they_are_numbered_in_order() -> None:
    numbers = [int(path.stem.split("_")[0]) for path in EXAMPLES]
    assert len(numbers) >= 10
    assert len(set(numbers)) == len(numbers)
