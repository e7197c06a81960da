"""Pictures of a decomposition: the mesh beside its pieces, and how far these stand out."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize, to_rgb
from matplotlib.figure import Figure

from berthing.geometry.arrays import Array
from berthing.geometry.capability import mesh
from berthing.mesh.piece import Piece
from berthing.mesh.protrusion import protrusion
from berthing.mesh.solid import Surface
from berthing.mesh.tessellate import cut_triangles
from berthing.report.camera import Camera
from berthing.report.frame3d import Frame3d
from berthing.report.style import DPI, SERIES_COLOURS, STRUCTURE_COLOUR, TEXT, new_figure

CAMERA = Camera.at(-55.0, 28.0)
# Triangles are cut to this part of the picture, so that sorting them by depth shows what is in
# front.
CELL = 0.035
# Light from behind the viewer's left shoulder, and what is left of it in the shade.
LIGHT, SHADE = np.array([-0.35, -0.6, 0.72]), 0.55
COLOURS = "viridis"


def pieces_figure(surface: Surface, pieces: Sequence[Piece]) -> bytes:
    """A PNG: the mesh on the left, its pieces on the right."""
    figure = new_figure(11.0, 5.2)
    cell = CELL * surface.size
    frame = Frame3d.around(np.concatenate([surface.vertices, *_points(pieces)]))
    corners = cut_triangles(surface.corners, cell)[0]
    left, right = (figure.add_axes((0.01 + 0.5 * i, 0.01, 0.48, 0.9)) for i in range(2))
    count = len(surface.triangles)
    _draw(left, frame, corners, np.tile(to_rgb(STRUCTURE_COLOUR), (len(corners), 1)))
    left.set_title(f"mesh: {count:,} triangles", fontsize=10, color=TEXT)
    drawn = [cut_triangles(c, cell)[0] for c in _surfaces(pieces)]
    colours = [
        np.tile(to_rgb(SERIES_COLOURS[i % len(SERIES_COLOURS)]), (len(c), 1))
        for i, c in enumerate(drawn)
    ]
    _draw(right, frame, np.concatenate(drawn), np.concatenate(colours))
    noun = "piece" if len(pieces) == 1 else "pieces"
    right.set_title(f"{len(pieces)} convex {noun}", fontsize=10, color=TEXT)
    return _png(figure)


def protrusion_figure(surface: Surface, pieces: Sequence[Piece]) -> bytes:
    """A PNG: the pieces, coloured by their distance from the mesh."""
    figure = new_figure(7.6, 5.6)
    corners = np.concatenate([cut_triangles(c, CELL * surface.size)[0] for c in _surfaces(pieces)])
    distance_mm = 1e3 * protrusion(surface, corners.mean(axis=1))
    scale = Normalize(0.0, max(float(np.max(distance_mm)), 1e-6))
    mapping = ScalarMappable(scale, COLOURS)
    axes = figure.add_axes((0.01, 0.01, 0.84, 0.9))
    frame = Frame3d.around(corners.reshape(-1, 3))
    _draw(axes, frame, corners, np.asarray(mapping.to_rgba(distance_mm))[:, :3])
    axes.set_title("how far the pieces stand out of the mesh", fontsize=10, color=TEXT)
    bar = figure.colorbar(mapping, cax=figure.add_axes((0.87, 0.16, 0.025, 0.62)))
    bar.set_label("mm", fontsize=9, color=TEXT)
    bar.ax.tick_params(labelsize=8, colors=TEXT)
    return _png(figure)


def _surfaces(pieces: Sequence[Piece]) -> list[Array]:
    """Corners (k, 3, 3) of each piece's surface."""
    found = []
    for piece in pieces:
        drawn = mesh(piece.shape)
        found.append(piece.placement.apply(drawn.vertices)[drawn.triangles])
    return found


def _points(pieces: Sequence[Piece]) -> list[Array]:
    return [corners.reshape(-1, 3) for corners in _surfaces(pieces)]


def _draw(axes: Axes, frame: Frame3d, corners: Array, colours: Array) -> None:
    """Triangles (k, 3, 3) in colours (k, 3), shaded, the farthest first."""
    frame.draw(axes, CAMERA)
    a, b, c = np.moveaxis(corners, 1, 0)
    normal = np.cross(b - a, c - a)
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    front = np.flatnonzero(normal @ CAMERA.towards > 0.0)
    order = front[np.argsort(CAMERA.depth(corners[front].mean(axis=1)))]
    lit = np.clip(normal[order] @ (LIGHT / np.linalg.norm(LIGHT)), 0.0, 1.0)
    shaded = colours[order] * (SHADE + (1.0 - SHADE) * lit)[:, None]
    # An edge of the same colour hides the seams between triangles.
    axes.add_collection(
        PolyCollection(
            list(CAMERA.project(corners[order])),
            facecolors=shaded,
            edgecolors=shaded,
            linewidths=0.4,
            zorder=2,
        ),
        autolim=False,
    )


def _png(figure: Figure) -> bytes:
    stream = BytesIO()
    figure.savefig(stream, dpi=DPI, format="png")
    return stream.getvalue()
