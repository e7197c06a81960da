"""Bodies with their centre of mass away from the reference point, and numbers out of casadi."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import casadi as ca
import numpy as np
import pytest

from berthing.dynamics.models import symbolic
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.scenario.native_state import Model
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.wrench import Wrench

Right = Callable[[float, Array, Array], Array]


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(20240611)


@pytest.fixture
def body(rng: np.random.Generator) -> Callable[..., RigidBody]:
    """A rigid body of random mass properties, c ≠ 0."""

    def draw(wrenches: tuple[Wrench, ...] = ()) -> RigidBody:
        mass, c = rng.uniform(1.0, 5.0), rng.uniform(-1.5, 1.5, size=3)
        turn = quaternion.rotation_matrix(rng.normal(size=4))
        about_centre = turn @ np.diag(rng.uniform(2.0, 3.5, size=3)) @ turn.T
        moved = (c @ c * np.eye(3) - np.outer(c, c)) / mass
        return RigidBody(mass, about_centre + moved, c, wrenches)

    return draw


@pytest.fixture
def states(rng: np.random.Generator) -> Callable[[int], Array]:
    """Random states (n, 13) of a rigid body; the quaternions are not of unit norm."""

    def draw(count: int) -> Array:
        x = rng.normal(size=(count, 13))
        x[:, 6:10] /= np.linalg.norm(x[:, 6:10], axis=1, keepdims=True)
        x[:, 6:10] *= rng.uniform(0.9, 1.1, size=(count, 1))
        return x

    return draw


@pytest.fixture
def right_hand_side() -> Callable[[Model], Right]:
    """(t, x, u) → ẋ of a model, by the casadi expressions."""

    def make(model: Model) -> Right:
        t, x = ca.SX.sym("t"), ca.SX.sym("x", len(model.state_names))
        u = ca.SX.sym("u", len(model.control_names))
        f = ca.Function("f", [t, x, u], [symbolic(model).derivative(model, t, x, u)])
        return lambda t, x, u: np.asarray(f(t, x, u)).ravel()

    return make


@pytest.fixture
def number() -> Callable[[Any], Array]:
    """A casadi expression without symbols as an array, columns flat."""

    def evaluate(expression: Any) -> Array:
        array = np.array(ca.evalf(ca.densify(ca.SX(expression))), dtype=np.float64)
        return array[:, 0] if array.shape[1] == 1 else array

    return evaluate
