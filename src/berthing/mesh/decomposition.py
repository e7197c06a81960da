"""Pieces of a mesh with their certificate: what is cached, embedded in scenarios and checked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.mesh.certificate import Certificate, Vector
from berthing.mesh.coacd_run import coacd_version
from berthing.mesh.decompose import Cover
from berthing.mesh.mass import MassProperties, of_solid
from berthing.mesh.piece import Piece
from berthing.mesh.solid import Solid

# Rows and columns of the six entries of a symmetric matrix.
_ROWS, _COLUMNS = (0, 1, 2, 0, 0, 1), (0, 1, 2, 1, 2, 2)


@dataclass(frozen=True, eq=False)
class Decomposition:
    """Pieces that contain a solid, and the certificate that says so.

    Attributes:
        pieces: in the frame of the mesh, metres.
        certificate: of them.
    """

    pieces: tuple[Piece, ...]
    certificate: Certificate

    @staticmethod
    def of(solid: Solid, cover: Cover, scale: Vector, seed: int) -> Decomposition:
        """From what was proven of a solid."""
        volume, centre, inertia = moments(solid)
        certificate = Certificate(
            solid.sha256,
            scale,
            len(solid.triangles),
            volume,
            centre,
            inertia,
            cover.push_m,
            cover.coverage.uncovered_area_m2,
            cover.coverage.voids or 0,
            cover.volume / volume,
            len(cover.pieces),
            tuple(piece.faces for piece in cover.pieces),
            coacd_version() if cover.threshold > 0.0 else "",
            cover.threshold,
            seed,
        )
        return Decomposition(cover.pieces, certificate)

    def mass_properties(self, density_kg_m3: float) -> MassProperties:
        """Of the solid, not of its pieces, about the origin of the mesh's frame."""
        said = self.certificate
        inertia = np.zeros((3, 3))
        inertia[_ROWS, _COLUMNS] = inertia[_COLUMNS, _ROWS] = said.inertia_m5
        about_centre = MassProperties.of_inertia(said.volume_m3, inertia)
        placed = about_centre.seen_from(Pose(np.array(said.centre_m), np.eye(3)))
        return placed.scaled(density_kg_m3)

    def to_json(self) -> dict[str, Any]:
        """The keys ``pieces`` and ``certificate`` of a scenario's part."""
        pieces = [piece.to_json() for piece in self.pieces]
        return {"pieces": pieces, "certificate": self.certificate.to_json(pieces)}

    @staticmethod
    def from_json(data: Mapping[str, Any], where: str) -> Decomposition:
        """What ``to_json`` wrote, unedited.

        Raises:
            InputError: anything else.
        """
        pieces, said = data.get("pieces"), data.get("certificate")
        if not isinstance(pieces, list) or not all(isinstance(p, dict) for p in pieces):
            raise InputError(f"{where}.pieces", "is not a list of pieces")
        if not isinstance(said, dict):
            raise InputError(f"{where}.certificate", "is not a certificate")
        certificate = Certificate.from_json(said, pieces, f"{where}.certificate")
        read = [Piece.from_json(p, f"{where}.pieces[{i}]") for i, p in enumerate(pieces)]
        return Decomposition(tuple(read), certificate)


def moments(solid: Solid) -> tuple[float, Vector, tuple[float, ...]]:
    """Volume in m³, centroid in m, and inertia about it in m⁵: xx, yy, zz, xy, xz, yz."""
    about_origin = of_solid(solid)
    centre: Array = about_origin.first_moment_kg_m / about_origin.mass_kg
    inertia = about_origin.seen_from(Pose(-centre, np.eye(3))).inertia_kg_m2
    x, y, z = centre.tolist()
    return about_origin.mass_kg, (x, y, z), tuple(inertia[_ROWS, _COLUMNS].tolist())
