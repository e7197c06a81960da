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

Lagrangian = Callable[[float, Array, Array, Array], float]
"""H(t, x, u, λ) of one vehicle."""


def hamiltonian_of(phase: Phase, vehicle: Vehicle, f: Derivative) -> Lagrangian:
    """H(t, x, u, λ) of one vehicle with the equations of motion f."""
    running = [own.function for own in phase.cost.running if own.vehicle == vehicle.name]

    def value(t: float, x: Array, u: Array, costate: Array) -> float:
        total = phase.cost.control_energy * float(u @ u) + float(costate @ f(t, x, u))
        return total + sum(float(h(t, x, u, NUMPY, 1)[0]) for h in running)

    return value


def slope(value: Callable[[Array], float], at: Array, scale: Array) -> Array:
    """Central differences of ``value``."""
    return np.asarray(slopes(lambda x: np.array([value(x)]), at, scale)[0])


def slopes(values: Callable[[Array], Array], at: Array, scale: Array) -> Array:
    """Central differences (m, n) of ``values`` (m,) by the components of ``at`` (n,)."""
    out = []
    for j in range(len(at)):
        step = np.zeros(len(at))
        step[j] = STEP * scale[j]
        out.append((values(at + step) - values(at - step)) / (2.0 * step[j]))
    return np.array(out).T


def ranges(names: Sequence[str], moved: Array) -> Array:
    """How far each component moves: the most of those with the same unit, or of all where none of
    these does, or 1."""
    units = [name.partition("_")[2] for name in names]
    most: dict[str, float] = {}
    for unit, far in zip(units, moved, strict=True):
        most[unit] = max(most.get(unit, 0.0), float(far))
    spare = max(most.values(), default=0.0) or 1.0
    return np.array([most[unit] if most[unit] > NOTHING * spare else spare for unit in units])


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

    def at(self, t: float) -> tuple[Array, Array, list[tuple[PathConstraint, Array]]]:
        """Those of the state, the control and the path constraints at a time."""
        weights = within_segments(self.nodes, self.trajectory, np.array([t]))[0]
        path = [(constraint, weights @ values) for constraint, values in self.path]
        return weights @ self.state, weights @ self.control, path

    def at_node(self, i: int) -> tuple[Array, Array, list[tuple[PathConstraint, Array]]]:
        """Likewise at a node."""
        path = [(constraint, values[i]) for constraint, values in self.path]
        return self.state[i], self.control[i], path


def path_value(path: Sequence[tuple[PathConstraint, Array]], t: float, x: Array, u: Array) -> float:
    """Σ μ g of path constraints with their multipliers."""
    return sum(float(mu @ own.function(t, x, u, NUMPY)) for own, mu in path)
