"""A solid: what a closed surface of triangles encloses."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array

Triangles = npt.NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles as a file has them, in metres; corners at equal places are one vertex.

    Attributes:
        name: for messages: the file.
        sha256: of the file's bytes, in hex.
        vertices: (k, 3).
        triangles: (m, 3) indices, no two of a row equal; counter-clockwise seen from outside,
            if the file is as it should be.
    """

    name: str
    sha256: str
    vertices: Array
    triangles: Triangles

    @staticmethod
    def joined(name: str, sha256: str, corners: Array) -> Surface:
        """From corners (m, 3, 3) of triangles; triangles with two equal corners are left out.

        Corners are joined where they are equal to the last bit. What lies nearly together is
        left apart: to move a vertex would be to prove something of another mesh.
        """
        # Adding zero makes −0 and 0 one.
        vertices, index = np.unique(corners.reshape(-1, 3) + 0.0, axis=0, return_inverse=True)
        t = np.asarray(index, dtype=np.int64).reshape(-1, 3)
        proper = (t[:, 0] != t[:, 1]) & (t[:, 1] != t[:, 2]) & (t[:, 2] != t[:, 0])
        return Surface(name, sha256, vertices, t[proper])

    @property
    def corners(self) -> Array:
        """(m, 3, 3) in metres."""
        return self.vertices[self.triangles]

    @property
    def size(self) -> float:
        """Diagonal of the axis-parallel box around it, in metres."""
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))

    @property
    def volume(self) -> float:
        """Enclosed volume in m³; negative where the triangles face inward.

        Sum of the tetrahedra over a point near by, which loses fewer digits than the origin.
        """
        a, b, c = np.moveaxis(self.corners - self.vertices.mean(axis=0), 1, 0)
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0)

    @property
    def areas(self) -> Array:
        """Of the triangles (m,), in m²."""
        a, b, c = np.moveaxis(self.corners, 1, 0)
        return np.asarray(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1))


@dataclass(frozen=True, eq=False)
class Solid(Surface):
    """A surface that has been found closed, outward and free of crossings; see ``soundness``."""
