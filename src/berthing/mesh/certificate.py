"""What is claimed of pieces, so that it can be checked again from files alone."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, fields
from typing import Any

from berthing.errors import InputError

Vector = tuple[float, float, float]
SEAL = "seal_sha256"


@dataclass(frozen=True)
class Certificate:
    """That pieces contain the solid in a file.

    Attributes:
        mesh_sha256: of the file's bytes, in hex.
        metres_per_unit: by which its numbers were multiplied, along each axis.
        triangles: of its surface.
        volume_m3: of the solid.
        centre_m: its centroid.
        inertia_m5: about the centroid, for a density of one: xx, yy, zz, xy, xz, yz, the last
            three being the entries of the matrix.
        push_m: by how much the faces of the pieces were moved out.
        uncovered_area_m2: of the surface outside all pieces; 0.
        voids: places inside the solid at which a gap between pieces begins; 0.
        volume_ratio: the sum of the pieces' volumes over the solid's; overlaps count twice.
        pieces: how many.
        faces: of each piece.
        coacd: version of CoACD; empty where it was not needed.
        threshold: of CoACD; 0 where it was not needed.
        seed: of CoACD.
    """

    mesh_sha256: str
    metres_per_unit: Vector
    triangles: int
    volume_m3: float
    centre_m: Vector
    inertia_m5: tuple[float, ...]
    push_m: float
    uncovered_area_m2: float
    voids: int
    volume_ratio: float
    pieces: int
    faces: tuple[int, ...]
    coacd: str
    threshold: float
    seed: int

    def to_json(self, pieces: Sequence[Any]) -> dict[str, Any]:
        """The certificate of these pieces, with a seal over both."""
        content = {k: list(v) if isinstance(v, tuple) else v for k, v in asdict(self).items()}
        return {**content, SEAL: seal(content, pieces)}

    @staticmethod
    def from_json(data: Mapping[str, Any], pieces: Sequence[Any], where: str) -> Certificate:
        """What ``to_json`` wrote, its seal intact.

        Raises:
            InputError: keys that are missing or strange, or an edit of the certificate or of the
                pieces.
        """
        content = {key: value for key, value in data.items() if key != SEAL}
        if set(content) != {field.name for field in fields(Certificate)}:
            raise InputError(where, "has not the keys of a certificate of this version")
        if data.get(SEAL) != seal(content, pieces):
            what = "does not fit its seal: it or the pieces were edited after the proof"
            raise InputError(where, what, "what berthing wrote")
        read: dict[str, Any] = {k: _frozen(v) for k, v in content.items()}
        return Certificate(**read)


def _frozen(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value


def seal(content: Mapping[str, Any], pieces: Sequence[Any]) -> str:
    """SHA-256, in hex, of the canonical JSON of a certificate and its pieces."""
    text = json.dumps(
        {"certificate": dict(content), "pieces": list(pieces)},
        sort_keys=True,
        separators=(",", ":"),
    )
    return hashlib.sha256(text.encode("ascii")).hexdigest()
