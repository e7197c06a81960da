"""The figure of position, velocity, attitude and rates over time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from berthing.geometry.arrays import Array
from berthing.report.style import COMPONENT_COLOURS, TEXT, dress, new_figure
from berthing.report.track import Motion, Track, same_sign
from berthing.verify.verification import Verification


@dataclass(frozen=True)
class _Panel:
    title: str
    components: str
    columns: Callable[[Motion], Array]


TRANSLATION = (
    _Panel("Position, inertial [m]", "xyz", lambda m: m.pose.position),
    _Panel("Velocity, inertial [m/s]", "xyz", lambda m: m.velocity_m_s),
)
ROTATION = (
    _Panel("Attitude q_IB", "wxyz", lambda m: m.q_IB),
    _Panel("Rates, body axes [rad/s]", "xyz", lambda m: m.rate_rad_s),
)

COLUMNS = 2
# Height of a row of panels, and of what is above and below them, in inches.
ROW_IN, HEAD_IN = 2.9, 0.7


def draw_states(tracks: list[Track], verification: Verification) -> Figure:
    """Motion as a line, the solver's nodes on it as circles; a row of panels more if any turns.

    The line is the interpolant; how near the replay of the controls stays to it is written above,
    and is far less than a line's width on a sound plan.
    """
    panels = TRANSLATION + (ROTATION if any(_turns(track) for track in tracks) else ())
    rows = len(panels) // COLUMNS
    height = HEAD_IN + rows * ROW_IN
    figure = new_figure(12.6, height)
    grid = figure.subplots(rows, COLUMNS, sharex=True, squeeze=False)
    for i, (axes, panel) in enumerate(zip(grid.flat, panels, strict=True)):
        for track in tracks:
            _draw_panel(axes, panel, track)
        dress(axes, panel.title, "time [s]" if i >= len(panels) - COLUMNS else "")
        axes.margins(x=0.01)
    figure.subplots_adjust(0.045, 0.42 / height, 0.99, 1.0 - 0.62 / height, 0.11, 0.20)
    figure.text(0.012, 1.0 - 0.22 / height, _replay(verification), fontsize=9, color=TEXT)
    _caption(figure, tracks)
    return figure


def _replay(v: Verification) -> str:
    if not v.replays:
        return "Not replayed."
    position, attitude = v.replay_position_error_m, v.replay_attitude_error_rad
    return f"Replay of the controls: within {position:.1e} m and {attitude:.1e} rad of these lines."


def _turns(track: Track) -> bool:
    return any("rad_s" in name for name in track.vehicle.model.state_names)


def _draw_panel(axes: Axes, panel: _Panel, track: Track) -> None:
    lines, nodes = panel.columns(track.dense), panel.columns(track.nodes)
    if panel.components == "wxyz":
        nodes = same_sign(track.nodes, track.dense)
    for i, component in enumerate(panel.components[: lines.shape[1]]):
        colour = COMPONENT_COLOURS[component]
        axes.plot(track.dense.times_s, lines[:, i], color=colour, ls=track.dash, lw=1.4)
        axes.plot(track.nodes.times_s, nodes[:, i], "o", color=colour, ms=3.2, mfc="white", mew=0.8)


def _caption(figure: Figure, tracks: list[Track]) -> None:
    parts = sorted(COMPONENT_COLOURS.items(), key=lambda item: "wxyz".index(item[0]))
    if not any(_turns(track) for track in tracks):
        parts = parts[1 : 1 + tracks[0].vehicle.dim]
    handles = [Line2D([], [], color=colour, lw=2, label=name) for name, colour in parts]
    dashes = {track.vehicle.name: track.dash for track in tracks}
    if len(dashes) > 1:
        handles += [Line2D([], [], color=TEXT, ls=d, label=name) for name, d in dashes.items()]
    handles.append(Line2D([], [], color=TEXT, marker="o", mfc="white", ms=4, ls="", label="node"))
    figure.legend(handles=handles, loc="upper right", ncols=len(handles), fontsize=8, frameon=False)
