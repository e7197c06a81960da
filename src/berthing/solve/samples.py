"""Poses of bodies at instants of a mesh, and how they change with a programme's variables."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np
from scipy import sparse

from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.scenario.scenario import Scenario
from berthing.transcription.elements import Index
from berthing.transcription.lagrange import interpolation_matrix
from berthing.transcription.layout import VehicleLayout
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion, Problem


@dataclass(frozen=True)
class Placed:
    """All bodies at k instants.

    Attributes:
        poses: by owner, (k,); of a structure at rest as well.
        slopes: vehicle → (k, d + d², c): of position and rotation, column by column, by the c
            stored components that place it, all at the instant itself.
    """

    poses: Mapping[str, Pose]
    slopes: Mapping[str, Array]


class Samples:
    """Instants of a phase.

    Args:
        fractions: (k,) of the phase.

    Attributes:
        size: how many numbers place all vehicles at all instants.
    """

    def __init__(self, problem: Problem, fractions: Array) -> None:
        self.problem, self.fractions = problem, fractions
        self._points, self._weights = _interpolation(problem.mesh, self.fractions)
        self._maps = {
            name: _pose_map(own, len(self.fractions))
            for name, own in problem.layout.vehicles.items()
        }
        counts = [len(own.pose_columns) for own in problem.layout.vehicles.values()]
        starts = np.cumsum([0, *counts]) * len(self.fractions)
        self._starts = dict(zip(problem.layout.vehicles, starts[:-1].tolist(), strict=True))
        self.size = int(starts[-1])

    def times(self, motion: Motion) -> Array:
        """(k,) on the scenario's clock."""
        return np.asarray(self.problem.layout.t0_s + motion.duration_s * self.fractions)

    def place(self, scenario: Scenario, motion: Motion) -> Placed:
        """The bodies of ``scenario`` on ``motion``."""
        t, poses, slopes = self.times(motion), {}, {}
        for structure in scenario.structures:
            poses[structure.name] = structure.motion.pose(t)
        for name, own in self.problem.layout.vehicles.items():
            x = np.einsum("nkw,kw->nk", motion.states[name][:, self._points], self._weights)
            value, jacobian = (np.asarray(out) for out in self._maps[name](x))
            d, k, columns = own.vehicle.dim, len(t), list(own.pose_columns)
            turn = value[d:].T.reshape(k, d, d).transpose(0, 2, 1)
            poses[name] = Pose(value[:d].T, turn)
            slope = jacobian.reshape(d + d * d, k, len(columns)).transpose(1, 0, 2)
            slopes[name] = slope * own.scale.state[columns]
        return Placed(poses, slopes)

    def places(self, vehicle: str, at: Index) -> Index:
        """Numbers (m, c), of ``size``, of what places ``vehicle`` at the instants ``at`` (m,)."""
        count = len(self.problem.layout.vehicles[vehicle].pose_columns)
        return np.asarray(self._starts[vehicle] + at[:, None] * count + np.arange(count))

    @cached_property
    def interpolation(self) -> sparse.csr_matrix:
        """(size, n) what places the vehicles at the instants, by the stored variables."""
        rows, columns, values = [], [], []
        every = np.arange(len(self.fractions))
        for name, own in self.problem.layout.vehicles.items():
            own_columns = own.state.indices[list(own.pose_columns)][:, self._points]
            columns.append(own_columns.transpose(1, 0, 2).ravel())
            shape = (len(every), len(own.pose_columns), self._weights.shape[1])
            rows.append(np.broadcast_to(self.places(name, every)[:, :, None], shape).ravel())
            values.append(np.broadcast_to(self._weights[:, None, :], shape).ravel())
        entries = np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))
        matrix = sparse.csr_matrix(entries, (self.size, self.problem.layout.variables.size))
        matrix.eliminate_zeros()
        return matrix


def spread_evenly(mesh: Mesh, between: int) -> Array:
    """Fractions (k,) of the points of a mesh and of ``between`` instants from one to the next,
    but for the start, which nothing can change."""
    points = mesh.point_fractions()
    steps = np.arange(1, between + 2) / (between + 1)
    return np.asarray((points[:-1, None] + np.diff(points)[:, None] * steps).ravel())


def _interpolation(mesh: Mesh, fractions: Array) -> tuple[Index, Array]:
    """State points (k, w) that the instants lie between, and their weights."""
    width = max(mesh.degrees) + 1
    points = np.zeros((len(fractions), width), dtype=np.int64)
    weights = np.zeros((len(fractions), width))
    placed = [mesh.locate(float(fraction)) for fraction in fractions]
    segment, within = np.array([k for k, _ in placed]), np.array([s for _, s in placed])
    for k in np.unique(segment):
        at, nodes = np.flatnonzero(segment == k), mesh.node_set(int(k)).points
        own = slice(None, len(nodes))
        points[at, own] = mesh.point_offset(int(k)) + np.arange(len(nodes))
        weights[at, own] = interpolation_matrix(nodes, within[at])
    return points, weights


def _pose_map(own: VehicleLayout, count: int) -> Any:
    """States (nx, count) → position and rotation, and their slopes by what places the body."""
    x = ca.SX.sym("x", own.nx)
    body = own.kinematics(x)
    pose = ca.vertcat(body.position, ca.vec(body.rotation))
    jacobian: Any = ca.jacobian(pose, x)
    slopes = ca.densify(jacobian[:, list(own.pose_columns)])
    return ca.Function("pose", [x], [ca.densify(pose), slopes]).map(count)
