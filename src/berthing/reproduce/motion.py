"""Claims about the equations of motion."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.integrate import solve_ivp

from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.reproduce.finding import Finding, verdict
from berthing.scenario.rigid_body import RigidBody
from berthing.verify import equations

BODY = RigidBody(3.0, np.diag([5.0, 6.0, 7.0]), np.array([1.0, 0.5, -0.3]))
"""Its centre of mass is off the reference point."""

TUMBLING = np.array([1.0, -2.0, 0.5, 0.3, 0.1, -0.2, 1.0, 0.0, 0.0, 0.0, 0.4, -0.3, 0.5])
DURATION_S, TIGHT = 20.0, 1e-11
CONSERVED, STEP = 1e-7, 1e-6


def findings() -> list[Finding]:
    """All of them, in the order of the paper."""
    return [_kinematics(), _loads()]


def _kinematics() -> Finding:
    """Poisson's equation Ċ = −ω^× C of the printed C_sI under each sign."""
    q, w = quaternion.normalise(np.array([0.6, -0.3, 0.5, 0.2])), np.array([0.3, -0.1, 0.4])
    wrong = {name: _off(q, w, sign) for name, sign in (("minus", -1.0), ("plus", 1.0))}
    return Finding(
        "Kinematics", "ε̇ = ½ (η I − ε^×) ω",
        f"with the C_sI printed the attitude then turns off Poisson's equation by "
        f"{wrong['minus']:.2f}; with a plus sign by {wrong['plus']:.0e}",
        verdict(wrong["minus"] < CONSERVED), wrong,
    )  # fmt: skip


def _off(q: Array, w: Array, sign: float) -> float:
    rate = 0.5 * np.concatenate([[-q[1:] @ w], q[0] * w + sign * np.cross(q[1:], w)])
    ahead, behind = (quaternion.rotation_matrix(q + h * rate).T for h in (STEP, -STEP))
    expected = -np.cross(w, quaternion.rotation_matrix(q).T, axisb=0, axisc=0)
    return float(np.max(np.abs((ahead - behind) / (2 * STEP) - expected)))


def _loads() -> Finding:
    drifts = {"printed": _drift(_rates(1.0)), "corrected": _drift(_rates(0.0))}
    return Finding(
        "Equations of motion", "the first row of l(ν) is m ω^× v",
        f"free motion with the centre of mass off the reference point then gains or loses "
        f"{drifts['printed']:.1f} of momentum or energy in {DURATION_S:.0f} s; with −ω^× c^× ω in "
        f"that row {drifts['corrected']:.0e}",
        verdict(drifts["printed"] < CONSERVED), drifts,
    )  # fmt: skip


def _rates(missing: float) -> Callable[[float, Array], Array]:
    """Free motion with this share of the missing term left out."""
    inverse = np.linalg.inv(equations.mass_matrix(BODY))

    def rates(t: float, x: Array) -> Array:
        turn, w = quaternion.rotation_matrix(x[6:10]), x[10:13]
        nu = np.concatenate([turn.T @ x[3:6], w])
        load = equations.coriolis(BODY, nu)
        load[:3] += missing * np.cross(w, np.cross(BODY.first_moment_kg_m, w))
        nu_dot = inverse @ -load
        q_dot = 0.5 * quaternion.multiply(x[6:10], np.concatenate([[0.0], w]))
        acceleration = turn @ (nu_dot[:3] + np.cross(w, nu[:3]))
        return np.concatenate([x[3:6], acceleration, q_dot, nu_dot[3:]])

    return rates


def _integrals(x: Array) -> Array:
    """Momentum (3,), angular momentum about the origin (3,) and energy."""
    turn, w = quaternion.rotation_matrix(x[6:10]), x[10:13]
    v, c, J = turn.T @ x[3:6], BODY.first_moment_kg_m, BODY.inertia_kg_m2
    p = BODY.mass_kg * v - np.cross(c, w)
    h = np.cross(c, v) + J @ w
    energy = 0.5 * BODY.mass_kg * v @ v + 0.5 * w @ J @ w - v @ np.cross(c, w)
    return np.concatenate([turn @ p, turn @ h + np.cross(x[:3], turn @ p), [energy]])


def _drift(rates: Callable[[float, Array], Array]) -> float:
    run = solve_ivp(rates, (0.0, DURATION_S), TUMBLING, method="DOP853", rtol=TIGHT, atol=TIGHT)
    start = _integrals(TUMBLING)
    return float(max(np.max(np.abs(_integrals(x) - start)) for x in run.y.T[1:]))
