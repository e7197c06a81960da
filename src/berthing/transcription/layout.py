"""Where everything of one phase lives: variables, parameters, rows, elements."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import casadi as ca
import numpy as np

from berthing.dynamics.kinematics import Kinematics
from berthing.dynamics.models import symbolic
from berthing.dynamics.motion import Frame, symbolic_motion
from berthing.geometry.arrays import Array
from berthing.scenario.phase import Phase
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.sym import Sym
from berthing.transcription.elements import Elements, Index
from berthing.transcription.inputs import Inputs
from berthing.transcription.lagrange import interpolation_matrix
from berthing.transcription.mesh import Mesh
from berthing.transcription.packing import Block, Packing
from berthing.transcription.rows import RowBook
from berthing.transcription.scaling import PhaseScale, VehicleScale
from berthing.transcription.scheme import scheme


@dataclass(frozen=True)
class VehicleLayout:
    """One vehicle's blocks.

    Attributes:
        state, control: blocks (nx, points) and (nu, controls).
        pose_columns: the components of the state that the pose depends on.
    """

    vehicle: Vehicle
    scale: VehicleScale
    state: Block
    control: Block
    pose_columns: tuple[int, ...]

    @property
    def nx(self) -> int:
        return self.state.shape[0]

    @property
    def nu(self) -> int:
        return self.control.shape[0]

    def declare_state(self, inputs: Inputs, name: str) -> Sym:
        """Declare one state (nx,) of this vehicle."""
        return inputs.variable(name, self.nx, self.scale.state, self.scale.state_shift)

    def kinematics(self, x: Sym) -> Kinematics:
        return symbolic(self.vehicle.model).kinematics(self.vehicle.model, x)


@dataclass(frozen=True)
class PhaseLayout:
    """One phase under assembly.

    Attributes:
        duration: block of the horizon; among the variables where it is free, else a parameter.
        frames: structure → blocks of its position (d, 1) and rotation (d, d) at t = 0.
    """

    phase: Phase
    mesh: Mesh
    scale: PhaseScale
    t0_s: float
    variables: Packing
    parameters: Packing
    rows: RowBook
    elements: Elements
    duration: Block
    vehicles: dict[str, VehicleLayout]
    structures: dict[str, Structure]
    frames: dict[str, tuple[Block, Block]]

    def nominal_time(self, fraction: float) -> float:
        """Time at a fraction of the phase if it lasts as long as scaled for; for labels."""
        return self.t0_s + self.scale.time_s * fraction

    def declare_duration(self, inputs: Inputs) -> Sym:
        """Declare the horizon under the name ``duration``."""
        if self.phase.horizon.is_free:
            return inputs.variable("duration", 1, self.scale.time_s)
        return inputs.parameter("duration", 1)

    def declare_frame(self, inputs: Inputs, structure: str, t: Sym) -> Frame:
        """Declare the base pose of a structure and return its frame at t."""
        owner = self.structures[structure]
        r = inputs.parameter(f"{structure}/position", owner.dim)
        R = inputs.parameter(f"{structure}/rotation", owner.dim**2)
        law = symbolic_motion(owner.motion)
        return law.frame(owner.motion, r, ca.reshape(R, owner.dim, owner.dim), t)

    def shared_indices(self, n: int) -> dict[str, Index]:
        """Indices (n, size) of the duration and of every structure's base pose."""
        out = {"duration": np.tile(self.duration.indices.ravel(), (n, 1))}
        for name, (position, rotation) in self.frames.items():
            out[f"{name}/position"] = np.tile(position.indices.ravel(order="F"), (n, 1))
            out[f"{name}/rotation"] = np.tile(rotation.indices.ravel(order="F"), (n, 1))
        return out

    def interpolation(self, k: int, s: float) -> tuple[Index, Array]:
        """Points and weights that give a state at the local coordinate s of segment k."""
        used, weights = _used_points(self.mesh.scheme, self.mesh.degrees[k], s)
        return self.mesh.point_offset(k) + used, weights


@lru_cache(maxsize=4096)
def _used_points(scheme_name: str, degree: int, s: float) -> tuple[Index, Array]:
    """Points of a segment that count at s, and their weights."""
    weights = interpolation_matrix(scheme(scheme_name)(degree).points, np.array([s]))[0]
    used = np.flatnonzero(weights)
    return used, weights[used]


def state_name(phase: str, vehicle: str) -> str:
    return f"{phase}/{vehicle}/state"


def control_name(phase: str, vehicle: str) -> str:
    return f"{phase}/{vehicle}/control"


def horizon_name(phase: str) -> str:
    return f"{phase}/duration_s"


def lay_out(
    phase: Phase, structures: tuple[Structure, ...], mesh: Mesh, scale: PhaseScale, t0_s: float
) -> PhaseLayout:
    """Declare the variables and parameters of ``phase``; no rows yet."""
    variables, parameters = Packing(), Packing()
    horizon = phase.horizon
    if horizon.is_free:
        duration = variables.add(
            horizon_name(phase.name), (1, 1), scale=scale.time_s,
            lower=horizon.min_s, upper=horizon.max_s,
        )  # fmt: skip
    else:
        duration = parameters.add(horizon_name(phase.name), (1, 1))
    vehicles = {}
    for vehicle, unit in zip(phase.vehicles, scale.vehicles, strict=True):
        nx, nu = len(vehicle.model.state_names), len(vehicle.model.control_names)
        state = variables.add(
            state_name(phase.name, vehicle.name), (nx, mesh.point_count),
            scale=unit.state, shift=unit.state_shift,
        )  # fmt: skip
        control = variables.add(
            control_name(phase.name, vehicle.name), (nu, mesh.control_count), scale=unit.control
        )
        vehicles[vehicle.name] = VehicleLayout(
            vehicle, unit, state, control, _pose_columns(vehicle)
        )
    frames = {
        structure.name: (
            parameters.add(f"{phase.name}/{structure.name}/position", (structure.dim, 1)),
            parameters.add(f"{phase.name}/{structure.name}/rotation", (structure.dim,) * 2),
        )
        for structure in structures
    }
    return PhaseLayout(
        phase, mesh, scale, t0_s, variables, parameters, RowBook(), Elements(), duration,
        vehicles, {s.name: s for s in structures}, frames,
    )  # fmt: skip


def _pose_columns(vehicle: Vehicle) -> tuple[int, ...]:
    x = ca.SX.sym("x", len(vehicle.model.state_names))
    body = symbolic(vehicle.model).kinematics(vehicle.model, x)
    pose = ca.vertcat(body.position, ca.vec(body.rotation))
    return tuple(int(i) for i in np.flatnonzero(ca.which_depends(pose, x, 1, False)))
