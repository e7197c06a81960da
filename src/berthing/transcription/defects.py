"""Dynamics and cost at the collocated nodes: D X = (h/2) f(X, U, t), J ≈ Σ (h/2) w L."""

from __future__ import annotations

from functools import partial

import casadi as ca
import numpy as np

from berthing.dynamics.casadi_xp import CASADI
from berthing.dynamics.models import symbolic
from berthing.geometry.arrays import Array
from berthing.scenario.cost import RunningCost
from berthing.transcription.elements import Index, Kernel
from berthing.transcription.inputs import Inputs
from berthing.transcription.layout import PhaseLayout, VehicleLayout
from berthing.transcription.nodes import declare_node, node_values
from berthing.transcription.norm_slack import NormSlack


def add_defects(layout: PhaseLayout) -> dict[str, list[Index]]:
    """Append the defects of every vehicle.

    Each is divided by the scale of its state, so that a multiplier over that scale is a costate.

    Returns:
        For each vehicle the rows (collocated nodes, nx) of each segment.
    """
    return {name: _vehicle(layout, owner) for name, owner in layout.vehicles.items()}


def _vehicle(layout: PhaseLayout, owner: VehicleLayout) -> list[Index]:
    slack = NormSlack.add(layout, owner)
    inputs, kernel = _dynamics_kernel(layout, owner, slack)
    mesh, blocks = layout.mesh, []
    states, controls, widths, fractions = [], [], [], []
    for k in range(mesh.segments):
        nodes = mesh.node_set(k)
        columns = owner.state.indices[:, mesh.point_offset(k) :][:, : len(nodes.points)]
        fraction = [mesh.fraction(k, float(nodes.points[c])) for c in nodes.collocated]
        rows = layout.rows.add(
            len(fraction) * owner.nx, 0.0, 0.0, partial(_label, layout, owner, fraction)
        ).reshape(len(fraction), owner.nx)
        # The shift drops out of D X, a constant having no slope.
        layout.elements.add_linear(rows[:, None, :], columns.T[None], nodes.D[:, :, None])
        states.append(columns[:, list(nodes.collocated)].T)
        first = mesh.control_offset(k)
        controls.append(owner.control.indices[:, first : first + len(fraction)].T)
        widths += [mesh.breaks[k + 1] - mesh.breaks[k]] * len(fraction)
        fractions += fraction
        blocks.append(rows)
    values = layout.shared_indices(len(fractions)) | {
        "x": np.vstack(states), "u": np.vstack(controls), "width": widths, "fraction": fractions,
        **slack.values(layout),
    }  # fmt: skip
    inputs.add(layout.elements, kernel, values, np.vstack(blocks))
    return blocks


def _dynamics_kernel(
    layout: PhaseLayout, owner: VehicleLayout, slack: NormSlack
) -> tuple[Inputs, Kernel]:
    inputs = Inputs()
    x = owner.declare_state(inputs, "x")
    u = inputs.variable("u", owner.nu, owner.scale.control)
    duration = layout.declare_duration(inputs)
    width, fraction = inputs.constant("width"), inputs.constant("fraction")
    model = owner.vehicle.model
    f = symbolic(model).derivative(model, layout.t0_s + duration * fraction, x, u)
    defect = -0.5 * width * duration * f / ca.DM(owner.scale.state)
    return inputs, inputs.kernel(defect + slack.declare(inputs, x))


def add_cost(layout: PhaseLayout, cost_scale: float) -> None:
    """Add ∫ (control_energy ‖u‖² + time + Σ h) dt over ``cost_scale`` to the objective."""
    cost = layout.phase.cost
    weights = quadrature(layout)
    for owner in layout.vehicles.values():
        inputs = Inputs()
        u = inputs.variable("u", owner.nu, owner.scale.control)
        duration, weight = layout.declare_duration(inputs), inputs.constant("weight")
        energy = cost.control_energy * duration * weight * ca.sumsqr(u)
        kernel = inputs.kernel(ca.SX(0, 1), energy / cost_scale)
        values = layout.shared_indices(len(weights)) | {
            "u": owner.control.indices.T, "weight": weights,
        }  # fmt: skip
        inputs.add(layout.elements, kernel, values, np.empty((len(weights), 0)))
    for running in cost.running:
        _add_running(layout, layout.vehicles[running.vehicle], running, weights, cost_scale)
    inputs = Inputs()
    duration = layout.declare_duration(inputs)
    kernel = inputs.kernel(ca.SX(0, 1), cost.time * duration / cost_scale)
    inputs.add(layout.elements, kernel, layout.shared_indices(1), np.empty((1, 0)))


def _add_running(
    layout: PhaseLayout, owner: VehicleLayout, running: RunningCost, weights: Array, scale: float
) -> None:
    """Add ∫ h(t, x, u) dt, h the user's own."""
    inputs = Inputs()
    node = declare_node(layout, owner, inputs)
    weight = inputs.constant("weight")
    h = running.function(node.t, node.x, node.u, CASADI, 1)
    kernel = inputs.kernel(ca.SX(0, 1), node.duration * weight * h / scale)
    values = node_values(layout, owner) | {"weight": weights}
    inputs.add(layout.elements, kernel, values, np.empty((len(weights), 0)))


def quadrature(layout: PhaseLayout) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Weights of the controls as fractions of the phase; they sum to one."""
    mesh = layout.mesh
    return np.concatenate(
        [
            0.5 * (mesh.breaks[k + 1] - mesh.breaks[k]) * mesh.node_set(k).weights
            for k in range(mesh.segments)
        ]
    )


def _label(layout: PhaseLayout, owner: VehicleLayout, fractions: list[float], j: int) -> str:
    t = layout.nominal_time(fractions[j // owner.nx])
    name = owner.vehicle.model.state_names[j % owner.nx]
    return f"dynamics[{owner.vehicle.name}, {name}, t = {t:.1f} s]"
