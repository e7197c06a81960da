"""The table of models: which expressions belong to which data."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from berthing.dynamics import point_mass, rigid_body, user_model
from berthing.dynamics.kinematics import Kinematics
from berthing.errors import CapabilityError
from berthing.scenario.native_state import Model
from berthing.scenario.point_mass import PointMass
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.user_model import UserModel
from berthing.sym import Sym


@dataclass(frozen=True)
class SymbolicModel:
    """Casadi forms of a model.

    Attributes:
        derivative: (model, t, x, u) → ẋ.
        kinematics: (model, x) → pose and rates.
    """

    derivative: Callable[[Any, Sym, Sym, Sym], Sym]
    kinematics: Callable[[Any, Sym], Kinematics]


MODELS: dict[type[Model], SymbolicModel] = {
    RigidBody: SymbolicModel(rigid_body.derivative, rigid_body.kinematics),
    PointMass: SymbolicModel(point_mass.derivative, point_mass.kinematics),
    UserModel: SymbolicModel(user_model.derivative, user_model.kinematics),
}


def symbolic(model: Model) -> SymbolicModel:
    """The casadi forms of ``model``; CapabilityError where none are registered."""
    try:
        return MODELS[type(model)]
    except KeyError:
        known = ", ".join(sorted(t.__name__ for t in MODELS))
        raise CapabilityError(
            f"no equations of motion for the model {type(model).__name__}; there are {known}"
        ) from None
