"""The paper's rigid spacecraft, with first moment of mass, thrusters, wheels and manipulators.

State: r_I, v_I, q_IB, ω_B. The paper writes M_t ν̇ + l(ν) = q in body velocities ν = (v_B, ω).
With a = v̇_B + ω × v_B, the acceleration of the reference point in body components, and
-ω^× c^× ω restored in the first row (docs/errata.md, 3), every term in v_B cancels by the Jacobi
identity, v × (ω × c) - ω × (v × c) = c × (ω × v), and what is left is

    [m I   -c^×] [a]   [ω × (ω × c)]   [Σ f           ]
    [c^×    J  ] [ω̇] + [ω × J ω    ] = [Σ g + ρ × f_m ].
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from berthing.dynamics.kinematics import Kinematics
from berthing.dynamics.rotation import attitude_error, quaternion_rate, rotation_matrix
from berthing.dynamics.wrench import wrench_expression
from berthing.geometry.arrays import skew
from berthing.scenario.rigid_body import RigidBody
from berthing.sym import Sym


def derivative(model: RigidBody, t: Sym, x: Sym, u: Sym) -> Sym:
    """ẋ (13,) for the state x (13,), the control u = (f_B, g_B) (6,) and the time t."""
    v_I, q_IB, w_B = x[3:6], x[6:10], x[10:13]
    c = ca.DM(model.first_moment_kg_m)
    inertia = ca.DM(model.inertia_kg_m2)
    load = u + wrench_expression(model.wrenches, t)
    inertial_load = ca.vertcat(
        ca.cross(w_B, ca.cross(w_B, c)), ca.cross(w_B, ca.mtimes(inertia, w_B))
    )
    acceleration = ca.mtimes(ca.DM(np.linalg.inv(mass_matrix(model))), load - inertial_load)
    return ca.vertcat(
        v_I,
        ca.mtimes(rotation_matrix(q_IB), acceleration[0:3]),
        quaternion_rate(q_IB, w_B),
        acceleration[3:6],
    )


def kinematics(model: RigidBody, x: Sym) -> Kinematics:
    """Pose and rates as they stand in the state."""
    q_IB = x[6:10]
    return Kinematics(
        x[0:3], rotation_matrix(q_IB), x[3:6], x[10:13], lambda q: attitude_error(q, q_IB), q_IB
    )


def mass_matrix(model: RigidBody) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    """M_t = [[m I, -c^×], [c^×, J]] (6, 6), kg, kg·m and kg·m²."""
    c = skew(model.first_moment_kg_m)
    return np.block([[model.mass_kg * np.eye(3), -c], [c, model.inertia_kg_m2]])
