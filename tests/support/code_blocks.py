"""Code blocks of documentation pages, and running them as a reader would."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from ruamel.yaml import YAML

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
FENCE = re.compile(
    r"^(?P<indent> *)```(?P<language>[\w-]*)(?P<rest>[^\n]*)\n(?P<code>.*?)^(?P=indent)``` *$",
    re.MULTILINE | re.DOTALL,
)
TITLE = re.compile(r'title="([^"]*)"')
# What is shown and not run: output, and layouts of files.
SHOWN = {"", "text"}


@dataclass(frozen=True)
class Block:
    """One fenced block.

    Attributes:
        place: page and line, for messages.
        language: as written.
        title: the file that it is, if any.
        code: without the fences.
    """

    place: str
    language: str
    title: str | None
    code: str


def pages() -> list[Path]:
    """Every page of the documentation, and the README."""
    return [ROOT / "README.md", *sorted(DOCS.rglob("*.md"))]


def blocks(page: Path) -> list[Block]:
    """The fenced blocks of a page, in their order."""
    text = page.read_text(encoding="utf-8")
    found = []
    for match in FENCE.finditer(text):
        title = TITLE.search(match["rest"])
        line = text.count("\n", 0, match.start()) + 1
        code = re.sub(f"^{match['indent']}", "", match["code"], flags=re.MULTILINE)
        found.append(Block(f"{page.name}:{line}", match["language"], title and title[1], code))
    return found


class Reader:
    """Somebody who goes through a page from top to bottom, in one folder and one Python session."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.names: dict[str, object] = {"__name__": "__main__"}

    def follow(self, block: Block) -> None:
        """Run a block, or write the file that it is.

        Raises:
            Exception: whatever goes wrong in it, or a language that nobody knows to run.
        """
        if block.title is not None:
            target = self.folder / block.title
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(block.code, encoding="utf-8")
        elif block.language not in SHOWN:
            ACTIONS[block.language](self, block)

    def python(self, block: Block) -> None:
        before = Path.cwd()
        os.chdir(self.folder)
        try:
            exec(compile(block.code, block.place, "exec"), self.names)
        finally:
            os.chdir(before)

    def shell(self, block: Block) -> None:
        home = self.folder / ".bin"
        home.mkdir(exist_ok=True)
        command = home / "berthing"
        command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m berthing "$@"\n')
        command.chmod(0o755)
        source = str(ROOT / "src")
        env = {**os.environ, "PATH": f"{home}:{os.environ['PATH']}", "PYTHONPATH": source}
        done = subprocess.run(
            ["bash", "-euo", "pipefail", "-c", block.code],
            cwd=self.folder, env=env, capture_output=True, text=True, stdin=subprocess.DEVNULL,
        )  # fmt: skip
        if done.returncode:
            raise RuntimeError(f"{block.place}: {done.returncode}\n{done.stdout}\n{done.stderr}")

    def yaml(self, block: Block) -> None:
        YAML(typ="safe", pure=True).load(block.code)

    def json(self, block: Block) -> None:
        json.loads(block.code)


ACTIONS = {
    "python": Reader.python, "sh": Reader.shell, "yaml": Reader.yaml, "json": Reader.json,
}  # fmt: skip
