"""A path of poses, and the motion along it on a mesh."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline, PchipInterpolator
from scipy.spatial.transform import Rotation, Slerp

from berthing.geometry.arrays import Array
from berthing.scenario.phase import Phase
from berthing.scenario.vehicle import Vehicle
from berthing.transcription.lagrange import interpolation_matrix
from berthing.transcription.mesh import Mesh
from berthing.transcription.problem import Motion

RATE_STEP = 1e-4
"""Fraction of the phase over which rates of a guess are differenced; a guess needs no more."""


@dataclass(frozen=True)
class VehiclePath:
    """Waypoints of one vehicle.

    Attributes:
        positions_m: inertial (m, d), m ≥ 2.
        q_IB: attitudes (m, 4), scalar first.
        fractions: of the phase (m,), from 0 to 1, at which it is there; None for as the way takes.
    """

    positions_m: Array
    q_IB: Array
    fractions: Array | None = None


@dataclass(frozen=True)
class Guess:
    """A path for every vehicle, by name."""

    name: str
    paths: Mapping[str, VehiclePath]


def motion_along(guess: Guess, phase: Phase, mesh: Mesh, duration_s: float) -> Motion:
    """The guess as states at the mesh's points, at rest at both ends, controls zero."""
    fractions = mesh.point_fractions()
    states, controls = {}, {}
    for vehicle in phase.vehicles:
        path = guess.paths[vehicle.name]
        x = _states(vehicle, path, fractions, duration_s)
        states[vehicle.name] = _with_native(vehicle, x, fractions).T
        nu = len(vehicle.model.control_names)
        controls[vehicle.name] = np.zeros((nu, mesh.control_count))
    return Motion(duration_s, states, controls)


def _states(vehicle: Vehicle, path: VehiclePath, fractions: Array, duration_s: float) -> Array:
    progress, position, attitude = _interpolants(path, vehicle.body.bounding_radius)
    before = np.clip(fractions - RATE_STEP, 0.0, 1.0)
    after = np.clip(fractions + RATE_STEP, 0.0, 1.0)
    step_s = (after - before)[:, None] * duration_s
    velocity = (position(progress(after)) - position(progress(before))) / step_s
    turn = attitude(progress(before)).inv() * attitude(progress(after))
    s = progress(fractions)
    q = _continuous(attitude(s).as_quat(scalar_first=True), path.q_IB[0])
    return vehicle.model.assemble(position(s), q, velocity, turn.as_rotvec() / step_s)


def _interpolants(
    path: VehiclePath, radius_m: float
) -> tuple[Callable[[Array], Array], Callable[[Array], Array], Callable[[Array], Rotation]]:
    """Progress by fractions of the phase, and by progress positions and attitudes."""
    turns = Rotation.from_quat(path.q_IB, scalar_first=True)
    if path.fractions is None:
        knots = _knots(path, radius_m)
        return _progress, PchipInterpolator(knots, path.positions_m, axis=0), Slerp(knots, turns)
    knots = path.fractions
    rest = CubicSpline(knots, path.positions_m, axis=0, bc_type="clamped")
    return np.asarray, rest, Slerp(knots, turns)


def _with_native(vehicle: Vehicle, x: Array, fractions: Array) -> Array:
    """States (n, nx) with the components that the ends give by name, straight from one to other."""
    names, first, last = vehicle.model.state_names, vehicle.start.states, vehicle.goal.states
    for name in {**first, **last}:
        known = [given[name] for given in (first, last) if name in given]
        x[:, names.index(name)] = known[0] + fractions * (known[-1] - known[0])
    return x


def _knots(path: VehiclePath, radius_m: float) -> Array:
    """Progress (m,) at the waypoints, by length travelled and by turning, an arm's length a rad."""
    lengths = np.linalg.norm(np.diff(path.positions_m, axis=0), axis=1)
    dots = np.abs(np.sum(path.q_IB[1:] * path.q_IB[:-1], axis=1))
    angles = 2.0 * np.arccos(np.clip(dots, 0.0, 1.0))
    steps = lengths + radius_m * angles
    steps = np.maximum(steps, 1e-3 * max(float(steps.sum()), 1.0))
    knots = np.concatenate([[0.0], np.cumsum(steps)])
    return np.asarray(knots / knots[-1])


def _progress(fraction: Array) -> Array:
    """Least-energy law from rest to rest: 3τ² - 2τ³."""
    return np.clip(fraction**2 * (3.0 - 2.0 * fraction), 0.0, 1.0)


def _continuous(q: Array, first: Array) -> Array:
    """The same attitudes with signs that follow on from ``first``, as polynomials need them."""
    out = q.copy()
    previous = first
    for i in range(len(out)):
        if out[i] @ previous < 0.0:
            out[i] = -out[i]
        previous = out[i]
    return out


def resample(motion: Motion, phase: Phase, old: Mesh, new: Mesh) -> Motion:
    """The same polynomials on another mesh."""
    states, controls = {}, {}
    for vehicle in phase.vehicles:
        X, U = motion.states[vehicle.name], motion.controls[vehicle.name]
        columns = []
        for fraction in new.point_fractions():
            k, s = old.locate(float(fraction))
            nodes, i = old.node_set(k), old.point_offset(k)
            w = interpolation_matrix(nodes.points, np.array([s]))[0]
            columns.append(X[:, i : i + len(nodes.points)] @ w)
        states[vehicle.name] = np.stack(columns, axis=1)
        columns = []
        for k_new in range(new.segments):
            for s_new in new.node_set(k_new).control_points:
                k, s = old.locate(new.fraction(k_new, float(s_new)))
                nodes, j = old.node_set(k), old.control_offset(k)
                w = interpolation_matrix(nodes.control_points, np.array([s]))[0]
                columns.append(U[:, j : j + len(nodes.collocated)] @ w)
        controls[vehicle.name] = np.stack(columns, axis=1)
    return Motion(motion.duration_s, states, controls)
