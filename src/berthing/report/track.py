"""A vehicle's motion sampled for drawing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.geometry.pose import Pose
from berthing.report.space import in_space
from berthing.report.style import VEHICLE_COLOURS, VEHICLE_DASHES
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import Plan, VehicleNodes, VehicleTrajectory, evaluate

# Samples of a whole phase; a figure is about 500 pixels wide.
SAMPLES = 480
# Fewer on a segment would show a curve of the degrees in use as a polygon.
SAMPLES_PER_SEGMENT = 12


@dataclass(frozen=True, eq=False)
class Motion:
    """Columns of motion at the times t (k,).

    Attributes:
        times_s: (k,).
        pose: batched.
        velocity_m_s: inertial (k, dim).
        q_IB: (k, 4), without jumps of sign.
        rate_rad_s: body axes (k, 3).
        control: native (k, nu), NaN where there is none.
    """

    times_s: Array
    pose: Pose
    velocity_m_s: Array
    q_IB: Array
    rate_rad_s: Array
    control: Array


@dataclass(frozen=True, eq=False)
class Track:
    """One vehicle in one phase, dense and at the solver's nodes, with its colour and dash."""

    phase: str
    vehicle: Vehicle
    dense: Motion
    nodes: Motion
    colour: str
    dash: str


def tracks(scenario: Scenario, plan: Plan) -> list[Track]:
    """One for each phase and vehicle of the plan, in its order."""
    order: list[str] = []
    found = []
    for phase in plan.phases:
        for trajectory in phase.vehicles:
            vehicle = scenario.phase(phase.phase).vehicle(trajectory.vehicle)
            if vehicle.name not in order:
                order.append(vehicle.name)
            rank = order.index(vehicle.name)
            nodes = _at_nodes(vehicle, plan.nodes, phase.phase)
            colour = VEHICLE_COLOURS[rank % len(VEHICLE_COLOURS)]
            dash = VEHICLE_DASHES[rank % len(VEHICLE_DASHES)]
            dense = _dense(vehicle, trajectory)
            found.append(Track(phase.phase, vehicle, dense, nodes, colour, dash))
    return found


def _dense(vehicle: Vehicle, trajectory: VehicleTrajectory) -> Motion:
    """Sampled segment by segment, both ends included: jumps of the control stay upright."""
    count = max(SAMPLES_PER_SEGMENT, SAMPLES // len(trajectory.segments))
    s = np.linspace(-1.0, 1.0, count)
    times, states, controls = (
        np.concatenate(columns)
        for columns in zip(
            *(
                (
                    0.5 * (g.t0_s + g.t1_s) + 0.5 * (g.t1_s - g.t0_s) * s,
                    evaluate(g.state, s),
                    evaluate(g.control, s),
                )
                for g in trajectory.segments
            ),
            strict=True,
        )
    )
    return motion(vehicle, times, states, controls)


def _at_nodes(vehicle: Vehicle, nodes: tuple[VehicleNodes, ...], phase: str) -> Motion:
    """At the nodes of one phase; a plan without any has rows of none."""
    for entry in nodes:
        if (entry.phase, entry.vehicle) == (phase, vehicle.name):
            return motion(vehicle, entry.times_s, entry.states, entry.controls)
    nothing = np.empty((0, 3))
    return Motion(
        nothing[:, 0],
        Pose(nothing[:, : vehicle.dim], np.empty((0, vehicle.dim, vehicle.dim))),
        nothing[:, : vehicle.dim],
        np.empty((0, 4)),
        nothing,
        np.empty((0, len(vehicle.model.control_names))),
    )


def motion(vehicle: Vehicle, times_s: Array, states: Array, controls: Array) -> Motion:
    """Columns of motion from native states (k, nx) and controls (k, nu), through the model."""
    model = vehicle.model
    pose = model.pose(states)
    velocity, rate_inertial = model.velocity(states)
    rotation = in_space(pose).rotation
    rate = np.einsum("kji,kj->ki", rotation, rate_inertial)
    return Motion(
        times_s, pose, velocity, _continuous(quaternion.from_matrix(rotation)), rate, controls
    )


def _continuous(q: Array) -> Array:
    """q or −q in each row, whichever is nearer to the row before."""
    if len(q) < 2:
        return q
    turned = np.einsum("ki,ki->k", q[1:], q[:-1]) < 0.0
    sign = np.concatenate([[1.0], np.where(np.cumsum(turned) % 2, -1.0, 1.0)])
    return np.asarray(q * sign[:, None])


def same_sign(nodes: Motion, line: Motion) -> Array:
    """The nodes' quaternions (k, 4), signed as the line is there; q and −q are one attitude."""
    if not len(nodes.q_IB):
        return nodes.q_IB
    nearest = np.searchsorted(line.times_s, nodes.times_s)
    there = line.q_IB[np.minimum(nearest, len(line.times_s) - 1)]
    flip = np.einsum("ki,ki->k", there, nodes.q_IB) < 0.0
    return np.asarray(nodes.q_IB * np.where(flip, -1.0, 1.0)[:, None])
