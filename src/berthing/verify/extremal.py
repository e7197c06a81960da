"""How nearly a plan meets Pontryagin's conditions, from its nodes, costates and multipliers.

Each residual is a share of the cost: the most that the Lagrangian could change by, to first order,
if at every instant every control (or state) changed by up to its own range. The equations of motion
are those of the checks, and their derivatives differences of these.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, fields, replace
from typing import Any

import numpy as np

from berthing.errors import BerthingError
from berthing.geometry.arrays import Array
from berthing.scenario.scenario import Scenario
from berthing.trajectory import Plan, VehicleNodes
from berthing.verify.adjoint import carried_back
from berthing.verify.optimality import drift_of, hamiltonian
from berthing.verify.separation_rows import rooms_m
from berthing.verify.vehicle_residuals import AT_LIMIT, VehicleWay

MOST_NODES = 5000
"""Of a folder: each takes some ten thousandths of a second. The finest meshes have a tenth."""


@dataclass(frozen=True)
class Extremality:
    """Residuals of the first-order conditions, the worst phase and vehicle.

    Attributes:
        stationarity: ∫ Σ |∂H/∂u| range dt, limits' multipliers included, at the nodes or between
            them, whichever is more; where those are not known, what presses outwards at a limit
            does not count.
        adjoint: Σ |miss| range of λ̇ = −∂H/∂x from node to node, jumps at separation rows included.
        transversality: of the costates at free ends; of H at the end of a free horizon.
        complementarity: Σ ν |clearance above its margin and back-off|, clearances at the rows, and
            ∫ |μ g| of limits and path constraints.
        dual: Σ of multipliers of the wrong sign, times the length of the way, or the range.
        primal: ∫ Σ |λ (ẋ − f)| dt: equations of motion between nodes; and Σ ν of what clearances
            at the rows fall short.
        drift: of H(t) − ∫ ∂H/∂t dt, relative to its mean; not a share of the cost.
    """

    stationarity: float
    adjoint: float
    transversality: float
    complementarity: float
    dual: float
    primal: float
    drift: float | None

    @property
    def residuals(self) -> dict[str, float]:
        """All that are shares of the cost."""
        return {own.name: getattr(self, own.name) for own in fields(self) if own.name != "drift"}

    @property
    def worst(self) -> float:
        """The largest of these; infinite where one is no number."""
        values = self.residuals.values()
        return max(values) if all(map(math.isfinite, values)) else math.inf

    @property
    def limiting(self) -> str:
        """Which of these is the largest."""
        return max(self.residuals, key=lambda key: np.nan_to_num(self.residuals[key], nan=np.inf))

    @property
    def digits(self) -> float:
        """k of "Pontryagin extremal to 1e-k", rounded down to a tenth; infinite at no residual,
        and the other way where one is no number."""
        worst = self.worst
        if worst in (0.0, math.inf):
            return math.inf if worst == 0.0 else -math.inf
        return math.floor(-10.0 * math.log10(worst)) / 10.0

    def to_json(self) -> dict[str, Any]:
        """As plan.json holds it."""
        return {**asdict(self), "worst": self.worst, "digits": self.digits}


def extremality(scenario: Scenario, plan: Plan) -> Extremality | None:
    """The residuals of a plan; None where its nodes hold no costates."""
    found = _Conditions.of(scenario, plan)
    return None if found is None else found.residuals(plan)


def checked_extremality(scenario: Scenario, plan: Plan) -> Extremality | None:
    """The residuals of a plan from a folder; None also where its numbers lead nowhere, for anybody
    may have written them, and for more nodes than a mesh has."""
    if sum(len(nodes.times_s) for nodes in plan.nodes) > MOST_NODES:
        return None
    try:
        with np.errstate(all="ignore"):
            found = extremality(scenario, plan)
    except (ArithmeticError, LookupError, ValueError, BerthingError):
        return None
    return found if found is not None and math.isfinite(found.worst) else None


def with_best_costates(scenario: Scenario, plan: Plan) -> tuple[Plan, Extremality | None]:
    """The plan with the better of two estimates of its costates, and the residuals.

    Those of the solver's multipliers are polynomials on each segment, and no good where a row
    pulls inside one. The other is the adjoint equations' own answer to the last costate and the
    rows' multipliers: what is amiss then shows in the stationarity.
    """
    conditions = _Conditions.of(scenario, plan)
    if conditions is None:
        return plan, None
    other = conditions.carried_back(plan)
    found = conditions.residuals(other)
    # What the solver's miss the adjoint equations by is a bound from below on their worst.
    if found.worst < conditions.adjoint(plan):
        return other, found
    own = conditions.residuals(plan)
    return (other, found) if found.worst < own.worst else (plan, own)


@dataclass(frozen=True)
class _Conditions:
    """What the residuals of a plan are made of, whatever its costates."""

    scenario: Scenario
    vehicles: Sequence[VehicleWay]
    rooms: Sequence[float]

    @staticmethod
    def of(scenario: Scenario, plan: Plan) -> _Conditions | None:
        """None where nodes hold no costates."""
        if not plan.nodes or not all(np.all(np.isfinite(n.costates)) for n in plan.nodes):
            return None
        vehicles = []
        for nodes in plan.nodes:
            phase = scenario.phase(nodes.phase)
            own = next(p for p in plan.phases if p.phase == phase.name).vehicle(nodes.vehicle)
            rows = [s for s in plan.separations if s.phase == phase.name]
            vehicles.append(VehicleWay.of(phase, nodes, own, rows))
        return _Conditions(scenario, vehicles, rooms_m(scenario, plan))

    def residuals(self, plan: Plan) -> Extremality:
        """With the costates of the plan."""
        cost = max(abs(plan.cost), 1e-300)
        own = [replace(v, nodes=n) for v, n in zip(self.vehicles, plan.nodes, strict=True)]
        worst = np.max([vehicle.residuals(self.scenario) for vehicle in own], axis=0) / cost
        length = max(float(np.ptp(_positions(self.scenario, n), axis=0).max()) for n in plan.nodes)
        pulls = [s.multiplier for s in plan.separations]
        rooms = list(zip(pulls, self.rooms, strict=True))
        return Extremality(
            stationarity=float(worst[0]),
            adjoint=float(worst[1]),
            transversality=max(float(worst[2]), _free_horizon(self.scenario, plan, cost)),
            complementarity=float(worst[3]) + sum(max(v, 0.0) * abs(r) for v, r in rooms) / cost,
            dual=float(worst[4]) + sum(max(-v, 0.0) for v in pulls) * length / cost,
            primal=float(worst[5]) + sum(max(v, 0.0) * max(-r, 0.0) for v, r in rooms) / cost,
            drift=_drift(self.scenario, plan),
        )

    def adjoint(self, plan: Plan) -> float:
        """That residual alone."""
        own = zip(self.vehicles, plan.nodes, strict=True)
        return max(replace(v, nodes=n).adjoint for v, n in own) / max(abs(plan.cost), 1e-300)

    def carried_back(self, plan: Plan) -> Plan:
        """The plan with all its costates carried back from the end."""
        pairs = zip(plan.nodes, self.vehicles, strict=True)
        return replace(plan, nodes=tuple(carried_back(n, v.arcs) for n, v in pairs))


def _positions(scenario: Scenario, nodes: VehicleNodes) -> Array:
    return scenario.phase(nodes.phase).vehicle(nodes.vehicle).model.pose(nodes.states).position


def _drift(scenario: Scenario, plan: Plan) -> float | None:
    drifts = [drift_of(scenario, plan, phase)[2] for phase in scenario.phases]
    return max((d for d in drifts if d is not None), default=None)


def _free_horizon(scenario: Scenario, plan: Plan, cost: float) -> float:
    """|H(T)| T where the duration is free and no bound holds it; the wrong sign of it where one
    does. Goals that move with a structure are left out: H then balances their motion."""
    worst = 0.0
    for phase, trajectory in zip(scenario.phases, plan.phases, strict=True):
        moving = any(end.frame for v in phase.vehicles for end in (v.start, v.goal))
        if not phase.horizon.is_free or moving:
            continue
        _, values = hamiltonian(phase, [n for n in plan.nodes if n.phase == phase.name])
        if not len(values):
            continue
        duration = trajectory.t1_s - trajectory.t0_s
        near = AT_LIMIT * duration
        slope = float(values[-1])
        if duration <= phase.horizon.min_s + near:
            slope = min(slope, 0.0)
        if duration >= phase.horizon.max_s - near:
            slope = max(slope, 0.0)
        worst = max(worst, abs(slope) * duration / cost)
    return worst
