"""What of a convex surface a viewer sees: its front triangles, and its edges."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from berthing.geometry.arrays import Array
from berthing.geometry.mesh import Mesh
from berthing.geometry.pose import Pose
from berthing.report.camera import Camera

# A triangle seen edge-on covers nothing; which side of zero its cosine falls is rounding.
EDGE_ON = 1e-9
# Neighbouring triangles that bend by more than this make an edge that is drawn.
CREASE_COSINE = float(np.cos(np.radians(25.0)))


@dataclass(frozen=True, eq=False)
class Surface:
    """A mesh with its neighbourhoods, worked out once.

    Attributes:
        vertices: (k, 3), own frame.
        triangles: (m, 3) corners.
        edges: (e, 2) corners.
        neighbours: (e, 2) triangles on either side; the same twice at the rim of a flat shape.
    """

    vertices: Array
    triangles: npt.NDArray[np.int64]
    edges: npt.NDArray[np.int64]
    neighbours: npt.NDArray[np.int64]

    @staticmethod
    def of(mesh: Mesh) -> Surface:
        """From a mesh in which no edge has more than two triangles."""
        t = mesh.triangles
        every = np.sort(np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]), axis=1)
        owner = np.tile(np.arange(len(t)), 3)
        edges, where = np.unique(every, axis=0, return_inverse=True)
        where = where.reshape(-1)
        neighbours = np.empty((len(edges), 2), dtype=np.int64)
        # The first and the last to write an edge: both its triangles, or the only one.
        neighbours[where[::-1], 0] = owner[::-1]
        neighbours[where, 1] = owner
        return Surface(mesh.vertices, t, edges, neighbours)

    @cached_property
    def sharp(self) -> npt.NDArray[np.bool_]:
        """Which edges (e,) are creases, or the rim of a flat shape: drawn from wherever seen."""
        normal = _normals(self.vertices[self.triangles])
        one, other = self.neighbours.T
        crease = np.einsum("ij,ij->i", normal[one], normal[other]) < CREASE_COSINE
        return np.asarray(crease | (one == other))

    def seen(self, pose: Pose, camera: Camera) -> Seen:
        """What the camera sees of the surface placed at a single pose of space."""
        points = pose.apply(self.vertices)
        corners = points[self.triangles]
        front = _normals(corners) @ camera.towards > EDGE_ON
        one, other = self.neighbours.T
        outline = front[one] != front[other]
        drawn = (front[one] | front[other]) & (self.sharp | outline)
        return Seen(corners[front].reshape(-1, 3), points[self.edges[drawn]])


def _normals(corners: Array) -> Array:
    """Unit normals (m, 3) of triangles (m, 3, 3)."""
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return np.asarray(normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300))


@dataclass(frozen=True, eq=False)
class Seen:
    """What faces the viewer: corners (k, 3) of triangles, and edges (e, 2, 3)."""

    corners: Array
    edges: Array


def cut_edges(edges: Array, size: float) -> Array:
    """Halve edges (e, 2, 3) until none is longer than ``size``."""
    done = [np.empty((0, 2, 3))]
    while len(edges):
        small = np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1) <= size
        done.append(edges[small])
        a, b = edges[~small, 0], edges[~small, 1]
        middle = 0.5 * (a + b)
        edges = np.concatenate([np.stack([a, middle], axis=1), np.stack([middle, b], axis=1)])
    return np.concatenate(done)
