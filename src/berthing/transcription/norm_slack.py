"""One slack a segment where unit quaternions are collocated at both ends.

A segment of n Lobatto points has n rows for q̇ = ½ q ∘ ω, of which Σ w_i P(x_i) q_iᵀ row_i, P the
Legendre polynomial of degree n - 1, is left without a variable of its own as far as q stands still:
qᵀ q̇ vanishes anyway, and Dᵀ has no other null vector than w_i P(x_i). Rows that depend on each
other leave multipliers undetermined, and the solver stalls short of its tolerance. Here row i gets
γ P(x_i) q_i with one free γ: the combination determines γ, which is zero but for rounding where q
stands still. ‖q‖ then follows the ends of the segment exactly and may differ from 1 between them
by no more than it does between nodes; poses normalise q.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from numpy.polynomial import legendre

from berthing.sym import Sym
from berthing.transcription.inputs import Inputs
from berthing.transcription.layout import PhaseLayout, VehicleLayout
from berthing.transcription.packing import Block

QUATERNION = ("qw", "qx", "qy", "qz")


def slack_name(phase: str, vehicle: str) -> str:
    return f"{phase}/{vehicle}/norm slack"


@dataclass(frozen=True)
class NormSlack:
    """γ of every segment of one vehicle.

    Attributes:
        block: (1, segments); None where the scheme or the model needs none.
        columns: of the quaternion in the state.
    """

    block: Block | None
    columns: tuple[int, ...]

    @staticmethod
    def add(layout: PhaseLayout, owner: VehicleLayout) -> NormSlack:
        """Declare it among the variables if it is needed."""
        names = owner.vehicle.model.state_names
        if not layout.mesh.dependent or not set(QUATERNION) <= set(names):
            return NormSlack(None, ())
        name = slack_name(layout.phase.name, owner.vehicle.name)
        block = layout.variables.add(name, (1, layout.mesh.segments))
        return NormSlack(block, tuple(names.index(q) for q in QUATERNION))

    def declare(self, inputs: Inputs, x: Sym) -> Sym:
        """The term (nx,) of a node's defects with the state x (nx,), declaring what it takes."""
        term = ca.SX.zeros(x.numel())
        if self.block is not None:
            size = inputs.variable("slack", 1) * inputs.constant("slack shape")
            for i in self.columns:
                term[i] = size * x[i]
        return term

    def values(self, layout: PhaseLayout) -> dict[str, Any]:
        """What is declared, at all collocated nodes in order."""
        if self.block is None:
            return {}
        shapes, indices = [], []
        for k in range(layout.mesh.segments):
            points = layout.mesh.node_set(k).control_points
            shapes.append(legendre.legval(points, np.eye(len(points))[-1]))
            indices.append(np.full(len(points), self.block.indices[0, k]))
        return {"slack": np.concatenate(indices), "slack shape": np.concatenate(shapes)}
