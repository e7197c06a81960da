"""Plan collision-free, optimal motion for full-shape rigid bodies in tight spaces.

>>> import berthing as bt
>>> bt.load("free-space").name
'free-space'
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from berthing.clearance.placed_distance import distance
    from berthing.clearance.signed_distance import SignedDistance
    from berthing.geometry.body import Body, Part
    from berthing.geometry.box import Box
    from berthing.geometry.cylinder import Cylinder
    from berthing.geometry.ellipsoid import Ellipsoid
    from berthing.geometry.polytope import Polytope
    from berthing.geometry.pose import Pose
    from berthing.geometry.sphere import Sphere
    from berthing.planner import plan
    from berthing.replanning import Planner
    from berthing.routes.checker import Checker
    from berthing.routes.routing import route
    from berthing.scenario.attitude import AxisAttitude, FixedAttitude, FreeAttitude
    from berthing.scenario.cost import Cost, RunningCost
    from berthing.scenario.files import from_document, load
    from berthing.scenario.goal import End
    from berthing.scenario.horizon import Horizon
    from berthing.scenario.limits import Limits
    from berthing.scenario.margin import MarginOverride, MarginPolicy
    from berthing.scenario.motion import ConstantSpin, ConstantVelocity, Fixed
    from berthing.scenario.options import SolverOptions
    from berthing.scenario.path_constraint import PathConstraint
    from berthing.scenario.phase import Phase
    from berthing.scenario.point_mass import PointMass
    from berthing.scenario.rigid_body import RigidBody
    from berthing.scenario.scenario import Scenario
    from berthing.scenario.structure import Structure
    from berthing.scenario.tabulated import Tabulated
    from berthing.scenario.user_function import UserFunction
    from berthing.scenario.user_model import UserModel
    from berthing.scenario.vehicle import Vehicle
    from berthing.verify.folder import verify_folder

__all__ = [
    "AxisAttitude",
    "Body",
    "Box",
    "Checker",
    "ConstantSpin",
    "ConstantVelocity",
    "Cost",
    "Cylinder",
    "Ellipsoid",
    "End",
    "Fixed",
    "FixedAttitude",
    "FreeAttitude",
    "Horizon",
    "Limits",
    "MarginOverride",
    "MarginPolicy",
    "Part",
    "PathConstraint",
    "Phase",
    "Planner",
    "PointMass",
    "Polytope",
    "Pose",
    "RigidBody",
    "RunningCost",
    "Scenario",
    "SignedDistance",
    "SolverOptions",
    "Sphere",
    "Structure",
    "Tabulated",
    "UserFunction",
    "UserModel",
    "Vehicle",
    "distance",
    "from_document",
    "load",
    "plan",
    "route",
    "verify_folder",
]

# Loaded when first asked for, so that `berthing.verify` never brings the solver along.
_HOMES = {
    "plan": "berthing.planner",
    "distance": "berthing.clearance.placed_distance",
    "SignedDistance": "berthing.clearance.signed_distance",
    "Planner": "berthing.replanning",
    "Checker": "berthing.routes.checker",
    "route": "berthing.routes.routing",
    "load": "berthing.scenario.files",
    "from_document": "berthing.scenario.files",
    "verify_folder": "berthing.verify.folder",
    "Body": "berthing.geometry.body",
    "Part": "berthing.geometry.body",
    "Pose": "berthing.geometry.pose",
    "Box": "berthing.geometry.box",
    "Sphere": "berthing.geometry.sphere",
    "Ellipsoid": "berthing.geometry.ellipsoid",
    "Cylinder": "berthing.geometry.cylinder",
    "Polytope": "berthing.geometry.polytope",
    "Scenario": "berthing.scenario.scenario",
    "Phase": "berthing.scenario.phase",
    "Horizon": "berthing.scenario.horizon",
    "Cost": "berthing.scenario.cost",
    "RunningCost": "berthing.scenario.cost",
    "MarginPolicy": "berthing.scenario.margin",
    "MarginOverride": "berthing.scenario.margin",
    "SolverOptions": "berthing.scenario.options",
    "Vehicle": "berthing.scenario.vehicle",
    "Limits": "berthing.scenario.limits",
    "End": "berthing.scenario.goal",
    "PathConstraint": "berthing.scenario.path_constraint",
    "FixedAttitude": "berthing.scenario.attitude",
    "FreeAttitude": "berthing.scenario.attitude",
    "AxisAttitude": "berthing.scenario.attitude",
    "RigidBody": "berthing.scenario.rigid_body",
    "PointMass": "berthing.scenario.point_mass",
    "UserModel": "berthing.scenario.user_model",
    "UserFunction": "berthing.scenario.user_function",
    "Structure": "berthing.scenario.structure",
    "Fixed": "berthing.scenario.motion",
    "ConstantVelocity": "berthing.scenario.motion",
    "ConstantSpin": "berthing.scenario.motion",
    "Tabulated": "berthing.scenario.tabulated",
}


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        return getattr(import_module(_HOMES[name]), name)
    raise AttributeError(f"module 'berthing' has no attribute {name!r}")
