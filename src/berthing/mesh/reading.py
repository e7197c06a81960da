"""Triangles from files: STL, OBJ, PLY, GLB."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.mesh.optional import optional
from berthing.mesh.solid import Surface
from berthing.mesh.units import metres_per, refuse_to_guess

# What a format says of its units: glTF 2.0, section 3.4, has metres; the others nothing.
FORMATS: dict[str, str | None] = {".stl": None, ".obj": None, ".ply": None, ".glb": "m"}

Scale = tuple[float, float, float]


def read_surface(
    path: Path, *, units: str | None = None, scale: Scale | None = None
) -> tuple[Surface, Scale]:
    """The triangles of a file in metres, and the metres of one of its units along each axis.

    Args:
        path: the file.
        units: those of its numbers; None for what its format says.
        scale: metres in one of its numbers along each axis, where that is known otherwise, as in a
            URDF; an odd number of negative ones mirrors, and the triangles are turned back.

    Raises:
        InputError: no such file, another format, units that are unknown or that nobody stated, or
            content that cannot be read.
    """
    digest = file_sha256(path)
    corners = _corners(path)
    if scale is None:
        stated = units or FORMATS[path.suffix.lower()]
        if stated is None:
            sides = np.ptp(corners.reshape(-1, 3), axis=0)
            raise refuse_to_guess(str(path), float(np.max(sides)))
        scale = (metres_per(stated, f"{path}: units"),) * 3
    corners = corners * np.array(scale)
    if np.prod(np.sign(scale)) < 0.0:
        corners = corners[:, ::-1]
    return Surface.joined(str(path), digest, corners), scale


def file_sha256(path: Path) -> str:
    """Of a mesh file's bytes, in hex; InputError unless it is a file of a format that is read."""
    if path.suffix.lower() not in FORMATS:
        what = f"has the suffix {path.suffix!r}" if path.suffix else "has no suffix"
        known = ", ".join(suffix[1:].upper() for suffix in FORMATS)
        raise InputError(str(path), what, f"{known}; export one from CAD")
    if not path.exists():
        raise InputError(str(path), "does not exist", "a file of triangles")
    if not path.is_file():
        raise InputError(str(path), "is not a file", "a file of triangles")
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError as error:
        raise InputError(str(path), f"cannot be read: {error.strerror}") from None


def _corners(path: Path) -> Array:
    """Corners (m, 3, 3) of all triangles, in the units of the file."""
    trimesh: Any = optional("trimesh")
    try:
        # As it is: nothing joined, nothing dropped, nothing turned.
        scene = trimesh.load_scene(str(path), process=False)
        meshes: Sequence[Any] = [m for m in scene.dump() if isinstance(m, trimesh.Trimesh)]
        corners = [np.asarray(m.vertices, dtype=np.float64)[np.asarray(m.faces)] for m in meshes]
    # Whatever a parser of a broken file comes upon; there is no list of it.
    except Exception as error:
        kind = path.suffix[1:].upper()
        reason = "" if isinstance(error, ImportError) else f": {error}"
        what = f"cannot be read as {kind}{reason}"
        raise InputError(str(path), what, f"a sound {kind} file") from None
    found = np.concatenate([np.empty((0, 3, 3)), *corners])
    if not len(found):
        raise InputError(str(path), "has no triangles", "a closed surface of triangles")
    if not np.all(np.isfinite(found)):
        raise InputError(str(path), "has coordinates that are not numbers", "finite ones")
    return found
