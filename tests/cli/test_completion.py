import os
import subprocess
import sys

import pytest

from berthing.commands import completion
from berthing.export.formats import FORMATS


def completed(words, folder):
    """What bash is offered for the last of the words."""
    env = {
        **os.environ, "_BERTHING_COMPLETE": "complete_bash",
        "COMP_WORDS": words, "COMP_CWORD": str(words.count(" ")),
    }  # fmt: skip
    code = "import sys; sys.argv = ['berthing']; from berthing.cli import main; main()"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env=env, cwd=folder
    )
    return done.stdout.split()


@pytest.mark.parametrize(
    ("words", "wanted"),
    [
        ("berthing pl", ["plan"]),
        ("berthing plan scenario-b", ["scenario-b", "scenario-b-tight"]),
        ("berthing plan my", ["my/"]),
        ("berthing export x --to oe", ["oem"]),
        ("berthing plan nothing-like-it", []),
    ],
)
def test_bash_is_offered_what_fits(tmp_path, words, wanted):
    (tmp_path / "my").mkdir()
    (tmp_path / "mine.yaml").touch()
    (tmp_path / "mine.txt").touch()
    assert completed(words, tmp_path) == wanted


def test_files_and_folders_are_offered_beside_cases(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sub" / "deep").mkdir(parents=True)
    for name in ("sub/a.yaml", "sub/a.txt", "sub/.hidden.yaml", "scenario-mine.json"):
        (tmp_path / name).touch()
    assert completion.scenarios("sub/") == ["sub/a.yaml", "sub/deep/"]
    assert completion.scenarios("scenario-m") == ["scenario-mine.json"]
    assert "scenario-a" in completion.scenarios("")
    assert completion.scenarios("absent/x") == []


def test_every_format_is_offered():
    assert completion.formats("") == list(FORMATS)
