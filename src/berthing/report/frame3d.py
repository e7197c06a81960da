"""The box around a scene: its far walls with a grid, and numbers along three of its edges."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.ticker import MaxNLocator

from berthing.geometry.arrays import Array
from berthing.report.camera import Camera
from berthing.report.style import GRID, MUTED, TEXT

AXIS_NAMES = ("x", "y", "z")
# Room around the scene, and for the numbers, in parts of its diagonal.
PADDING, TICK_GAP, LABEL_GAP = 0.03, 0.022, 0.085
WALL_COLOUR = "#f7f9fa"


@dataclass(frozen=True, eq=False)
class Frame3d:
    """An axis-parallel box from ``lower`` (3,) to ``upper`` (3,), in metres."""

    lower: Array
    upper: Array

    @staticmethod
    def around(points: Array) -> Frame3d:
        """A little larger than the points (k, 3); never flat."""
        lower, upper = points.min(axis=0), points.max(axis=0)
        size = float(np.linalg.norm(upper - lower)) or 1.0
        room = np.maximum(PADDING * size, 0.5 * (0.15 * size - (upper - lower)))
        return Frame3d(lower - room, upper + room)

    @property
    def diagonal(self) -> float:
        """Its length in metres."""
        return float(np.linalg.norm(self.upper - self.lower))

    def draw(self, axes: Axes, camera: Camera) -> None:
        """Draw walls, grid and numbers, and fit the axes to them."""
        ticks = [self._ticks(axis) for axis in range(3)]
        for axis in range(3):
            self._wall(axes, camera, axis, ticks)
        for axis in range(3):
            self._numbers(axes, camera, axis, ticks[axis])
        corners = camera.project(self._corners())
        room = LABEL_GAP * self.diagonal
        low = corners.min(axis=0) - np.array([1.5, 1.25]) * room
        high = corners.max(axis=0) + 0.3 * room
        axes.set_xlim(low[0], high[0])
        axes.set_ylim(low[1], high[1])
        axes.set_aspect("equal")
        axes.set_axis_off()

    def _ticks(self, axis: int) -> Array:
        low, high = float(self.lower[axis]), float(self.upper[axis])
        share = (high - low) / float(np.max(self.upper - self.lower))
        ticks = MaxNLocator(nbins=max(2, round(7 * share)), steps=[1, 2, 5, 10])
        values = np.asarray(ticks.tick_values(low, high), dtype=np.float64)
        return values[(values >= low) & (values <= high)]

    def _corners(self) -> Array:
        bounds = np.stack([self.lower, self.upper])
        pick = np.array([[i >> 2 & 1, i >> 1 & 1, i & 1] for i in range(8)])
        return np.stack([bounds[pick[:, axis], axis] for axis in range(3)], axis=1)

    def _far(self, camera: Camera) -> Array:
        """The corner (3,) away from the viewer: every wall through it lies behind the scene."""
        return np.where(camera.towards > 0.0, self.lower, self.upper)

    def _wall(self, axes: Axes, camera: Camera, normal: int, ticks: list[Array]) -> None:
        one, other = (axis for axis in range(3) if axis != normal)
        far = self._far(camera)
        corners = np.tile(far, (4, 1))
        corners[:, one] = np.array([self.lower, self.upper, self.upper, self.lower])[:, one]
        corners[:, other] = np.array([self.lower, self.lower, self.upper, self.upper])[:, other]
        wall = PolyCollection([camera.project(corners)], facecolors=WALL_COLOUR, zorder=0)
        wall.set(edgecolor=MUTED, linewidth=0.6)
        axes.add_collection(wall, autolim=False)
        lines = []
        for along, across in ((one, other), (other, one)):
            for value in ticks[along]:
                ends = np.tile(far, (2, 1))
                ends[:, along] = value
                ends[:, across] = self.lower[across], self.upper[across]
                lines.append(camera.project(ends))
        axes.add_collection(LineCollection(lines, colors=GRID, linewidths=0.6, zorder=0.5), False)

    def _numbers(self, axes: Axes, camera: Camera, axis: int, ticks: Array) -> None:
        base, outward = self._edge(camera, axis)
        for value in ticks:
            at = base.copy()
            at[axis] = value
            x, y = camera.project(at) + TICK_GAP * self.diagonal * outward
            axes.text(x, y, f"{value:g}", fontsize=7, color=TEXT, ha="center", va="center")
        middle = base.copy()
        middle[axis] = 0.5 * (self.lower[axis] + self.upper[axis])
        x, y = camera.project(middle) + LABEL_GAP * self.diagonal * outward
        name = f"{AXIS_NAMES[axis]} [m]"
        axes.text(x, y, name, fontsize=8, color=TEXT, ha="center", va="center")

    def _edge(self, camera: Camera, axis: int) -> tuple[Array, Array]:
        """A point of the edge that carries the numbers, and the way out of the picture (2,).

        Of the edges in this direction: the outline has two; floor edges at the bottom, the
        upright one at the left.
        """
        corners = self._corners()
        flat = camera.project(corners)
        centre = flat.mean(axis=0)
        direction = camera.project(np.eye(3)[axis])
        normal = np.array([-direction[1], direction[0]])
        length = float(np.linalg.norm(normal))
        normal = normal / length if length > 0.0 else np.array([-1.0, 0.0])
        wanted = np.array([-1.0, -0.01]) if axis == 2 else np.array([0.01, -1.0])
        outward = normal if normal @ wanted > 0.0 else -normal
        return corners[int(np.argmax((flat - centre) @ outward))].copy(), outward
