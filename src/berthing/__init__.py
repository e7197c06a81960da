"""Plan collision-free, optimal motion for full-shape rigid bodies in tight spaces.

>>> import berthing as bt
>>> bt.load("free-space").name
'free-space'
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from berthing.planner import plan
    from berthing.scenario.cost import Cost, RunningCost
    from berthing.scenario.files import from_document, load
    from berthing.scenario.goal import End
    from berthing.scenario.horizon import Horizon
    from berthing.scenario.limits import Limits
    from berthing.scenario.path_constraint import PathConstraint
    from berthing.scenario.phase import Phase
    from berthing.scenario.scenario import Scenario
    from berthing.scenario.user_function import UserFunction
    from berthing.scenario.user_model import UserModel
    from berthing.scenario.vehicle import Vehicle
    from berthing.verify.folder import verify_folder

__all__ = [
    "Cost",
    "End",
    "Horizon",
    "Limits",
    "PathConstraint",
    "Phase",
    "RunningCost",
    "Scenario",
    "UserFunction",
    "UserModel",
    "Vehicle",
    "from_document",
    "load",
    "plan",
    "verify_folder",
]

# Loaded when first asked for, so that `berthing.verify` never brings the solver along.
_HOMES = {
    "plan": "berthing.planner",
    "load": "berthing.scenario.files",
    "from_document": "berthing.scenario.files",
    "verify_folder": "berthing.verify.folder",
    "Scenario": "berthing.scenario.scenario",
    "Phase": "berthing.scenario.phase",
    "Horizon": "berthing.scenario.horizon",
    "Cost": "berthing.scenario.cost",
    "RunningCost": "berthing.scenario.cost",
    "Vehicle": "berthing.scenario.vehicle",
    "Limits": "berthing.scenario.limits",
    "End": "berthing.scenario.goal",
    "PathConstraint": "berthing.scenario.path_constraint",
    "UserFunction": "berthing.scenario.user_function",
    "UserModel": "berthing.scenario.user_model",
}


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        return getattr(import_module(_HOMES[name]), name)
    raise AttributeError(f"module 'berthing' has no attribute {name!r}")
