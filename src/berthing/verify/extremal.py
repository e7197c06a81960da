"""How nearly a plan meets Pontryagin's conditions, from its nodes, costates and multipliers.

Each residual is a share of the cost: what the Lagrangian would change by, to first order, if the
control (or state) changed by its own range over the whole phase. The equations of motion are those
of the checks, and their derivatives differences of these.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from typing import Any

import numpy as np

from berthing.clearance.separation import PairQuery
from berthing.geometry.arrays import Array
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import Plan, SeparationCostate, VehicleNodes, VehicleTrajectory
from berthing.verify.equations import derivative
from berthing.verify.optimality import hamiltonian, relative_drift
from berthing.verify.transversality import transversality
from berthing.xp import NUMPY

STEP = 1e-6
"""Of a component's range: central differences are then good to about 1e-10 of the slope."""

QUADRATURE = 4
"""Gauss points between two nodes: exact for degree 7, more than segments have."""

AT_LIMIT = 1e-6
"""Of the range between the limits: a control this near to one is at it."""

NOTHING = 1e-9
"""Of the largest range: components that move by less do not move."""

Lagrangian = Callable[[float, Array, Array, Array], float]
"""H(t, x, u, λ) of one vehicle."""


@dataclass(frozen=True)
class Extremality:
    """Residuals of the first-order conditions, the worst phase and vehicle.

    Attributes:
        stationarity: of H in the controls; at a limit only what points inwards counts.
        adjoint: of λ̇ = −∂H/∂x between nodes, jumps at separation rows included.
        transversality: of the costates at free ends; of H at the end of a free horizon.
        complementarity: Σ ν (clearance above its margin and back-off), clearances at the rows.
        dual: Σ of multipliers of the wrong sign, times the length of the way.
        drift: of the lower Hamiltonian, relative to its mean; None where time enters the problem
            through moving structures, wrenches or functions of the user's own.
    """

    stationarity: float
    adjoint: float
    transversality: float
    complementarity: float
    dual: float
    drift: float | None

    @property
    def worst(self) -> float:
        """The largest residual."""
        return max(float(v) for v in asdict(self).values() if v is not None)

    @property
    def limiting(self) -> str:
        """Which residual is the largest."""
        values = {key: value for key, value in asdict(self).items() if value is not None}
        return max(values, key=lambda key: values[key])

    @property
    def digits(self) -> float:
        """k of "Pontryagin extremal to 1e-k", rounded down to a tenth; infinite at no residual."""
        worst = self.worst
        if not worst > 0.0:
            return math.inf
        return math.floor(-10.0 * math.log10(worst)) / 10.0

    def to_json(self) -> dict[str, Any]:
        """As plan.json holds it."""
        return {**asdict(self), "worst": self.worst, "digits": self.digits}


def extremality(scenario: Scenario, plan: Plan) -> Extremality | None:
    """The residuals of a plan; None where its nodes hold no costates."""
    own = [n for n in plan.nodes if np.all(np.isfinite(n.costates))]
    if len(own) != len(plan.nodes) or not own:
        return None
    cost = max(abs(plan.cost), 1e-300)
    parts = []
    for nodes in own:
        phase = scenario.phase(nodes.phase)
        trajectory = next(p for p in plan.phases if p.phase == phase.name).vehicle(nodes.vehicle)
        rows = [s for s in plan.separations if s.phase == phase.name]
        parts.append(_vehicle(scenario, phase, nodes, trajectory, rows, cost))
    length = max(float(np.ptp(_positions(scenario, n), axis=0).max()) for n in own)
    pulls = [s.multiplier for s in plan.separations]
    slack = sum(max(s.multiplier, 0.0) * abs(room_m(scenario, plan, s)) for s in plan.separations)
    worst = np.max(np.array(parts), axis=0)
    return Extremality(
        stationarity=float(worst[0]),
        adjoint=float(worst[1]),
        transversality=max(float(worst[2]), _free_horizon(scenario, plan, cost)),
        complementarity=slack / cost,
        dual=sum(max(-pull, 0.0) for pull in pulls) * length / cost,
        drift=_drift(scenario, plan),
    )


