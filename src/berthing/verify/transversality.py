"""Costates at the ends: where an end leaves the state free, nothing may be gained by moving it."""

from __future__ import annotations

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.quaternion import from_matrix, rotation_matrix
from berthing.scenario.attitude import AxisAttitude, FixedAttitude
from berthing.scenario.goal import End, InertialEnd
from berthing.scenario.scenario import Scenario
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import VehicleNodes
from berthing.verify.frames import lifted_rotation

QUATERNION = ("qw", "qx", "qy", "qz")

STEP = 1e-6
"""Of a component's range, in central differences of what an end asks for."""

ON_EDGE = 1e-5
"""Of a tolerance: a state within this of its edge is held by it."""

RANK = 1e-6
"""Singular values below this share of the largest are differences' noise."""


def transversality(
    scenario: Scenario, vehicle: Vehicle, nodes: VehicleNodes, x_range: Array
) -> float:
    """The most that one end's costates promise for a move the end allows, each component by its
    range; in units of the cost."""
    worst = 0.0
    for end, i, start in ((vehicle.start, 0, True), (vehicle.goal, -1, False)):
        t, x = float(nodes.times_s[i]), nodes.states[i]
        held = _held(scenario, vehicle, end, t, x, x_range, norm=start)
        free = nodes.costates[i] * x_range - _within(held, nodes.costates[i] * x_range)
        worst = max(worst, float(np.max(np.abs(free))))
    return worst


def _within(rows: Array, vector: Array) -> Array:
    """The part of ``vector`` (n,) in the span of the rows (m, n)."""
    if not len(rows):
        return np.zeros_like(vector)
    _, sizes, basis = np.linalg.svd(rows, full_matrices=False)
    basis = basis[sizes > RANK * sizes[0]]
    return np.asarray(basis.T @ (basis @ vector))


def _held(
    scenario: Scenario, vehicle: Vehicle, end: End, t: float, x: Array, x_range: Array, *,
    norm: bool,
) -> Array:  # fmt: skip
    """Gradients (m, nx), by the components' ranges, of what the end holds fast."""
    asked = end.resolve(t, scenario)
    model = vehicle.model
    # Models of the plane turn by an angle, and have no quaternion among their states.
    own = set(QUATERNION) <= set(model.state_names)
    quaternion = [model.state_names.index(q) for q in QUATERNION] if own else []
    here = lifted_rotation(model.pose(x[None]).rotation[0])
    attitude = x[quaternion] if own else from_matrix(here)

    # Decided once: a difference across the edge would compare conditions of different number.
    miss_m = float(np.linalg.norm(model.pose(x[None]).position[0] - asked.position_m))
    on_edge = miss_m >= (1.0 - ON_EDGE) * end.position_tolerance_m

    def conditions(state: Array) -> Array:
        pose, (velocity, rate) = model.pose(state[None]), model.velocity(state[None])
        rotation, turned = lifted_rotation(pose.rotation[0]), rate[0]
        out: list[Array] = []
        offset = pose.position[0] - asked.position_m
        if end.position_tolerance_m == 0.0:
            out.append(offset)
        elif on_edge:
            out.append(np.atleast_1d(np.linalg.norm(offset)))
        if model.turns:
            out.append(_attitude(asked, attitude, rotation))
        if model.tells_rates and asked.velocity_m_s is not None:
            out.append(velocity[0])
        if model.turns and model.tells_rates and asked.relative_rate_rad_s is not None:
            out.append(rotation.T @ (turned - asked.frame_rate_rad_s))
        out.append(np.array([state[model.state_names.index(name)] for name in end.states]))
        return np.concatenate(out)

    rows = []
    for j in range(len(x)):
        step = np.zeros(len(x))
        step[j] = STEP * x_range[j]
        rows.append((conditions(x + step) - conditions(x - step)) / (2.0 * STEP))
    gradients = np.array(rows).T
    if norm and quaternion:
        along = np.zeros(len(x))
        along[quaternion] = x[quaternion] * x_range[quaternion]
        gradients = np.vstack([gradients, along])
    sizes = np.linalg.norm(gradients, axis=1)
    real = sizes > RANK * np.max(sizes, initial=0.0)
    return np.asarray(gradients[real] / sizes[real, None])


def _attitude(asked: InertialEnd, q: Array, rotation: Array) -> Array:
    """What an end holds of the attitude, q being where the plan is and ``rotation`` a move."""
    wanted = asked.attitude
    loose = getattr(wanted, "tolerance_rad", np.inf)
    if loose > 0.0 and float(wanted.error_rad(q)) < (1.0 - ON_EDGE) * loose:
        return np.empty(0)
    if isinstance(wanted, FixedAttitude):
        if loose == 0.0:
            return rotation.ravel()
        return np.atleast_1d(np.trace(rotation @ rotation_matrix(wanted.q).T))
    if isinstance(wanted, AxisAttitude):
        axis = rotation @ wanted.body_axis
        return axis if loose == 0.0 else np.atleast_1d(axis @ wanted.world_axis)
    return np.empty(0)
