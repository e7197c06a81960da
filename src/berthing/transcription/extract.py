"""From a solved programme back to trajectories, nodes and costates."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.trajectory import PhaseTrajectory, Segment, VehicleNodes, VehicleTrajectory
from berthing.transcription.lagrange import to_chebyshev
from berthing.transcription.limit_costates import limit_costates
from berthing.transcription.problem import Motion, Problem


def trajectories(problem: Problem, motion: Motion) -> PhaseTrajectory:
    """The interpolants of ``motion``, segment by segment."""
    vehicles = []
    mesh, t0 = problem.mesh, problem.layout.t0_s
    for vehicle in problem.phase.vehicles:
        states, controls = motion.states[vehicle.name], motion.controls[vehicle.name]
        segments = []
        for k in range(mesh.segments):
            nodes = mesh.node_set(k)
            i, j = mesh.point_offset(k), mesh.control_offset(k)
            state = states[:, i : i + len(nodes.points)].T
            control = controls[:, j : j + len(nodes.collocated)].T
            segments.append(
                Segment(
                    t0 + motion.duration_s * mesh.breaks[k],
                    t0 + motion.duration_s * mesh.breaks[k + 1],
                    to_chebyshev(nodes.points) @ state,
                    to_chebyshev(nodes.control_points) @ control,
                )
            )
        model = vehicle.model
        vehicles.append(
            VehicleTrajectory(
                vehicle.name, model.kind, model.state_names, model.control_names, tuple(segments)
            )
        )
    return PhaseTrajectory(problem.phase.name, tuple(vehicles))


def nodes(problem: Problem, motion: Motion, multipliers: Array) -> tuple[VehicleNodes, ...]:
    """States, controls, costates and multipliers of limits at the state points.

    Costates follow by the covector mapping (Garg et al., 10.1007/s10589-009-9291-0). With the
    defects written D X - (h/2) f and their multipliers μ, stationarity in the controls gives
    λ_i = -μ_i / w_i at a collocated point, and stationarity in a segment's last state gives
    λ = -Σ_i D_i,end μ_i there. A point shared by two segments takes the later one's value.

    Lobatto points are all collocated and λ_i = -μ_i / w_i holds at each (Gong et al.,
    10.1007/s10589-007-9102-4), but the adjoint equations then have a differentiation matrix
    without full rank: its null space oscillates from node to node, and costates take up some of it.
    """
    mesh = problem.mesh
    times = problem.layout.t0_s + motion.duration_s * mesh.point_fractions()
    out = []
    for vehicle, unit in zip(problem.phase.vehicles, problem.layout.scale.vehicles, strict=True):
        nx, nu = len(vehicle.model.state_names), len(vehicle.model.control_names)
        costates = np.full((mesh.point_count, nx), np.nan)
        controls = np.full((mesh.point_count, nu), np.nan)
        for k in range(mesh.segments):
            node_set = mesh.node_set(k)
            c, first = list(node_set.collocated), mesh.point_offset(k)
            mu = multipliers[problem.defect_rows[vehicle.name][k]]
            end = len(node_set.points) - 1
            costates[first + end] = -node_set.D[:, end] @ mu
            costates[[first + i for i in c]] = -mu / node_set.weights[:, None]
            j = mesh.control_offset(k)
            controls[[first + i for i in c]] = motion.controls[vehicle.name][:, j : j + len(c)].T
        costates *= problem.layout.scale.cost / unit.state
        states = np.ascontiguousarray(motion.states[vehicle.name].T)
        limits = limit_costates(
            problem.layout, problem.limit_rows, problem.path_rows, multipliers, motion.duration_s,
            problem.layout.vehicles[vehicle.name],
        )  # fmt: skip
        out.append(
            VehicleNodes(
                problem.phase.name, vehicle.name, times, states, controls, costates, limits
            )
        )
    return tuple(out)
