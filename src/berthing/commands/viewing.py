"""``berthing view``."""

from __future__ import annotations

import os
import sys
import webbrowser
from collections.abc import Sequence
from pathlib import Path

import typer

from berthing.commands.exit_codes import CERTIFIED
from berthing.errors import InputError
from berthing.report.fresh_folder import REPORT_HTML
from berthing.report.offline.page import GENERATOR, shown_page
from berthing.report.offline.shown import shown_folder

COMPARE_HTML = Path("compare.html")
# Enough of a file to have the head of a page in it, but for its style.
HEAD_BYTES = 2000
# Without one of these a browser would be one of text that takes the terminal, or none.
DISPLAYS = ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER")


def run(folders: Sequence[Path], out: Path | None, *, open_it: bool, trust: bool = False) -> int:
    """Write the page of one plan, or one page of several, and open it; the exit code.

    Args:
        folders: plan folders, at least one.
        out: the page; None for report.html in a single folder, compare.html here for several.
        open_it: whether to open it where there is a display.
        trust: run code of the user's own that the folders hold.

    Raises:
        InputError: a folder holds no plan that can be read, or the page cannot be written there.
    """
    plans = [
        shown_folder(folder, label, trust=trust)
        for folder, label in zip(folders, labels(folders), strict=True)
    ]
    target = out or (folders[0] / REPORT_HTML if len(folders) == 1 else COMPARE_HTML)
    _check_replaceable(target)
    text = shown_page(plans)
    try:
        target.write_text(text, encoding="utf-8")
    except OSError as error:
        what = f"cannot be written: {error.strerror}"
        raise InputError(str(target), what, "another place: --out FILE") from None
    typer.echo(target)
    if open_it and _has_display():
        webbrowser.open(target.resolve().as_uri())
    return CERTIFIED


def labels(folders: Sequence[Path]) -> list[str]:
    """What plans are called beside each other: the folders' names, or more of their paths.

    >>> labels([Path("plans/a"), Path("plans/b")])
    ['a', 'b']
    >>> labels([Path("one/a"), Path("two/a")])
    ['one/a', 'two/a']
    >>> labels([Path("a"), Path("a")])
    ['a', 'a (2)']
    """
    paths = [folder.resolve() for folder in folders]
    depth = 1
    most = max(len(path.parts) for path in paths)
    while depth < most and len({path.parts[-depth:] for path in paths}) < len(set(paths)):
        depth += 1
    names = ["/".join(path.parts[-depth:]) for path in paths]
    seen = [names[: i + 1].count(name) for i, name in enumerate(names)]
    return [f"{n} ({k})" if k > 1 else n for n, k in zip(names, seen, strict=True)]


def _check_replaceable(target: Path) -> None:
    """A page of ours may be written anew; a file of the user's own may not."""
    if target.is_dir():
        raise InputError(str(target), "is a folder", "a file")
    try:
        head = target.read_bytes()[:HEAD_BYTES]
    except FileNotFoundError:
        return
    except OSError as error:
        raise InputError(str(target), f"cannot be read: {error.strerror}") from None
    if f'name="generator" content="{GENERATOR} '.encode() not in head:
        what = "exists and is no page of berthing's, so it is left alone"
        raise InputError(str(target), what, "another place: --out FILE")


def _has_display() -> bool:
    return sys.platform == "darwin" or any(os.environ.get(name) for name in DISPLAYS)
