"""From a mesh file to pieces, by way of the cache."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path

from berthing.mesh import cache
from berthing.mesh.coacd_run import coacd_version
from berthing.mesh.decompose import decompose
from berthing.mesh.decomposition import Decomposition
from berthing.mesh.reading import FORMATS, Scale, file_sha256, read_surface
from berthing.mesh.settings import DEFAULT, DecomposeSettings
from berthing.mesh.solid import Solid
from berthing.mesh.soundness import sound
from berthing.mesh.units import metres_per


def decomposed(
    path: Path,
    *,
    units: str | None = None,
    scale: Scale | None = None,
    settings: DecomposeSettings = DEFAULT,
) -> Decomposition:
    """Pieces that provably contain the solid in a file.

    Args:
        path: STL, OBJ, PLY or GLB.
        units: of its numbers; None for what its format says.
        scale: metres in one of its numbers along each axis, instead of units.
        settings: how.

    Raises:
        InputError: anything wrong with the file, with what it holds, or with the installation.
    """
    digest = file_sha256(path)
    stated = units or FORMATS[path.suffix.lower()]
    if scale is None and stated is not None:
        scale = (metres_per(stated, f"{path}: units"),) * 3
    if scale is None:
        read_surface(path)  # which refuses, with the size of what it read
    key = cache.key(
        sha256=digest,
        scale=scale,
        coacd=coacd_version(),
        **asdict(settings),
    )
    made = cache.recalled(key)
    if made is None:
        solid, scale = solid_of(path, scale=scale)
        made = Decomposition.of(solid, decompose(solid, settings), scale, settings.seed)
        cache.keep(key, made)
    return made


def solid_of(
    path: Path, *, units: str | None = None, scale: Scale | None = None
) -> tuple[Solid, Scale]:
    """The solid in a file, in metres, and the metres of one of its units along each axis.

    Raises:
        InputError: the file cannot be read, its units are unknown, or it encloses no solid.
    """
    surface, scale = read_surface(path, units=units, scale=scale)
    return sound(surface), scale
