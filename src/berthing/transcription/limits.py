"""Limits on controls and states, put on the Bernstein coefficients of each segment.

A polynomial stays within the hull of its Bernstein coefficients, so the limits hold between the
nodes too and can be proven there. Coefficients lie further out than the polynomial does, which
costs a little where a limit is active; shorter segments shrink it. At high degrees they lie very
far out, and the map to them loses digits as 2^n: there the limits are put on the nodes, and what
the polynomial does between them is left to the check of the plan.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from berthing.geometry.arrays import Array
from berthing.transcription.elements import Index
from berthing.transcription.lagrange import to_bernstein
from berthing.transcription.layout import PhaseLayout, VehicleLayout
from berthing.transcription.limit_costates import LimitRows

HIGHEST_BERNSTEIN = 10
"""Degree. Coefficients are off the values by up to 2^10 roundings there, and a unit step of the
controls from one node to the next already throws them out by hundreds."""


def add_limits(layout: PhaseLayout) -> tuple[LimitRows, ...]:
    """Append the finite limits of every vehicle; an equal pair of bounds is an equality."""
    mesh, out = layout.mesh, list[LimitRows]()
    for owner in layout.vehicles.values():
        limits, model = owner.vehicle.limits, owner.vehicle.model
        zero = np.zeros(owner.nu)
        for k in range(mesh.segments):
            nodes = mesh.node_set(k)
            i, j = mesh.control_offset(k), mesh.point_offset(k)
            out += _add(
                layout, k, owner, model.control_names,
                owner.control.indices[:, i : i + len(nodes.collocated)], nodes.control_points,
                j + np.array(nodes.collocated),
                (limits.control_lower, limits.control_upper), (owner.scale.control, zero),
            )  # fmt: skip
            out += _add(
                layout, k, owner, model.state_names,
                owner.state.indices[:, j : j + len(nodes.points)], nodes.points,
                j + np.arange(len(nodes.points)),
                (limits.state_lower, limits.state_upper),
                (owner.scale.state, owner.scale.state_shift),
            )  # fmt: skip
    return tuple(out)


def _add(
    layout: PhaseLayout, k: int, owner: VehicleLayout, names: tuple[str, ...], columns: Index,
    points: Array, places: Index, bounds: tuple[Array, Array], scaling: tuple[Array, Array],
) -> list[LimitRows]:  # fmt: skip
    high = len(points) - 1 > HIGHEST_BERNSTEIN
    bernstein = np.eye(len(points)) if high else to_bernstein(points)
    (lower, upper), (scale, shift) = bounds, scaling
    time_s = layout.nominal_time(layout.mesh.breaks[k])
    out = []
    for c in np.flatnonzero(np.isfinite(lower) | np.isfinite(upper)):
        label = partial(_label, owner.vehicle.name, names[c], time_s)
        between = (lower[c] - shift[c]) / scale[c], (upper[c] - shift[c]) / scale[c]
        rows = layout.rows.add(len(points), *between, label)
        layout.elements.add_linear(rows[:, None], columns[c][None], bernstein)
        name = owner.vehicle.name
        out.append(LimitRows(name, names[c], float(scale[c]), places, rows, bernstein))
    return out


def _label(vehicle: str, name: str, time_s: float, _: int) -> str:
    return f"limit[{vehicle}, {name}, from t = {time_s:.1f} s]"
