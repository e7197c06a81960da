"""The columns of the tables in a plan folder, and what a vehicle has of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import chain

import numpy as np

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.scenario.native_state import Model
from berthing.scenario.scenario import Scenario
from berthing.trajectory import VehicleTrajectory

POSITION = ("x_m", "y_m", "z_m")
QUATERNION = ("qw", "qx", "qy", "qz")
VELOCITY = ("vx_m_s", "vy_m_s", "vz_m_s")
RATE = ("wx_rad_s", "wy_rad_s", "wz_rad_s")
CONTROL = ("fx_n", "fy_n", "fz_n", "gx_nm", "gy_nm", "gz_nm")
HEADER = ("t_s", "vehicle", *POSITION, *QUATERNION, *VELOCITY, *RATE, *CONTROL)


def native_columns(scenario: Scenario) -> tuple[str, ...]:
    """Native states and controls, of any vehicle, that ``HEADER`` has no column for."""
    models = [v.model for phase in scenario.phases for v in phase.vehicles]
    every = chain.from_iterable((*m.state_names, *m.control_names) for m in models)
    return tuple(dict.fromkeys(name for name in every if name not in HEADER))


def trajectory_columns(model: Model, trajectory: VehicleTrajectory, t: Array) -> dict[str, Array]:
    """The columns (k,) that a vehicle has at the times t (k,), by name.

    Position, attitude and velocity come from the model's pose map: planar vehicles lie at z = 0,
    quaternions are normalised and q_IB is scalar first. Rates, forces and torques are there for
    models that have them, in the body frame; native columns follow as they are.
    """
    x, u = trajectory.state(t), trajectory.control(t)
    pose, (velocity, _) = model.pose(x), model.velocity(x)
    native = dict(zip((*model.state_names, *model.control_names), np.hstack([x, u]).T, strict=True))
    return {
        **native,
        **_named(POSITION, _lifted(pose.position)),
        **_named(QUATERNION, _quaternion(native, pose.rotation)),
        **_named(VELOCITY, _lifted(velocity)),
    }


def _quaternion(native: Mapping[str, Array], rotation: Array) -> Array:
    """The model's own where it has one, so that its sign runs on; else from the pose."""
    if set(QUATERNION) <= set(native):
        return quaternion.normalise(np.stack([native[name] for name in QUATERNION], axis=-1))
    d = rotation.shape[-1]
    lifted = np.broadcast_to(np.eye(3), (*rotation.shape[:-2], 3, 3)).copy()
    lifted[..., :d, :d] = rotation
    return quaternion.from_matrix(lifted)


def _named(names: Iterable[str], values: Array) -> dict[str, Array]:
    return dict(zip(names, values.T, strict=True))


def _lifted(vectors: Array) -> Array:
    out = np.zeros((len(vectors), 3))
    out[:, : vectors.shape[1]] = vectors
    return out
