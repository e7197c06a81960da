"""The plans that claims and figures are about, each made once."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from berthing import planner
from berthing.errors import InputError
from berthing.result import ProgressEvent, Result
from berthing.scenario.files import load
from berthing.scenario.options import SolverOptions
from berthing.scenario.scenario import Scenario
from berthing.trajectory import Plan
from berthing.verify.verification import Verification


@dataclass(frozen=True)
class Planned:
    """One case with its answer."""

    scenario: Scenario
    options: SolverOptions
    result: Result
    plan: Plan
    verification: Verification

    @property
    def certified(self) -> bool:
        return self.verification.certified


CASES: Mapping[str, tuple[str, Mapping[str, Any]]] = {
    "scenario-a": ("scenario-a", {"formulation": "kkt"}),
    "scenario-a-plane": ("scenario-a", {"formulation": "plane"}),
    "scenario-a-continuation": ("scenario-a", {"guess": "paper-continuation"}),
    "scenario-a-printed": ("scenario-a-printed", {}),
    "scenario-b": ("scenario-b", {"formulation": "kkt"}),
}
"""Scenario and options by name. The first is the paper's form on exact sets."""


@dataclass
class Cases:
    """Plans on demand.

    Attributes:
        progress: is told what the planner does.
    """

    progress: Callable[[ProgressEvent], None] | None = None
    _made: dict[str, Planned] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Planned:
        """The case ``name``; InputError where no plan was found."""
        if name not in self._made:
            base, options = CASES[name]
            scenario = load(base)
            wanted = replace(scenario.solver, **options)
            result = planner.plan(scenario, options=wanted, progress=self.progress)
            if result.plan is None or result.verification is None:
                raise InputError(name, f"was not solved: {result.advice}", "a plan of it")
            self._made[name] = Planned(scenario, wanted, result, result.plan, result.verification)
        return self._made[name]
