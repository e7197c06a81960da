"""Every example runs, is short, and ends with a certified plan."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("[0-9]*.py"))
LONGEST = 60
SLOW = {"01", "02", "06", "07"}


def marked(path: Path):
    slow = path.stem.split("_")[0] in SLOW
    return pytest.param(path, id=path.stem, marks=pytest.mark.slow if slow else ())


@pytest.mark.parametrize("path", [marked(path) for path in EXAMPLES])
def test_it_ends_with_a_certified_plan(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(path), run_name="__main__")
    assert "certified" in capsys.readouterr().out.replace("not_certified", "")


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_it_is_short_and_says_what_it_shows(path: Path) -> None:
    lines = path.read_text(encoding="utf-8").splitlines()
    assert len(lines) < LONGEST
    assert lines[0].startswith('"""')


def test_they_are_numbered_in_order() -> None:
    numbers = [int(path.stem.split("_")[0]) for path in EXAMPLES]
    assert len(numbers) >= 7
    assert len(set(numbers)) == len(numbers)
