"""``berthing doctor``: what is installed, and whether it solves what is known in closed form."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Any

import numpy as np
import typer

from berthing import planner
from berthing.commands.console import print_rows
from berthing.commands.exit_codes import CERTIFIED, NOT_CERTIFIED
from berthing.report.plan_json import versions
from berthing.report.verdict_table import WORDS, Row
from berthing.result import CERTIFIED as CERTIFIED_OUTCOME
from berthing.scenario.files import load
from berthing.scenario.rigid_body import RigidBody
from berthing.scenario.scenario import Scenario
from berthing.solve.parallel import cores

CASE = "free-space"
# The best trajectory is a cubic, which the collocation holds exactly: what is left is the solver's
# own tolerance, 1e-8 of its scaled cost.
MOST_RELATIVE_ERROR = 1e-6
# Packages of the extras, by the name that they are imported by.
OPTIONAL: Mapping[str, str] = {
    "trimesh": "mesh", "coacd": "mesh", "spiceypy": "export", "pyarrow": "export",
}  # fmt: skip


@dataclass(frozen=True)
class Solved:
    """The closed-form case as planned here.

    Attributes:
        outcome: as in plan.json.
        cost, expected: in N² s; NaN where no plan was found.
        seconds: of wall time.
    """

    outcome: str
    cost: float
    expected: float
    seconds: float

    @property
    def relative_error(self) -> float:
        """Of the cost."""
        return abs(self.cost / self.expected - 1.0)

    @property
    def good(self) -> bool:
        """Whether it is certified and as cheap as it can be."""
        return self.outcome == CERTIFIED_OUTCOME and self.relative_error <= MOST_RELATIVE_ERROR


def run(*, as_json: bool) -> int:
    """Print versions and the closed-form case; the exit code."""
    solved = solve_known(load(CASE))
    if as_json:
        typer.echo(json.dumps(document(solved), indent=2, ensure_ascii=False))
    else:
        print_rows(rows(solved))
    return CERTIFIED if solved.good else NOT_CERTIFIED


def solve_known(scenario: Scenario) -> Solved:
    """Plan a scenario whose best cost is known: rest to rest, nothing in the way."""
    result = planner.plan(scenario)
    if result.plan is None:
        return Solved(result.outcome, np.nan, closed_form(scenario), np.nan)
    seconds = result.plan.wall_time_s.get("total", np.nan)
    return Solved(result.outcome, result.plan.cost, closed_form(scenario), seconds)


def closed_form(scenario: Scenario) -> float:
    """The least ∫ ‖f‖² dt from rest to rest over d in T: 12 m² d²/T³, by f linear in time."""
    (phase,) = scenario.phases
    (vehicle,) = phase.vehicles
    distance = np.linalg.norm(vehicle.goal.position_m - vehicle.start.position_m)
    assert isinstance(vehicle.model, RigidBody)
    mass, duration = vehicle.model.mass_kg, phase.horizon.max_s
    return float(12.0 * mass**2 * distance**2 / duration**3)


def optional_packages() -> dict[str, bool]:
    """Which packages of the extras are there."""
    return {name: find_spec(name) is not None for name in OPTIONAL}


def document(solved: Solved) -> dict[str, Any]:
    """All of it as JSON has it."""
    error = solved.relative_error
    return {
        "versions": versions(),
        "cores": cores(),
        "optional": optional_packages(),
        "closed_form": {
            "scenario": CASE,
            "outcome": solved.outcome,
            "cost": solved.cost if np.isfinite(solved.cost) else None,
            "expected_cost": solved.expected,
            "relative_error": error if np.isfinite(error) else None,
            "wall_time_s": solved.seconds if np.isfinite(solved.seconds) else None,
            "good": solved.good,
        },
    }


def rows(solved: Solved) -> list[Row]:
    """All of it as a table."""
    there = [
        Row(name, "there" if found else f"absent; needed by berthing[{OPTIONAL[name]}] alone")
        for name, found in optional_packages().items()
    ]
    closed = [
        Row("closed-form case", CASE),
        Row("outcome", WORDS.get(solved.outcome, solved.outcome.replace("_", " ")), solved.good),
        Row("cost", f"{solved.cost:.9g}, by 12 m² d²/T³ {solved.expected:.9g}"),
        Row("relative error", f"{solved.relative_error:.1e}", solved.good),
        Row("time", f"{solved.seconds:.1f} s on {cores()} cores"),
    ]
    return [*(Row(name, found) for name, found in versions().items()), *there, *closed]
