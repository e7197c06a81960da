"""The figure of the clearance of each pair against its margin."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from berthing.report.clearance_curves import Curve
from berthing.report.style import MARGIN_COLOUR, SERIES_COLOURS, TEXT, dress, new_figure
from berthing.verify.verdict import PairVerdict

# Pairs drawn, the closest first; a legend of more cannot be read.
SHOWN = len(SERIES_COLOURS)
# The close-up ends at this many margins.
CLOSE_UP = 6.0


def draw_clearances(curves: list[Curve], verdicts: Sequence[PairVerdict]) -> Figure:
    """All of it on the left, and what happens near the margin on the right.

    Args:
        curves: of every phase and pair.
        verdicts: of the same, from the verification: the bounds proven.
    """
    by_pair: dict[str, list[Curve]] = {}
    for curve in curves:
        by_pair.setdefault(curve.pair, []).append(curve)
    shown = sorted(by_pair, key=lambda name: min(c.clearance_m.min() for c in by_pair[name]))
    figure = new_figure(12.6, 4.2)
    if not shown:
        figure.text(0.5, 0.5, "Nothing to keep clear of.", ha="center", color=TEXT)
        return figure
    whole, near = figure.subplots(1, 2)
    for axes in (whole, near):
        for rank, name in enumerate(shown[:SHOWN]):
            for curve in by_pair[name]:
                axes.plot(curve.times_s, curve.clearance_m, color=SERIES_COLOURS[rank], lw=1.5)
        _draw_margins(axes, curves)
        axes.margins(x=0.01)
    dress(whole, "Clearance of each pair [m]")
    dress(near, "The same near the margin [m]")
    _zoom(near, curves)
    _draw_proofs(near, dict(zip(shown, SERIES_COLOURS, strict=False)), verdicts)
    _caption(figure, shown)
    return figure


def _draw_margins(axes: Axes, curves: list[Curve]) -> None:
    for t0, t1, margin in {w for curve in curves for w in curve.windows}:
        if margin is not None:
            axes.plot([t0, t1], [margin, margin], color=MARGIN_COLOUR, ls="--", lw=1.1, zorder=1.5)


def _zoom(axes: Axes, curves: list[Curve]) -> None:
    margins = [w[2] for curve in curves for w in curve.windows if w[2] is not None]
    top = CLOSE_UP * max(margins, default=0.0) or 1.0
    lowest = min(float(np.min(curve.clearance_m)) for curve in curves)
    top = max(top, lowest + 0.5 * top)
    axes.set_ylim(min(0.0, 1.1 * lowest), top)


def _draw_proofs(axes: Axes, colours: dict[str, str], verdicts: Sequence[PairVerdict]) -> None:
    """A mark at the lowest bound of each pair, where it was proven."""
    for verdict in verdicts:
        if verdict.pair in colours and np.isfinite(verdict.lower_bound_m):
            axes.plot(
                verdict.time_s, verdict.lower_bound_m, "v", color=colours[verdict.pair], ms=6,
                mec="white", mew=0.6, clip_on=True,
            )  # fmt: skip


def _caption(figure: Figure, shown: list[str]) -> None:
    handles = [
        Line2D([], [], color=colour, lw=2, label=name.replace("|", " – "))
        for name, colour in zip(shown, SERIES_COLOURS, strict=False)
    ]
    handles.append(Line2D([], [], color=MARGIN_COLOUR, ls="--", label="margin"))
    handles.append(Line2D([], [], color=TEXT, marker="v", ls="", label="lowest proven bound"))
    if len(shown) > SHOWN:
        label = f"{len(shown) - SHOWN} more pairs are farther apart"
        handles.append(Line2D([], [], ls="", label=label))
    columns = min(len(handles), 4)
    rows = -(-len(handles) // columns)
    figure.legend(handles=handles, loc="upper center", ncols=columns, fontsize=8, frameon=False)
    height = figure.get_figheight()
    top = 1.0 - (0.35 + 0.19 * rows) / height
    figure.subplots_adjust(0.045, 0.42 / height, 0.99, top, 0.1)
