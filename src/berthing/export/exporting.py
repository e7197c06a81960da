"""From a plan folder to a file of another format."""

from __future__ import annotations

import os
import secrets
import shutil
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any

from berthing.errors import InputError
from berthing.export.extras import extra
from berthing.export.formats import Format
from berthing.export.handover import Handover, read_handover
from berthing.verify.folder import INTERPOLANT_JSON, NODES_CSV, PLAN_JSON, TRAJECTORY_CSV

Writer = Callable[[Handover, Path], None]
PLAN_FILES = (PLAN_JSON, INTERPOLANT_JSON, NODES_CSV, TRAJECTORY_CSV)


def export(
    folder: Path,
    kind: Format,
    out: Path | None = None,
    *,
    vehicle: str | None = None,
    extra_meta: Mapping[str, Any] | None = None,
    trust: bool = False,
) -> list[Path]:
    """Write the plan in a folder as a file of that format.

    Args:
        folder: a plan folder.
        kind: the format.
        out: the file; None for the scenario's name, and the vehicle's where it is one of several,
            in the working folder. An older file is replaced.
        vehicle: only this one.
        extra_meta: keys that overrule the scenario's ``meta:``.
        trust: run code of the user's own that the folder holds.

    Returns:
        The files written, the one asked for first.

    Raises:
        InputError: anything wrong with the input, a package missing, or a file that cannot be
            written. Nothing is written then.
    """
    if kind.package is not None:
        extra(kind.package)
    handover = read_handover(
        folder, kind, vehicle=vehicle, extra_meta=extra_meta or {}, trust=trust
    )
    target = _default(handover, kind, vehicle) if out is None else out
    _check_target(target)
    write: Writer = import_module(f"berthing.export.{kind.module}").write
    try:
        with _fresh_files(target) as temporary:
            write(handover, temporary)
            names = [p.name for p in temporary.parent.iterdir()]
    except OSError as error:
        where = str(error.filename or target)
        raise InputError(where, f"cannot be written: {error.strerror or error}") from None
    return [target, *sorted(target.with_name(name) for name in names if name != target.name)]


def _default(handover: Handover, kind: Format, vehicle: str | None) -> Path:
    stem = handover.scenario.name if vehicle is None else f"{handover.scenario.name}-{vehicle}"
    return Path(f"{stem}{kind.suffix}")


def _check_target(target: Path) -> None:
    if target.is_dir():
        raise InputError(str(target), "is a folder", "a file")
    if target.exists() and not target.is_file():
        raise InputError(str(target), "is no ordinary file", "a file, or nothing")
    if target.name in PLAN_FILES and (target.parent / PLAN_JSON).exists():
        raise InputError(str(target), "is a file of a plan folder", "another --out")
    if not target.resolve().parent.is_dir():
        raise InputError(str(target), "lies in a folder that does not exist", "one that does")


@contextmanager
def _fresh_files(target: Path) -> Iterator[Path]:
    """A path in a hidden folder beside ``target``; what is there in the end is moved into place.

    When the block ends badly, nothing stays behind, and what stood at ``target`` stands as before.
    """
    target = target.resolve()
    temporary = target.with_name(f".{target.name}.{secrets.token_hex(4)}.part")
    try:
        temporary.mkdir()
        yield temporary / target.name
        # Companions first: whoever waits for the file asked for finds them there.
        written = sorted(temporary.iterdir(), key=lambda path: path.name == target.name)
        for path in written:
            os.replace(path, target.with_name(path.name))
    finally:
        shutil.rmtree(temporary, ignore_errors=True)