def _vehicle(
    scenario: Scenario, phase: Phase, nodes: VehicleNodes, trajectory: VehicleTrajectory,
    rows: Sequence[SeparationCostate], cost: float,
) -> tuple[float, float, float]:  # fmt: skip
    vehicle = phase.vehicle(nodes.vehicle)
    duration = float(nodes.times_s[-1] - nodes.times_s[0])
    x_range = ranges(vehicle.model.state_names, np.ptp(nodes.states, axis=0))
    u_range = ranges(vehicle.model.control_names, np.nanmax(np.abs(nodes.controls), axis=0))
    value = hamiltonian_of(phase, vehicle)
    slopes = [
        _inward(vehicle, u_range, u, _slope(partial(_in_control, value, t, x, p), u, u_range))
        for t, x, u, p in _columns(nodes)
    ]
    stationarity = float(np.max(np.abs(slopes) * u_range)) * duration / cost
    jumps = [(s.time_s, s.jumps[vehicle.name]) for s in rows if vehicle.name in s.jumps]
    misses = adjoint_misses(nodes, trajectory, value, x_range, jumps)
    adjoint = float(np.max(np.abs(misses) * x_range)) / cost
    return stationarity, adjoint, transversality(scenario, vehicle, nodes, x_range) / cost


def _columns(nodes: VehicleNodes) -> list[tuple[float, Array, Array, Array]]:
    """(t, x, u, λ) wherever there is a control."""
    known = np.all(np.isfinite(nodes.controls), axis=1)
    parts = nodes.times_s[known], nodes.states[known], nodes.controls[known], nodes.costates[known]
    return [(float(t), x, u, p) for t, x, u, p in zip(*parts, strict=True)]


def _in_control(value: Lagrangian, t: float, x: Array, costate: Array, u: Array) -> float:
    return value(t, x, u, costate)


def _in_state(value: Lagrangian, t: float, u: Array, costate: Array, x: Array) -> float:
    return value(t, x, u, costate)


def ranges(names: Sequence[str], moved: Array) -> Array:
    """How far each component moves: the most of those with the same unit, or of all where none of
    these does, or 1."""
    units = [name.partition("_")[2] for name in names]
    most: dict[str, float] = {}
    for unit, far in zip(units, moved, strict=True):
        most[unit] = max(most.get(unit, 0.0), float(far))
    spare = max(most.values(), default=0.0) or 1.0
    return np.array([most[unit] if most[unit] > NOTHING * spare else spare for unit in units])


def adjoint_misses(
    nodes: VehicleNodes, trajectory: VehicleTrajectory, value: Lagrangian, x_range: Array,
    jumps: Sequence[tuple[float, Array]],
) -> Array:  # fmt: skip
    """λ(t_i) − λ(t_{i+1}) − ∫ ∂H/∂x dt − jumps between, (nodes − 1, nx).

    A row at the time of a node, which begins a segment, belongs to the interval before it.
    """
    points, weights = np.polynomial.legendre.leggauss(QUADRATURE)
    out = []
    breaks = trajectory.breaks_s
    scale = 1e-9 * (nodes.times_s[-1] - nodes.times_s[0])
    for i, (a, b) in enumerate(zip(nodes.times_s[:-1], nodes.times_s[1:], strict=True)):
        k = int(np.searchsorted(breaks, 0.5 * (a + b), side="right")) - 1
        t = 0.5 * (a + b) + 0.5 * (b - a) * points
        inside = (nodes.times_s >= breaks[k] - scale) & (nodes.times_s < breaks[k + 1] - scale)
        weight = _lagrange(nodes.times_s[inside], t)
        costates = weight @ nodes.costates[inside]
        columns = zip(t, trajectory.state(t), trajectory.control(t), costates, strict=True)
        slopes = [
            _slope(partial(_in_state, value, float(ti), ui, pi), xi, x_range)
            for ti, xi, ui, pi in columns
        ]
        gain = 0.5 * (b - a) * (weights @ np.array(slopes))
        inner = [jump for at, jump in jumps if a + scale < at <= b + scale]
        total = np.sum(inner, axis=0) if inner else 0.0
        out.append(nodes.costates[i] - nodes.costates[i + 1] - gain - total)
    return np.array(out)


