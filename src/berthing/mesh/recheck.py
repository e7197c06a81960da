"""The proof once more, from the mesh file and the pieces as they are written."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from berthing.errors import InputError
from berthing.mesh.coverage import coverage
from berthing.mesh.decomposition import Decomposition, moments
from berthing.mesh.reading import read_surface
from berthing.mesh.soundness import sound

# Numbers of the certificate that are worked out again; sums in another order round otherwise.
AGREEMENT = 1e-9


def faults(block: Mapping[str, Any], mesh: Path) -> list[str]:
    """What is wrong with the pieces and the certificate of a part; empty where they hold.

    Args:
        block: with the keys ``pieces`` and ``certificate``.
        mesh: the file that they are of.

    Raises:
        InputError: the mesh cannot be read, or encloses no solid.
    """
    try:
        held = Decomposition.from_json(block, "part")
    except InputError as error:
        return [str(error)]
    said = held.certificate
    surface, _ = read_surface(mesh, scale=said.metres_per_unit)
    if surface.sha256 != said.mesh_sha256:
        return [f"{mesh} is not the file that was decomposed: its SHA-256 is {surface.sha256}"]
    solid = sound(surface)
    found = coverage(solid, [piece.core for piece in held.pieces])
    volume, centre, inertia = moments(solid)
    claims: list[tuple[str, Any, Any]] = [
        ("triangles", said.triangles, len(solid.triangles)),
        ("volume_m3", said.volume_m3, volume),
        ("centre_m", said.centre_m, centre),
        ("inertia_m5", said.inertia_m5, inertia),
    ]
    left = _uncovered(found.uncovered_triangles, found.uncovered_area_m2, found.voids)
    return [*left, *_wrong(claims), *faults_without_mesh(held)]


def faults_without_mesh(held: Decomposition) -> list[str]:
    """Where a certificate and its pieces contradict each other; empty where they agree.

    That they contain the mesh cannot be told from them alone.
    """
    said = held.certificate
    volume = sum(piece.volume for piece in held.pieces)
    claims: list[tuple[str, Any, Any]] = [
        ("uncovered_area_m2", said.uncovered_area_m2, 0.0),
        ("voids", said.voids, 0),
        ("volume_ratio", said.volume_ratio, volume / said.volume_m3),
        ("pieces", said.pieces, len(held.pieces)),
        ("faces", said.faces, tuple(piece.faces for piece in held.pieces)),
    ]
    return _wrong(claims)


def _wrong(claims: Sequence[tuple[str, Any, Any]]) -> list[str]:
    return [
        f"certificate.{key} is {claim}, found {truth}"
        for key, claim, truth in claims
        if not _agree(claim, truth)
    ]


def _uncovered(triangles: int, area_m2: float, voids: int | None) -> list[str]:
    left = []
    if triangles:
        left.append(f"the pieces do not cover {triangles} triangles of the mesh: {area_m2:.3g} m²")
    if voids:
        left.append(f"the pieces leave gaps inside the solid, which begin at {voids} places")
    return left


def _agree(claim: Any, truth: Any) -> bool:
    a, b = np.atleast_1d(claim), np.atleast_1d(truth)
    scale = float(np.max(np.abs(b), initial=0.0))
    return a.shape == b.shape and bool(np.all(np.abs(a - b) <= AGREEMENT * scale))
