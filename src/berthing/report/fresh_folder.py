"""A folder that appears whole or not at all."""

from __future__ import annotations

import os
import secrets
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from berthing.errors import InputError
from berthing.verify.folder import (
    CERTIFICATE_JSON,
    INTERPOLANT_JSON,
    NODES_CSV,
    PLAN_JSON,
    TRAJECTORY_CSV,
)

FAILURE_JSON, REPORT_HTML = "failure.json", "report.html"
# Those of a route; its folder is kept as a plan's is.
ROUTE_JSON, ROUTE_CSV = "route.json", "route.csv"
# Everything that a plan folder may hold; a folder with more in it is not ours to replace.
FILES = frozenset(
    {
        PLAN_JSON,
        FAILURE_JSON,
        INTERPOLANT_JSON,
        TRAJECTORY_CSV,
        NODES_CSV,
        CERTIFICATE_JSON,
        REPORT_HTML,
        ROUTE_JSON,
        ROUTE_CSV,
    }
)
FIGURES = "figures"


def check_target(target: Path, *, force: bool) -> None:
    """Make sure that a plan folder may be written at ``target``.

    Raises:
        InputError: it is a file; or a folder with something in it and no ``force``; or, with
            ``force``, a folder that is not a plan's or has files of the user's in it; or it
            cannot be written.
    """
    if target.is_symlink() and not target.exists():
        raise InputError(str(target), "is a link to nothing", "a folder, or nothing")
    if target.exists() and not target.is_dir():
        raise InputError(str(target), "is a file", "a folder, or nothing")
    standing = target if target.exists() else None
    if standing is not None and any(standing.iterdir()):
        if not force:
            raise InputError(str(target), "is not empty", "another --out, or --force")
        _check_replaceable(standing)
    _check_writable(target)


def _check_replaceable(folder: Path) -> None:
    names = {entry.name for entry in folder.iterdir()}
    if not names & {PLAN_JSON, FAILURE_JSON, ROUTE_JSON}:
        what = f"holds no {PLAN_JSON}, so it is no plan folder and is left alone"
        raise InputError(str(folder), what, "another --out")
    foreign = sorted(_foreign(folder))
    if foreign:
        what = f"holds files that are not of a plan ({', '.join(foreign[:3])}) and is left alone"
        raise InputError(str(folder), what, "another --out")


def _foreign(folder: Path) -> Iterator[str]:
    for entry in folder.iterdir():
        if entry.name == FIGURES and entry.is_dir() and not entry.is_symlink():
            for figure in entry.iterdir():
                if figure.suffix != ".png" or not figure.is_file():
                    yield f"{FIGURES}/{figure.name}"
        elif entry.name not in FILES or not entry.is_file():
            yield entry.name


def _check_writable(target: Path) -> None:
    # Renaming needs the right to write in the folder around it: the nearest one that exists.
    around = target.resolve().parent
    while not around.exists():
        around = around.parent
    if not around.is_dir():
        raise InputError(str(target), f"lies in {around}, which is a file", "a folder")
    if not os.access(around, os.W_OK | os.X_OK):
        raise InputError(str(target), f"cannot be written: {around} is read-only for this user")


@contextmanager
def fresh_folder(target: Path, *, force: bool) -> Iterator[Path]:
    """A temporary folder beside ``target`` that takes its place when the block ends well.

    When it ends badly, with an interrupt too, nothing stays behind, and what stood at
    ``target`` stands as before. Links are followed: the folder they lead to is replaced.

    Raises:
        InputError: as ``check_target``.
    """
    check_target(target, force=force)
    target = target.resolve()
    temporary = _beside(target, "part")
    missing = [p for p in target.parents if not p.exists()]
    try:
        temporary.mkdir(parents=True)
        yield temporary
        check_target(target, force=force)
        _swap(temporary, target)
    except BaseException:
        shutil.rmtree(temporary, ignore_errors=True)
        for parent in missing:
            _remove_if_empty(parent)
        raise


def _swap(temporary: Path, target: Path) -> None:
    if not target.exists() or not any(target.iterdir()):
        # On POSIX a rename replaces an empty folder in one step.
        temporary.rename(target)
        return
    old = _beside(target, "old")
    target.rename(old)
    try:
        temporary.rename(target)
    except BaseException:
        old.rename(target)
        raise
    shutil.rmtree(old, ignore_errors=True)


def _beside(target: Path, suffix: str) -> Path:
    """A hidden path in the same folder, hence on the same disk, that nobody else uses."""
    return target.with_name(f".{target.name}.{secrets.token_hex(4)}.{suffix}")


def _remove_if_empty(folder: Path) -> None:
    if folder.is_dir() and not any(folder.iterdir()):
        folder.rmdir()
