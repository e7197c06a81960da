"""A point mass pushed by a force in the inertial frame: r̈ = f / m."""

from __future__ import annotations

import casadi as ca

from berthing.dynamics.kinematics import Kinematics
from berthing.scenario.point_mass import PointMass
from berthing.sym import Sym


def derivative(model: PointMass, t: Sym, x: Sym, u: Sym) -> Sym:
    """ẋ (2 dim,) for x = (r, v) and u = f."""
    return ca.vertcat(x[model.dim : 2 * model.dim], u / model.mass_kg)


def kinematics(model: PointMass, x: Sym) -> Kinematics:
    """Position and velocity; the body never turns."""
    d = model.dim
    return Kinematics(x[0:d], ca.DM.eye(d), x[d : 2 * d], None, None)
