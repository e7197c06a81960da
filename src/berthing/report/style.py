"""Colours and sizes of the figures, and the canvas they are drawn on."""

from __future__ import annotations

from pathlib import Path

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.transforms import ScaledTranslation

DPI = 110
# Height of the label below its axis, in inches.
LABEL_DROP_IN = -0.24
# zlib's level: level 6 takes three times as long for a fifth less.
PNG_COMPRESSION = 2
TEXT, GRID, MUTED = "#263238", "#dfe4e8", "#8a97a0"
MARGIN_COLOUR = "#c62828"
STRUCTURE_COLOUR = "#b9c2c9"
# One for each vehicle, in the order of the scenario; distinct for colour-blind readers too.
VEHICLE_COLOURS = ("#1565c0", "#e67700", "#00897b", "#8e24aa", "#5d4037", "#ad1457")
VEHICLE_DASHES = ("-", "--", ":", "-.")
# One for each component: x, y, z and, for quaternions, w.
COMPONENT_COLOURS = {"x": "#d1495b", "y": "#2e8b57", "z": "#2a6fbb", "w": "#6b7780"}
SERIES_COLOURS = (
    "#2a6fbb", "#d1495b", "#2e8b57", "#e08a1e", "#7b4fb5",
    "#1b9aaa", "#8c5a3c", "#c2478f", "#6b7780", "#93a23b",
)  # fmt: skip


def new_figure(width_in: float, height_in: float) -> Figure:
    """An empty figure on an Agg canvas; no display and no global state are involved."""
    figure = Figure(figsize=(width_in, height_in), dpi=DPI, facecolor="white")
    FigureCanvasAgg(figure)
    return figure


def dress(axes: Axes, title: str, xlabel: str = "time [s]") -> None:
    """Give axes the look that all plots share; the title holds the unit.

    Title and label are put where they belong rather than left to be laid out, which would take a
    third of the time of drawing.
    """
    axes.set_title(title, fontsize=10, color=TEXT, loc="left", y=1.015)
    if xlabel:
        below = ScaledTranslation(0.0, LABEL_DROP_IN, axes.figure.dpi_scale_trans)
        axes.xaxis.set_label_coords(0.5, 0.0, transform=axes.transAxes + below)
        axes.set_xlabel(xlabel, fontsize=9, color=TEXT)
    axes.locator_params(axis="x", nbins=7)
    axes.locator_params(axis="y", nbins=6)
    axes.tick_params(labelsize=8, colors=TEXT, length=3)
    axes.grid(True, color=GRID, linewidth=0.7)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color(MUTED)


def legend(axes: Axes, columns: int) -> None:
    """A legend above the axes, on the right, in line with the title."""
    axes.legend(
        fontsize=8, ncols=columns, loc="lower right", bbox_to_anchor=(1.0, 1.0), frameon=False,
        borderpad=0.0, borderaxespad=0.3,
    )  # fmt: skip


def save(figure: Figure, path: Path) -> None:
    """Write a PNG."""
    figure.savefig(path, dpi=DPI, pil_kwargs={"compress_level": PNG_COMPRESSION})
