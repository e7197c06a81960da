"""Equations of motion in NumPy, written for the checks and shared with nobody.

Only models of the user's own have one source; a verification says so (``model_check``).

The rigid body is kept as the paper writes it, in body velocities ν = (v_B, ω_B):
M_t ν̇ + l(ν) = q + q^m, with l(ν) corrected by −ω^× c^× ω in its first row, which ω^× ∂T/∂v with
∂T/∂v = m v − c^× ω asks for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import lru_cache
from itertools import combinations_with_replacement
from typing import Any

import numpy as np

from berthing.errors import CapabilityError
from berthing.geometry.arrays import Array, skew
from berthing.scenario.native_state import Model
from berthing.scenario.point_mass import PointMass
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.user_model import UserModel
from berthing.scenario.wrench import Wrench
from berthing.xp import NUMPY

# ẋ (nx,) at the time t, the state x (nx,) and the control u (nu,), native units.
Derivative = Callable[[float, Array, Array], Array]


# Likewise (k, nx), of many.
Derivatives = Callable[[Array, Array, Array], Array]


def derivative(model: Model) -> Derivative:
    """The right-hand side of a model's equations of motion.

    Raises:
        CapabilityError: a model that has no independent equations.
    """
    build = _MODELS.get(type(model))
    if build is None:
        raise CapabilityError(f"no independent equations of motion for the model {model.kind!r}")
    return build(model)


def derivatives(model: Model) -> Derivatives:
    """The same of many times (k,), states (k, nx) and controls (k, nu) at once."""
    build = _AT_ONCE.get(type(model))
    if build is not None:
        return build(model)
    one = derivative(model)

    def rates(t: Array, x: Array, u: Array) -> Array:
        return np.array([one(float(a), b, c) for a, b, c in zip(t, x, u, strict=True)])

    return rates


def knots_s(model: Model) -> Array:
    """Times at which the right-hand side has kinks (k,)."""
    if isinstance(model, UserModel):
        return np.array(model.kinks_s, dtype=np.float64)
    wrenches = model.wrenches if isinstance(model, RigidBody) else ()
    return np.concatenate([np.empty(0), *(w.times_s for w in wrenches)])


def _point_mass(model: PointMass) -> Derivative:
    d, mass = model.dim, model.mass_kg

    def rates(t: float, x: Array, u: Array) -> Array:
        return np.concatenate([x[d:], u / mass])

    return rates


def _user(model: UserModel) -> Derivative:
    """The user's own, in numbers: the same source as the solver's."""

    def rates(t: float, x: Array, u: Array) -> Array:
        return np.asarray(model.f(t, x, u, NUMPY))

    return rates


def _rigid_body(model: RigidBody) -> Derivative:
    inverse = np.linalg.inv(mass_matrix(model))
    load = quadratic_load(model)
    wrench = _wrench_total(model.wrenches)

    def rates(t: float, x: Array, u: Array) -> Array:
        velocity, q, rate = x[3:6], x[6:10], x[10:13]
        rotation = _rotation(q.tolist())
        nu = np.concatenate([velocity @ rotation, rate])
        nu_dot = inverse @ (u + wrench(t) - (load @ nu) @ nu)
        # v_I = R v_B, so v̇_I = R (v̇_B + ω × v_B).
        acceleration = rotation @ (nu_dot[:3] + _cross(rate, nu[:3]))
        return np.concatenate([velocity, acceleration, _quaternion_rate(q, rate), nu_dot[3:]])

    return rates


def _rigid_bodies(model: RigidBody) -> Derivatives:
    """As ``_rigid_body``, a column of numbers in place of each."""
    inverse, load = np.linalg.inv(mass_matrix(model)), quadratic_load(model)
    wrench = _wrench_total(model.wrenches)

    def rates(t: Array, x: Array, u: Array) -> Array:
        velocity, q, rate = x[:, 3:6], x[:, 6:10], x[:, 10:13]
        rotation = np.moveaxis(_rotation(q.T), -1, 0)
        nu = np.hstack([np.einsum("kj,kji->ki", velocity, rotation), rate])
        outer = np.array([wrench(float(at)) for at in t]) if model.wrenches else 0.0
        nu_dot = (u + outer - np.einsum("aij,ki,kj->ka", load, nu, nu)) @ inverse.T
        turned = nu_dot[:, :3] + np.cross(rate, nu[:, :3])
        acceleration = np.einsum("kij,kj->ki", rotation, turned)
        w, v = q[:, :1], q[:, 1:]
        half = 0.5 * rate
        scalar = -np.sum(v * half, axis=1, keepdims=True)
        vector = w * half + np.cross(v, half)
        return np.hstack([velocity, acceleration, scalar, vector, nu_dot[:, 3:]])

    return rates


def _point_masses(model: PointMass) -> Derivatives:
    return lambda t, x, u: np.hstack([x[:, model.dim :], u / model.mass_kg])


def mass_matrix(model: RigidBody) -> Array:
    """M_t = [[m I, −c^×], [c^×, J]] (6, 6)."""
    c = skew(model.first_moment_kg_m)
    return np.block([[model.mass_kg * np.eye(3), -c], [c, model.inertia_kg_m2]])


def coriolis(model: RigidBody, nu: Array) -> Array:
    """l(ν) (6,): m ω×v − ω×(c×ω), and (v^× ω^× − ω^× v^×) c + ω × Jω."""
    v, w, c = nu[:3], nu[3:], model.first_moment_kg_m
    cross = np.cross
    force = model.mass_kg * cross(w, v) - cross(w, cross(c, w))
    torque = cross(v, cross(w, c)) - cross(w, cross(v, c)) + cross(w, model.inertia_kg_m2 @ w)
    return np.concatenate([force, torque])


@lru_cache(maxsize=64)
def quadratic_load(model: RigidBody) -> Array:
    """The tensor L (6, 6, 6) with l(ν) = (L ν) ν, not to be written to.

    l is a quadratic form, so that L_ij = (l(e_i + e_j) − l(e_i) − l(e_j))/2. An integrator asks
    for it some ten thousand times, and each check of a model for the tensor anew.
    """
    unit = np.eye(6)
    out = np.empty((6, 6, 6))
    for i, j in combinations_with_replacement(range(6), 2):
        mixed = coriolis(model, unit[i] + unit[j]) - coriolis(model, unit[i])
        out[:, i, j] = out[:, j, i] = 0.5 * (mixed - coriolis(model, unit[j]))
    out.setflags(write=False)
    return out


def _wrench_total(wrenches: tuple[Wrench, ...]) -> Callable[[float], Array]:
    """Σ f and Σ (g + ρ × f) of the manipulators (6,) as a function of time."""
    if not wrenches:
        nothing = np.zeros(6)
        return lambda t: nothing
    tables = [
        (w.times_s, np.hstack([w.force_n, w.torque_nm + np.cross(w.point_m, w.force_n)]))
        for w in wrenches
    ]

    def total(t: float) -> Array:
        return np.asarray(np.sum([_interpolate(t, *table) for table in tables], axis=0))

    return total


def _interpolate(t: float, times: Array, rows: Array) -> Array:
    """Linear between the times, constant outside."""
    after = int(np.searchsorted(times, t, side="right"))
    if after in (0, len(times)):
        return np.asarray(rows[min(after, len(times) - 1)])
    s = (t - times[after - 1]) / (times[after] - times[after - 1])
    return np.asarray((1.0 - s) * rows[after - 1] + s * rows[after])


def _rotation(components: Iterable[Any]) -> Array:
    """R(q/|q|) (3, 3) of a quaternion's components, (3, 3, k) of k quaternions'.

    R = 1 + (2/|q|²)(w ε^× + ε^× ε^×). Plain numbers are faster than arrays of one.
    """
    w, x, y, z = components
    s = 2.0 / (w * w + x * x + y * y + z * z)
    return np.array(
        [
            [1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)],
            [s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x)],
            [s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y)],
        ],
        dtype=np.float64,
    )


def _quaternion_rate(q: Array, rate: Array) -> Array:
    """½ q ⊗ (0, ω)."""
    w, x, y, z = q.tolist()
    a, b, c = (0.5 * rate).tolist()
    return np.array(
        [
            -x * a - y * b - z * c,
            w * a + y * c - z * b,
            w * b + z * a - x * c,
            w * c + x * b - y * a,
        ],
        dtype=np.float64,
    )


def _cross(a: Array, b: Array) -> Array:
    x, y, z = a.tolist()
    u, v, w = b.tolist()
    return np.array([y * w - z * v, z * u - x * w, x * v - y * u], dtype=np.float64)


# The builder of a model takes that model; a dictionary's type cannot say so.
_MODELS: dict[type[Model], Callable[..., Derivative]] = {
    RigidBody: _rigid_body,
    PointMass: _point_mass,
    UserModel: _user,
}
_AT_ONCE: dict[type[Model], Callable[..., Derivatives]] = {
    RigidBody: _rigid_bodies,
    PointMass: _point_masses,
}
