"""The folder of a decomposition: pieces.json and pictures."""

from __future__ import annotations

from pathlib import Path

from berthing.errors import InputError
from berthing.mesh.from_file import solid_of
from berthing.mesh.pieces_file import Described
from berthing.report.mesh_figures import pieces_figure, protrusion_figure
from berthing.report.plan_json import to_text

PIECES_JSON = "pieces.json"


def check_folder(target: Path, *, force: bool) -> None:
    """Raise InputError unless a decomposition may be written into this folder."""
    if target.exists() and not target.is_dir():
        raise InputError(str(target), "is a file", "a folder, or nothing")
    if target.is_dir() and any(target.iterdir()) and not force:
        raise InputError(str(target), "is not empty", "another --out, or --force")


def write_folder(found: Described, folder: Path) -> None:
    """Write pieces.json, and for each part that is a mesh NAME-pieces.png and NAME-protrusion.png.

    Everything is made before the first file is written; files of other names stay.

    Args:
        found: what to write.
        folder: where to.

    Raises:
        InputError: the folder cannot be written.
    """
    files = {PIECES_JSON: to_text(found.to_json()).encode("utf-8")}
    for name, made in found.made.items():
        solid, _ = solid_of(found.files[name], scale=made.certificate.metres_per_unit)
        files[f"{name}-pieces.png"] = pieces_figure(solid, made.pieces)
        files[f"{name}-protrusion.png"] = protrusion_figure(solid, made.pieces)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in files.items():
            (folder / name).write_bytes(content)
    except OSError as error:
        where = str(error.filename or folder)
        raise InputError(where, f"cannot be written: {error.strerror or error}") from None
