"""The paper's figures that are about no plan: the error of smoothed squares, the spacecraft."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Polygon
from scipy.spatial import ConvexHull

from berthing.geometry.arrays import Array
from berthing.geometry.capability import mesh
from berthing.report.style import (
    COMPONENT_COLOURS,
    MARGIN_COLOUR,
    MUTED,
    SERIES_COLOURS,
    STRUCTURE_COLOUR,
    TEXT,
    dress,
    legend,
    new_figure,
)
from berthing.reproduce.smoothing import CornerError, corner_error
from berthing.scenario.files import load
from berthing.scenario.rigid_body import RigidBody

FINE = np.geomspace(2.0, 128.0, 49)
ARM_M = 1.0
"""Length of the axes and arrows drawn."""


def draw_error() -> Figure:
    """By how much a square's corner recedes along its faces' normals: in metres and of its size."""
    found = corner_error(FINE)
    figure = new_figure(11.0, 4.2)
    left, right = figure.subplots(1, 2)
    panels = ((left, found.recession_m, "Recession of the corner [m]"),
              (right, found.relative, "The same over the half-size"))  # fmt: skip
    for axes, values, title in panels:
        _curves(axes, found, values)
        dress(axes, title, "exponent [1/m]")
        axes.locator_params(axis="y", nbins=6)
    left.plot(FINE, np.log(2.0) / FINE, color=MUTED, ls="--", lw=1.0, label="ln 2 / Q")
    legend(left, columns=2)
    figure.subplots_adjust(0.06, 0.13, 0.99, 0.80, 0.16)
    return figure


def _curves(axes: Axes, found: CornerError, values: Array) -> None:
    for i, half in enumerate(found.half_sizes_m):
        label = f"square of {2 * half:g} m"
        axes.plot(found.exponents, values[:, i], color=SERIES_COLOURS[i], lw=1.4, label=label)


def draw_spacecraft(case: str = "offset-mass-wrench") -> Figure:
    """The robotic spacecraft from above: frames, centre of mass, and a manipulator's wrench.

    It is that of a case that ships with a first moment of mass and a wrench.
    """
    craft = load(case).phases[0].vehicles[0]
    model = craft.model
    assert isinstance(model, RigidBody)
    figure = new_figure(6.4, 4.4)
    axes = figure.add_axes((0.02, 0.02, 0.96, 0.9))
    axes.set_aspect("equal")
    axes.set_axis_off()
    for part in craft.body.parts:
        corners = part.placement.apply(mesh(part.shape).vertices)[:, :2]
        outline = corners[ConvexHull(corners).vertices]
        axes.add_patch(Polygon(outline, fc=STRUCTURE_COLOUR, ec=TEXT, alpha=0.6))
    inertial = np.array([-4.0, -2.2])
    for origin, name in ((inertial, r"$\mathcal{F}_I$"), (np.zeros(2), r"$\mathcal{F}_s$")):
        _arrow(axes, origin, np.array([ARM_M, 0.0]), COMPONENT_COLOURS["x"], "")
        _arrow(axes, origin, np.array([0.0, ARM_M]), COMPONENT_COLOURS["y"], name)
    _arrow(axes, inertial, -inertial, MUTED, r"$r^s$")
    centre = model.first_moment_kg_m[:2] / model.mass_kg
    axes.plot(*centre, "k+", ms=10)
    axes.annotate(r"$c_{t,s}/m_t$", _pair(centre), (4, -14), textcoords="offset points", color=TEXT)
    for wrench in model.wrenches:
        _wrench(axes, wrench.point_m[:2], wrench.force_n[np.argmax(np.abs(wrench.force_n).sum(1))])
    axes.set_title("Robotic spacecraft", fontsize=10, color=TEXT, loc="left")
    axes.autoscale_view()
    axes.margins(0.08)
    return figure


def _wrench(axes: Axes, point_m: Array, force_n: Array) -> None:
    """ρ from the reference point to where it acts, and f there, a unit long."""
    _arrow(axes, np.zeros(2), point_m, TEXT, r"$\rho^{m_i}_s$")
    push = force_n[:2] / max(float(np.linalg.norm(force_n[:2])), 1e-12)
    _arrow(axes, point_m, ARM_M * push, MARGIN_COLOUR, r"$f^{m_i}_s, g^{m_i}_s$")


def _arrow(axes: Axes, start: Array, along: Array, colour: str, name: str) -> None:
    axes.annotate(
        "",
        _pair(start + along),
        _pair(start),
        arrowprops={"arrowstyle": "->", "color": colour, "lw": 1.6},
    )
    axes.plot(*np.stack([start, start + along]).T, alpha=0.0)
    axes.annotate(name, _pair(start + along), (5, 4), textcoords="offset points", color=colour)


def _pair(point: Array) -> tuple[float, float]:
    return float(point[0]), float(point[1])
