"""Poses of bodies at instants of a mesh, and how they change with a programme's variables."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

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
    """

    def __init__(self, problem: Problem, fractions: Array) -> None:
        self.problem, self.fractions = problem, fractions
        self._points, self._weights = _interpolation(problem.mesh, self.fractions)
        self._maps = {
            name: _pose_map(own, len(self.fractions))
            for name, own in problem.layout.vehicles.items()
        }

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

    def spread(self, vehicle: str, at: Index, slopes: Array) -> tuple[Index, Array]:
        """Columns (m, c, w) and entries of rows (m, c) by what places ``vehicle`` at the instants
        ``at`` (m,), by the variables of the programme."""
        own = self.problem.layout.vehicles[vehicle]
        columns = own.state.indices[list(own.pose_columns)][:, self._points[at]]
        return columns.transpose(1, 0, 2), slopes[:, :, None] * self._weights[at][:, None, :]


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
    for i, fraction in enumerate(fractions):
        k, s = mesh.locate(float(fraction))
        nodes = mesh.node_set(k)
        own = interpolation_matrix(nodes.points, np.array([s]))[0]
        points[i, : len(own)] = mesh.point_offset(k) + np.arange(len(own))
        weights[i, : len(own)] = own
    return points, weights


def _pose_map(own: VehicleLayout, count: int) -> Any:
    """States (nx, count) → position and rotation, and their slopes by what places the body."""
    x = ca.SX.sym("x", own.nx)
    body = own.kinematics(x)
    pose = ca.vertcat(body.position, ca.vec(body.rotation))
    jacobian: Any = ca.jacobian(pose, x)
    slopes = ca.densify(jacobian[:, list(own.pose_columns)])
    return ca.Function("pose", [x], [ca.densify(pose), slopes]).map(count)
