"""The figure of the lower Hamiltonian at the nodes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from berthing.geometry.arrays import Array
from berthing.report.style import MUTED, SERIES_COLOURS, TEXT, dress, new_figure

LEAST_SHARE = 0.1


def draw_hamiltonian(series: Sequence[tuple[str, Array, Array]]) -> Figure:
    """H over time; constant on an optimal trajectory where nothing depends on time.

    Args:
        series: for each phase its name, times (k,) in s and values (k,), from the verification.
    """
    figure = new_figure(8.6, 3.6)
    axes = figure.add_axes((0.11, 0.14, 0.87, 0.74))
    dress(axes, "Lower Hamiltonian at the nodes [cost/s]")
    axes.margins(x=0.01)
    shown: list[Array] = []
    for rank, (_, times, values) in enumerate(series):
        known = np.isfinite(values)
        if np.any(known):
            colour = SERIES_COLOURS[rank % len(SERIES_COLOURS)]
            axes.plot(times[known], values[known], "o-", color=colour, ms=3.2, mfc="white", lw=1.0)
            axes.axhline(float(np.mean(values[known])), color=MUTED, ls="--", lw=0.9)
            shown.append(values[known])
    if shown:
        _widen(axes, np.concatenate(shown))
    else:
        axes.text(
            0.5, 0.5, "The scheme gives no costates.", transform=axes.transAxes, ha="center",
            color=TEXT,
        )  # fmt: skip
    return figure


def _widen(axes: Axes, values: Array) -> None:
    """Show at least ``LEAST_SHARE`` of the mean either way, so that a constant looks constant."""
    mean = float(np.mean(values))
    reach = max(1.1 * float(np.max(np.abs(values - mean))), LEAST_SHARE * abs(mean))
    if reach > 0.0:
        axes.set_ylim(mean - reach, mean + reach)
