"""The figure of a plan in space: structures, trails, and hulls at several times."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from berthing.geometry.arrays import Array
from berthing.report.camera import Camera
from berthing.report.frame3d import Frame3d
from berthing.report.painter import Painter
from berthing.report.placed import Placed, placed_parts
from berthing.report.space import in_space
from berthing.report.style import MUTED, STRUCTURE_COLOUR, TEXT, dress, new_figure
from berthing.report.track import Track
from berthing.scenario.scenario import Scenario

# The longest piece of a picture in parts of its diagonal.
CELL = 1.0 / 18.0
VIEWS = ((-62.0, 22.0), (-112.0, 52.0))
FROM_ABOVE = Camera(np.array([1.0, 0, 0]), np.array([0, 1.0, 0]), np.array([0, 0, 1.0]))
TRAIL_POINTS = 160


def draw_scene(scenario: Scenario, tracks: list[Track]) -> Figure:
    """Two views of a plan in space; one, from above, of a plan in the plane."""
    placed = placed_parts(scenario, tracks)
    trails = [_trail(track) for track in tracks]
    frame = Frame3d.around(np.concatenate([*trails, *(p.points for p in placed)]))
    if scenario.dim == 2:
        figure = new_figure(8.6, 6.4)
        axes = figure.add_axes((0.08, 0.09, 0.89, 0.83))
        _draw_plane(axes, frame, placed, tracks, trails)
    else:
        figure = new_figure(12.6, 5.4)
        for i, view in enumerate(VIEWS):
            axes = figure.add_axes((0.5 * i, 0.0, 0.5, 0.93))
            _draw_space(axes, Camera.at(*view), frame, placed, tracks, trails)
    _caption(figure, scenario, tracks)
    return figure


def _draw_space(
    axes: Axes, camera: Camera, frame: Frame3d, placed: list[Placed], tracks: list[Track],
    trails: list[Array],
) -> None:  # fmt: skip
    frame.draw(axes, camera)
    painter = Painter(camera, CELL * frame.diagonal)
    for track, trail in zip(tracks, trails, strict=True):
        shadow = trail.copy()
        shadow[:, 2] = frame.lower[2]
        if camera.towards[2] > 0.0:
            axes.plot(*camera.project(shadow).T, color=MUTED, lw=1.0, ls=":", zorder=1)
        painter.lines(np.stack([trail[:-1], trail[1:]], axis=1), track.colour, 1.0, 2.0)
    _paint(axes, camera, painter, placed, trails, tracks)


def _draw_plane(
    axes: Axes, frame: Frame3d, placed: list[Placed], tracks: list[Track], trails: list[Array]
) -> None:
    dress(axes, "y [m]", "x [m]")
    axes.set_xlim(frame.lower[0], frame.upper[0])
    axes.set_ylim(frame.lower[1], frame.upper[1])
    axes.set_aspect("equal", adjustable="box")
    painter = Painter(FROM_ABOVE, 2.0 * frame.diagonal)
    _paint(axes, FROM_ABOVE, painter, placed, trails, tracks)
    for track, trail in zip(tracks, trails, strict=True):
        axes.plot(trail[:, 0], trail[:, 1], color=track.colour, lw=1.8, zorder=3)


def _paint(
    axes: Axes, camera: Camera, painter: Painter, placed: list[Placed], trails: list[Array],
    tracks: list[Track],
) -> None:  # fmt: skip
    for p in placed:
        painter.surface(p.surface.seen(p.pose, camera), p.colour, p.alpha, p.line, p.line_alpha)
    painter.paint(axes)
    for track, trail in zip(tracks, trails, strict=True):
        ends = camera.project(trail[[0, -1]])
        for (x, y), fill in zip(ends, ("white", track.colour), strict=True):
            axes.plot(x, y, "o", mfc=fill, mec=track.colour, ms=6, zorder=4)


def _trail(track: Track) -> Array:
    """Points (k, 3) of the reference point's way."""
    chosen = np.linspace(0, len(track.dense.times_s) - 1, TRAIL_POINTS).astype(int)
    return in_space(track.dense.pose[chosen]).position


def _caption(figure: Figure, scenario: Scenario, tracks: list[Track]) -> None:
    """The name, and which colour is whose."""
    figure.text(0.012, 0.955, scenario.name, fontsize=12, color=TEXT, weight="bold")
    colours = {track.vehicle.name: track.colour for track in tracks}
    handles = [Line2D([], [], color=c, lw=2, label=name) for name, c in colours.items()]
    handles += [
        Line2D([], [], color=TEXT, marker="o", ls="", mfc="white", label="start"),
        Line2D([], [], color=TEXT, marker="o", ls="", label="end"),
    ]
    if scenario.structures:
        handles.append(Line2D([], [], color=STRUCTURE_COLOUR, lw=6, label="structure"))
    figure.legend(handles=handles, loc="upper right", ncols=len(handles), fontsize=8, frameon=False)
