"""Collects outlines and lines of space and paints them from far to near."""

from __future__ import annotations

from dataclasses import dataclass, field

from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb
from scipy.spatial import ConvexHull

from berthing.geometry.arrays import Array
from berthing.report.camera import Camera
from berthing.report.surface import Seen, cut_edges

# Lines lie this part of a cell nearer than they are, so that their own face does not cover them.
LINE_LIFT = 0.6
LINE_WIDTH = 0.8


@dataclass(frozen=True, eq=False)
class _Piece:
    corners: Array
    depth: float
    face: tuple[float, ...]
    line: tuple[float, ...]
    width: float


CLEAR = (0.0, 0.0, 0.0, 0.0)


@dataclass
class Painter:
    """Pieces of one picture.

    Attributes:
        camera: the view.
        cell_m: no line is longer, so that sorting by the middle's depth shows what is in front.
    """

    camera: Camera
    cell_m: float
    _pieces: list[_Piece] = field(default_factory=list)

    def surface(self, seen: Seen, colour: str, alpha: float, line: str, line_alpha: float) -> None:
        """Add a translucent convex surface: its outline filled, and the edges seen.

        The outline is one piece: triangles would show their seams.
        """
        if not len(seen.corners):
            return
        paper = self.camera.project(seen.corners)
        depth = float(self.camera.depth(seen.corners).mean())
        outline = paper[ConvexHull(paper).vertices]
        self._pieces.append(_Piece(outline, depth, (*to_rgb(colour), alpha), CLEAR, 0.0))
        self.lines(seen.edges, line, line_alpha, LINE_WIDTH)

    def lines(self, segments: Array, colour: str, alpha: float, width: float) -> None:
        """Add segments (e, 2, 3)."""
        pieces = cut_edges(segments, self.cell_m)
        depths = self.camera.depth(pieces.mean(axis=1)) + LINE_LIFT * self.cell_m
        line = (*to_rgb(colour), alpha)
        for corners, depth in zip(self.camera.project(pieces), depths, strict=True):
            self._pieces.append(_Piece(corners, float(depth), CLEAR, line, width))

    def paint(self, axes: Axes) -> None:
        """Put everything on the axes, the farthest first."""
        pieces = sorted(self._pieces, key=lambda piece: piece.depth)
        axes.add_collection(
            PolyCollection(
                [piece.corners for piece in pieces],
                facecolors=[piece.face for piece in pieces],
                edgecolors=[piece.line for piece in pieces],
                linewidths=[piece.width for piece in pieces],
                closed=False,
                zorder=2,
            ),
            autolim=False,
        )