def hamiltonian_of(phase: Phase, vehicle: Vehicle) -> Lagrangian:
    """H(t, x, u, λ) of one vehicle."""
    f = derivative(vehicle.model)
    running = [own.function for own in phase.cost.running if own.vehicle == vehicle.name]

    def value(t: float, x: Array, u: Array, costate: Array) -> float:
        total = phase.cost.control_energy * float(u @ u) + float(costate @ f(t, x, u))
        return total + sum(float(h(t, x, u, NUMPY, 1)[0]) for h in running)

    return value


def _slope(value: Callable[[Array], float], at: Array, scale: Array) -> Array:
    """Central differences of ``value``."""
    out = np.empty(len(at))
    for j in range(len(at)):
        step = np.zeros(len(at))
        step[j] = STEP * scale[j]
        out[j] = (value(at + step) - value(at - step)) / (2.0 * step[j])
    return out


def _inward(vehicle: Vehicle, scale: Array, u: Array, slope: Array) -> Array:
    """The slope without what presses against a limit."""
    limits = vehicle.limits
    near = AT_LIMIT * scale
    at_lower, at_upper = u <= limits.control_lower + near, u >= limits.control_upper - near
    return np.where((at_lower & (slope > 0.0)) | (at_upper & (slope < 0.0)), 0.0, slope)


def _lagrange(points: Array, targets: Array) -> Array:
    """(m, n) values at the points → values of their polynomial at the targets."""
    out = np.ones((len(targets), len(points)))
    for j in range(len(points)):
        for i in range(len(points)):
            if i != j:
                out[:, j] *= (targets - points[i]) / (points[j] - points[i])
    return out


def room_m(scenario: Scenario, plan: Plan, row: SeparationCostate) -> float:
    """What a pair is apart at the time of a row beyond its margin and the plan's back-off."""
    phase = scenario.phase(row.phase)
    trajectory = next(p for p in plan.phases if p.phase == phase.name)
    pair = next(p for p in scenario.pairs(phase) if p.name == row.pair)
    t = np.array([row.time_s])
    a, b = (
        (
            owner.motion.pose(t)
            if isinstance(owner, Structure)
            else owner.model.pose(trajectory.vehicle(owner.name).state(t))
        ).compose(part.placement)[0]
        for owner, part in ((pair.owner_a, pair.part_a), (pair.owner_b, pair.part_b))
    )
    distance = PairQuery(pair.part_a.shape, pair.part_b.shape).query(a, b).distance
    margin = scenario.margins.margin(pair.ref_a, pair.ref_b, row.time_s)
    return 0.0 if margin is None else distance - margin - plan.backoff_m


def _positions(scenario: Scenario, nodes: VehicleNodes) -> Array:
    return scenario.phase(nodes.phase).vehicle(nodes.vehicle).model.pose(nodes.states).position


def autonomous(scenario: Scenario, phase: Phase) -> bool:
    """Whether time enters nothing: no motion, no wrench, no function of the user's own."""
    still = all(s.motion.kind == "fixed" for s in scenario.structures)
    plain = all(
        v.model.kind in ("rigid-body", "point-mass")
        and not getattr(v.model, "wrenches", ())
        and not v.path_constraints
        for v in phase.vehicles
    )
    return still and plain and not phase.cost.running


def _drift(scenario: Scenario, plan: Plan) -> float | None:
    drifts = [
        relative_drift(hamiltonian(phase, [n for n in plan.nodes if n.phase == phase.name])[1])
        for phase in scenario.phases
        if autonomous(scenario, phase)
    ]
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
