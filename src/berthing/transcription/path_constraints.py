"""The user's g(t, x, u) ≤ 0 at the nodes, and at the ends of segments that have no node there.

Where g does not depend on the control it is asked once at every point of the state; asked of both
segments that share the point it would make two equal rows. Elsewhere it is asked at the collocated
nodes, and at a segment's end with the control that its polynomial has there.

Between the nodes a row that acts bulges above what it is at them. As clearance is planned with a
back-off, so rows are asked to lie below zero by a share of their tolerance, except at the two ends
of the phase: there the scenario may fix a state that lies on zero exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import casadi as ca
import numpy as np

from berthing.dynamics.casadi_xp import CASADI
from berthing.scenario.path_constraint import PathConstraint
from berthing.sym import Sym
from berthing.transcription.elements import Index
from berthing.transcription.inputs import Inputs
from berthing.transcription.lagrange import interpolation_matrix
from berthing.transcription.layout import PhaseLayout, VehicleLayout
from berthing.transcription.limit_costates import PathRows
from berthing.transcription.nodes import collocated, declare_node, node_values

BACKOFF = 1.0
"""Of a constraint's tolerance: how far below zero its rows are asked to be. Together with the
tolerance itself a row may bulge by two of them between the nodes."""


def add_path_constraints(layout: PhaseLayout) -> tuple[PathRows, ...]:
    """Append the rows of every vehicle's constraints, each divided by its scale."""
    out: list[PathRows] = []
    for owner in layout.vehicles.values():
        for constraint in owner.vehicle.path_constraints:
            if _needs_control(owner, constraint):
                out.append(_at_nodes(layout, owner, constraint))
                out += _at_ends(layout, owner, constraint)
            else:
                out.append(_at_points(layout, owner, constraint))
    return tuple(out)


def _needs_control(owner: VehicleLayout, constraint: PathConstraint) -> bool:
    t, x, u = ca.SX.sym("t"), ca.SX.sym("x", owner.nx), ca.SX.sym("u", owner.nu)
    g = constraint.function(t, x, u, CASADI)
    return bool(np.any(ca.which_depends(ca.SX(g), u, 1, False)))


def _at_nodes(layout: PhaseLayout, owner: VehicleLayout, constraint: PathConstraint) -> PathRows:
    inputs = Inputs()
    node = declare_node(layout, owner, inputs)
    g = constraint.function(node.t, node.x, node.u, CASADI)
    values = node_values(layout, owner)
    points, fractions = collocated(layout)
    rows = _rows(layout, owner, constraint, g, fractions)
    inputs.add(layout.elements, inputs.kernel(g / constraint.scale), values, rows)
    return _record(owner, constraint, points, rows)


def _at_points(layout: PhaseLayout, owner: VehicleLayout, constraint: PathConstraint) -> PathRows:
    inputs = Inputs()
    x = owner.declare_state(inputs, "x")
    t = layout.t0_s + layout.declare_duration(inputs) * inputs.constant("fraction")
    g = constraint.function(t, x, ca.SX.zeros(owner.nu), CASADI)
    fractions = layout.mesh.point_fractions()
    rows = _rows(layout, owner, constraint, g, fractions.tolist())
    values = layout.shared_indices(len(fractions)) | {
        "x": owner.state.indices.T, "fraction": fractions,
    }  # fmt: skip
    inputs.add(layout.elements, inputs.kernel(g / constraint.scale), values, rows)
    return _record(owner, constraint, range(len(fractions)), rows)


def _at_ends(
    layout: PhaseLayout, owner: VehicleLayout, constraint: PathConstraint
) -> list[PathRows]:
    """One row block a segment whose last point is not collocated."""
    mesh, out = layout.mesh, []
    for k in range(mesh.segments):
        nodes = mesh.node_set(k)
        if len(nodes.points) - 1 in nodes.collocated:
            continue
        inputs = Inputs()
        x = owner.declare_state(inputs, "x")
        weights = interpolation_matrix(nodes.control_points, np.ones(1))[0]
        names = [f"u{j}" for j in range(len(weights))]
        controls = [inputs.variable(name, owner.nu, owner.scale.control) for name in names]
        u: Sym = ca.mtimes(ca.horzcat(*controls), ca.DM(weights))
        fraction = mesh.breaks[k + 1]
        t = layout.t0_s + layout.declare_duration(inputs) * fraction
        g = constraint.function(t, x, u, CASADI)
        first = mesh.control_offset(k)
        columns = {name: owner.control.indices[:, first + j] for j, name in enumerate(names)}
        values = layout.shared_indices(1) | columns
        last = mesh.point_offset(k) + len(nodes.points) - 1
        values["x"] = owner.state.indices[:, last]
        rows = _rows(layout, owner, constraint, g, [fraction])
        inputs.add(layout.elements, inputs.kernel(g / constraint.scale), values, rows)
        out.append(_record(owner, constraint, [last], rows))
    return out


def _record(
    owner: VehicleLayout, constraint: PathConstraint, points: Sequence[int], rows: Index
) -> PathRows:
    name = owner.vehicle.name
    return PathRows(name, constraint.name, constraint.scale, np.array(points), rows)


def _rows(
    layout: PhaseLayout,
    owner: VehicleLayout,
    constraint: PathConstraint,
    g: Sym,
    fractions: Sequence[float],
) -> Index:
    """Rows (n, m), at n fractions of the phase; below zero by the back-off except at its ends."""
    m = g.numel()
    backoff = BACKOFF * constraint.tolerance / constraint.scale
    upper = [0.0 if fraction in (0.0, 1.0) else -backoff for fraction in fractions]
    times = [layout.nominal_time(fraction) for fraction in fractions]
    label = partial(_label, owner.vehicle.name, constraint.name, m, times)
    rows = layout.rows.add(
        m * len(times), -np.inf, np.repeat(upper, m), label, unit_scale=constraint.scale
    )
    return rows.reshape(len(times), m)


def _label(vehicle: str, name: str, m: int, times: Sequence[float], j: int) -> str:
    which = f"{name} {j % m}" if m > 1 else name
    return f"path[{vehicle}, {which}, t = {times[j // m]:.1f} s]"
