"""How hard a vehicle can push itself: rigorous upper bounds from its limits and known wrenches."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.point_mass import PointMass
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.vehicle import Vehicle


@dataclass(frozen=True, eq=False)
class Authority:
    """Upper bounds, infinite where nothing limits.

    Attributes:
        acceleration_m_s2: A, on the norm of the centre of mass's acceleration.
        per_axis_m_s2: on its inertial components (dim,); None where the thrust turns with the
            body, which may then point its strongest direction anywhere.
        angular_rad_s2: G/J_min, torque about the centre of mass over the least principal moment
            there, rad/s²; zero for what does not turn.
    """

    acceleration_m_s2: float
    per_axis_m_s2: Array | None
    angular_rad_s2: float


def authority(vehicle: Vehicle) -> Authority:
    """The bounds for one vehicle: A = ‖f_max‖/m, and so on."""
    strongest = np.maximum(-vehicle.limits.control_lower, vehicle.limits.control_upper)
    if isinstance(vehicle.model, PointMass):
        per_axis = strongest / vehicle.model.mass_kg
        return Authority(float(np.linalg.norm(per_axis)), per_axis, 0.0)
    if isinstance(vehicle.model, RigidBody):
        return _of_rigid_body(vehicle.model, strongest)
    return Authority(np.inf, None, np.inf)


def _of_rigid_body(model: RigidBody, strongest: Array) -> Authority:
    centre = model.centre_of_mass_m
    force = float(np.linalg.norm(strongest[:3]))
    # τ_cm = g − o × f for a force at the reference point, o the centre of mass.
    arm = float(np.linalg.norm(centre))
    torque = float(np.linalg.norm(strongest[3:])) + (arm * force if arm > 0.0 else 0.0)
    for wrench in model.wrenches:
        # Linear between knots, so that the convex norm is largest at one of them.
        about_centre = wrench.torque_nm + np.cross(wrench.point_m - centre, wrench.force_n)
        force += float(np.max(np.linalg.norm(wrench.force_n, axis=1)))
        torque += float(np.max(np.linalg.norm(about_centre, axis=1)))
    least_moment = float(np.linalg.eigvalsh(model.inertia_cm_kg_m2)[0])
    return Authority(force / model.mass_kg, None, torque / least_moment)
