"""State, control and time at the collocated nodes of one vehicle, for kernels that need all."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from berthing.sym import Sym
from berthing.transcription.inputs import Inputs
from berthing.transcription.layout import PhaseLayout, VehicleLayout


@dataclass(frozen=True)
class Node:
    """Casadi expressions at one node: t (s), x (nx,), u (nu,), and the phase's duration (s)."""

    t: Sym
    x: Sym
    u: Sym
    duration: Sym


def declare_node(layout: PhaseLayout, owner: VehicleLayout, inputs: Inputs) -> Node:
    """Declare ``x``, ``u``, the duration and the ``fraction`` of the phase."""
    x = owner.declare_state(inputs, "x")
    u = inputs.variable("u", owner.nu, owner.scale.control)
    duration = layout.declare_duration(inputs)
    t = layout.t0_s + duration * inputs.constant("fraction")
    return Node(t, x, u, duration)


def node_values(layout: PhaseLayout, owner: VehicleLayout) -> dict[str, Any]:
    """What ``declare_node`` declares at every collocated node (n), in the order of the controls."""
    mesh = layout.mesh
    points, fractions = collocated(layout)
    return layout.shared_indices(mesh.control_count) | {
        "x": owner.state.indices[:, points].T,
        "u": owner.control.indices.T,
        "fraction": fractions,
    }


def collocated(layout: PhaseLayout) -> tuple[list[int], list[float]]:
    """State points and fractions of the phase of the collocated nodes."""
    mesh = layout.mesh
    points, fractions = [], []
    for k in range(mesh.segments):
        nodes, offset = mesh.node_set(k), mesh.point_offset(k)
        points += [offset + c for c in nodes.collocated]
        fractions += [mesh.fraction(k, float(nodes.points[c])) for c in nodes.collocated]
    return points, fractions
