"""The figure of the controls against their limits."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from berthing.report.style import (
    COMPONENT_COLOURS,
    MARGIN_COLOUR,
    SERIES_COLOURS,
    TEXT,
    dress,
    legend,
    new_figure,
)
from berthing.report.track import Track
from berthing.scenario.vehicle import Vehicle

# The last part of a column's name tells its unit, and so which controls share a panel.
UNITS = {"n": ("Force", "N"), "nm": ("Torque", "N·m")}


@dataclass(frozen=True)
class Panel:
    """Controls of one unit: a title, the unit, and their places among the controls."""

    title: str
    unit: str
    columns: list[int]


def draw_controls(tracks: list[Track]) -> Figure:
    """One row for each vehicle, one panel for each unit of its controls; limits are dashed."""
    by_vehicle: dict[str, list[Track]] = {}
    for track in tracks:
        by_vehicle.setdefault(track.vehicle.name, []).append(track)
    panels = {name: control_panels(found[0].vehicle) for name, found in by_vehicle.items()}
    rows, columns = len(panels), max(len(p) for p in panels.values())
    height = 0.45 + 2.9 * rows
    figure = new_figure(12.6 if columns > 1 else 8.6, height)
    grid = figure.subplots(rows, columns, sharex=True, squeeze=False)
    rows_of_axes = list(grid)
    for row, (name, found) in zip(rows_of_axes, by_vehicle.items(), strict=True):
        for axes in row[len(panels[name]) :]:
            axes.set_axis_off()
        for axes, panel in zip(row, panels[name], strict=False):
            title = f"{panel.title}, {name}" if rows > 1 else panel.title
            _draw_panel(axes, panel, found)
            last = row is rows_of_axes[-1]
            dress(axes, f"{title} [{panel.unit}]", "time [s]" if last else "")
            axes.margins(x=0.01, y=0.08)
            legend(axes, columns=len(panel.columns))
    figure.subplots_adjust(0.055, 0.42 / height, 0.99, 1.0 - 0.35 / height, 0.13, 0.2)
    return figure


def control_panels(vehicle: Vehicle) -> list[Panel]:
    """The controls of a vehicle by unit, in the order of the model."""
    units: dict[str, list[int]] = {}
    for i, name in enumerate(vehicle.model.control_names):
        units.setdefault(name.rsplit("_", 1)[-1], []).append(i)
    return [Panel(*UNITS.get(unit, ("Control", unit)), columns) for unit, columns in units.items()]


def _draw_panel(axes: Axes, panel: Panel, tracks: list[Track]) -> None:
    for rank, column in enumerate(panel.columns):
        name = tracks[0].vehicle.model.control_names[column].rsplit("_", 1)[0]
        colour = COMPONENT_COLOURS.get(name[-1], SERIES_COLOURS[rank % len(SERIES_COLOURS)])
        for i, track in enumerate(tracks):
            label = name if i == 0 else None
            dense, nodes = track.dense, track.nodes
            axes.plot(dense.times_s, dense.control[:, column], color=colour, lw=1.3, label=label)
            axes.plot(
                nodes.times_s, nodes.control[:, column], "o", color=colour, ms=3.0, mfc="white",
                mew=0.8,
            )  # fmt: skip
    limits = {
        (float(bounds[column]), track.phase)
        for track in tracks
        for column in panel.columns
        for bounds in (track.vehicle.limits.control_lower, track.vehicle.limits.control_upper)
    }
    for value in sorted({v for v, _ in limits if np.isfinite(v)}):
        axes.axhline(value, color=MARGIN_COLOUR, ls="--", lw=1.0)
    if not any(np.isfinite(v) for v, _ in limits):
        axes.text(
            0.01, 0.97, "no limit", transform=axes.transAxes, fontsize=8, color=TEXT, va="top"
        )
