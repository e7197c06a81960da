"""The Hamiltonian of one vehicle, what its limits add to it, and the slopes of both."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.path_constraint import PathConstraint
from berthing.scenario.phase import Phase
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import VehicleNodes, VehicleTrajectory, limit_name, path_names
from berthing.verify.equations import Derivative
from berthing.xp import NUMPY

STEP = 1e-6
"""Of a component's range: central differences are then good to about 1e-10 of the slope."""

NOTHING = 1e-9
"""Of the largest range: components that move by less do not move."""

AT_NODE = 1e-9
"""Of the duration: times nearer than this are one."""

Path = Sequence[tuple[PathConstraint, Array]]
"""Path constraints with the multipliers of their rows."""

Lagrangian = Callable[[float, Array, Array, Array], float]
"""H(t, x, u, λ) of one vehicle."""


Running = Callable[[float, Array, Array], float]
"""The user's own part of the cost a second, of the time, a state and a control."""


def running_of(phase: Phase, vehicle: Vehicle) -> Running | None:
    """Of one vehicle; None where it has none."""
    own = [cost.function for cost in phase.cost.running if cost.vehicle == vehicle.name]
    if not own:
        return None
    return lambda t, x, u: sum(float(h(t, x, u, NUMPY, 1)[0]) for h in own)


def hamiltonian_of(phase: Phase, vehicle: Vehicle, f: Derivative) -> Lagrangian:
    """H(t, x, u, λ) of one vehicle with the equations of motion f."""
    running = running_of(phase, vehicle)

    def value(t: float, x: Array, u: Array, costate: Array) -> float:
        total = phase.cost.control_energy * float(u @ u) + float(costate @ f(t, x, u))
        return total if running is None else total + running(t, x, u)

    return value


def slope(value: Callable[[Array], float], at: Array, scale: Array) -> Array:
    """Central differences (n,) of ``value`` at one place (n,)."""
    many = slopes(lambda x: np.array([[value(own)] for own in x]), at[None], scale)
    return np.asarray(many[0, 0])


def slopes(
    values: Callable[[Array], Array], at: Array, scale: Array, skip: Sequence[int] = ()
) -> Array:
    """Central differences (k, m, n) of ``values``, (k, n) → (k, m), at k places (k, n).

    Those by the components to ``skip``, which nothing depends on, are zero.
    """
    steps = STEP * scale
    found = {}
    for j in (j for j in range(len(scale)) if j not in skip):
        later, sooner = at.copy(), at.copy()
        later[:, j] += steps[j]
        sooner[:, j] -= steps[j]
        found[j] = (values(later) - values(sooner)) / (2.0 * steps[j])
    some = next(iter(found.values()))
    out = np.zeros((*some.shape, len(scale)))
    for j, own in found.items():
        out[:, :, j] = own
    return out


def positions_of(vehicle: Vehicle) -> tuple[int, ...]:
    """Columns of the position in the state of models whose equations of motion are the same
    everywhere."""
    if vehicle.model.kind not in ("rigid-body", "point-mass"):
        return ()
    names = vehicle.model.state_names
    return tuple(names.index(name) for name in ("x_m", "y_m", "z_m") if name in names)


def ranges(names: Sequence[str], moved: Array) -> Array:
    """How far each component moves: the most of those with the same unit, or of all where none of
    these does, or 1."""
    units = [name.partition("_")[2] for name in names]
    most: dict[str, float] = {}
    for unit, far in zip(units, moved, strict=True):
        most[unit] = max(most.get(unit, 0.0), float(far))
    spare = max(most.values(), default=0.0) or 1.0
    return np.array([most[unit] if most[unit] > NOTHING * spare else spare for unit in units])


def ranges_of(vehicle: Vehicle, nodes: VehicleNodes) -> tuple[Array, Array]:
    """Of the state (nx,): how far it moves; of the control (nu,): how large it gets."""
    model = vehicle.model
    return (
        ranges(model.state_names, np.ptp(nodes.states, axis=0)),
        ranges(model.control_names, np.nanmax(np.abs(nodes.controls), axis=0)),
    )


def within_segments(nodes: VehicleNodes, trajectory: VehicleTrajectory, t: Array) -> Array:
    """Weights (k, nodes) that give values at the times t (k,), none of them a break, from those at
    the nodes of the segment, its end left out."""
    breaks, times = trajectory.breaks_s, nodes.times_s
    near = AT_NODE * (times[-1] - times[0])
    out = np.zeros((len(t), len(times)))
    for row, at in enumerate(t):
        k = int(np.clip(np.searchsorted(breaks, at, side="right") - 1, 0, len(breaks) - 2))
        own = np.flatnonzero((times >= breaks[k] - near) & (times < breaks[k + 1] - near))
        for j in own:
            others = times[own[own != j]]
            out[row, j] = np.prod((at - others) / (times[j] - others))
    return out


@dataclass(frozen=True)
class Pulls:
    """Multipliers of one vehicle's limits and path constraints, along its way.

    Attributes:
        state, control: (k, nx) and (k, nu) at the nodes; positive presses at the upper limit,
            negative at the lower one.
        path: constraints with their multipliers (k, m).
        known: whether the control's are, and not to be taken for what balances the rest.
    """

    nodes: VehicleNodes
    trajectory: VehicleTrajectory
    state: Array
    control: Array
    path: tuple[tuple[PathConstraint, Array], ...]
    known: bool

    @staticmethod
    def of(vehicle: Vehicle, nodes: VehicleNodes, trajectory: VehicleTrajectory) -> Pulls:
        """As the nodes have them; zero where they have none."""
        found, none = nodes.multipliers, np.zeros(len(nodes.times_s))
        model, names = vehicle.model, set(nodes.multipliers)

        def columns(wanted: Sequence[str]) -> Array:
            return np.nan_to_num(np.stack([found.get(name, none) for name in wanted], axis=-1))

        path = tuple(
            (constraint, columns(own))
            for constraint in vehicle.path_constraints
            if (own := path_names(constraint.name, names))
        )
        limits = [limit_name(name) for name in model.control_names]
        return Pulls(
            nodes, trajectory, columns([limit_name(name) for name in model.state_names]),
            columns(limits), path, bool(names & set(limits)),
        )  # fmt: skip

    @property
    def any(self) -> bool:
        """Whether there is one that is not zero."""
        return bool(np.any(self.state) or np.any(self.control) or self.path)

    def at(self, t: float) -> tuple[Array, Array, Path]:
        """Those of the state, the control and the path constraints at a time."""
        weights = within_segments(self.nodes, self.trajectory, np.array([t]))[0]
        path = [(constraint, weights @ values) for constraint, values in self.path]
        return weights @ self.state, weights @ self.control, path

    def at_node(self, i: int) -> tuple[Array, Array, Path]:
        """Likewise at a node."""
        path = [(constraint, values[i]) for constraint, values in self.path]
        return self.state[i], self.control[i], path


def path_value(path: Sequence[tuple[PathConstraint, Array]], t: float, x: Array, u: Array) -> float:
    """Σ μ g of path constraints with their multipliers."""
    return sum(float(mu @ own.function(t, x, u, NUMPY)) for own, mu in path)
