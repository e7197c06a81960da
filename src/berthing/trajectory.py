"""Frozen interpolants and the plan they make up.

A trajectory is piecewise polynomial. Each segment carries Chebyshev coefficients on its own
[t0, t1], one column a component, so that a component is bounded on the whole segment by the sum
of the absolute values of its coefficients, and a sub-interval by those of its restriction.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.polynomial import chebyshev

from berthing.geometry.arrays import Array

BASIS = "chebyshev"
CONTROL_INTERPOLATIONS = ("polynomial", "linear", "constant")


@dataclass(frozen=True)
class Segment:
    """One polynomial piece.

    Attributes:
        t0_s, t1_s: its ends.
        state: Chebyshev coefficients (degree + 1, nx) of the native state on [t0, t1].
        control: likewise (degree + 1, nu) of the native control.
    """

    t0_s: float
    t1_s: float
    state: Array
    control: Array

    def local(self, t: Array) -> Array:
        """Map times [t0, t1] → [-1, 1]."""
        return np.asarray((2.0 * t - self.t0_s - self.t1_s) / (self.t1_s - self.t0_s))


def evaluate(coefficients: Array, s: Array) -> Array:
    """Values (k, n) at the local coordinates s (k,) of the coefficients (degree + 1, n)."""
    if not len(s):
        return np.empty((0, coefficients.shape[1]))
    return np.asarray(chebyshev.chebval(s, coefficients).T, dtype=np.float64)


def derivative(coefficients: Array, span_s: float) -> Array:
    """Chebyshev coefficients of the derivative in time, a segment lasting ``span_s``."""
    if len(coefficients) == 1:
        return np.zeros_like(coefficients)
    return np.asarray(chebyshev.chebder(coefficients), dtype=np.float64) * (2.0 / span_s)


@dataclass(frozen=True)
class VehicleTrajectory:
    """The motion of one vehicle in one phase.

    Attributes:
        vehicle: its name in the scenario.
        model: the kind of its dynamics model, e.g. ``rigid-body``.
        state_names, control_names: the columns, units in the names.
        segments: contiguous, in order of time.
        control_interpolation: one of ``CONTROL_INTERPOLATIONS``; what flies between samples.
    """

    vehicle: str
    model: str
    state_names: tuple[str, ...]
    control_names: tuple[str, ...]
    segments: tuple[Segment, ...]
    control_interpolation: str = "polynomial"

    @property
    def t0_s(self) -> float:
        return self.segments[0].t0_s

    @property
    def t1_s(self) -> float:
        return self.segments[-1].t1_s

    @property
    def breaks_s(self) -> Array:
        """Segment ends (segments + 1,)."""
        return np.array([self.t0_s, *(s.t1_s for s in self.segments)])

    def state(self, t: Array) -> Array:
        """Native states (k, nx) at the times t (k,)."""
        return self._sample(t, lambda s: s.state)

    def state_rate(self, t: Array) -> Array:
        """Derivative in time (k, nx) of the interpolated states at the times t (k,)."""
        return self._sample(t, lambda s: derivative(s.state, s.t1_s - s.t0_s))

    def control(self, t: Array) -> Array:
        """Native controls (k, nu) at the times t (k,)."""
        return self._sample(t, lambda s: s.control)

    def _sample(self, t: Array, coefficients: Any) -> Array:
        t = np.atleast_1d(np.asarray(t, dtype=np.float64))
        index = np.clip(np.searchsorted(self.breaks_s, t, side="right") - 1, 0, None)
        index = np.minimum(index, len(self.segments) - 1)
        out = np.empty((len(t), coefficients(self.segments[0]).shape[1]))
        for i in np.unique(index):
            here = index == i
            segment = self.segments[i]
            out[here] = evaluate(coefficients(segment), segment.local(t[here]))
        return out


@dataclass(frozen=True)
class PhaseTrajectory:
    """All vehicles over one phase; they share one clock."""

    phase: str
    vehicles: tuple[VehicleTrajectory, ...]

    @property
    def t0_s(self) -> float:
        return self.vehicles[0].t0_s

    @property
    def t1_s(self) -> float:
        return self.vehicles[0].t1_s

    def vehicle(self, name: str) -> VehicleTrajectory:
        """The trajectory of the vehicle called ``name``; KeyError where there is none."""
        for trajectory in self.vehicles:
            if trajectory.vehicle == name:
                return trajectory
        raise KeyError(f"no vehicle {name!r}; there are {[v.vehicle for v in self.vehicles]}")


@dataclass(frozen=True)
class VehicleNodes:
    """What the solver held at its own nodes for one vehicle of one phase.

    Attributes:
        phase, vehicle: names.
        times_s: (k,).
        states: (k, nx).
        controls: (k, nu); a row is NaN where the scheme has no control at that node.
        costates: (k, nx), of the cost in physical units: H = L + costate · f.
            NaN where the scheme has none.
        multipliers: (k,) of limits and path constraints by ``limit_name`` and ``path_names``, cost
            a unit and second; NaN where there is no control. Limits that nothing is known of are
            not among them.
    """

    phase: str
    vehicle: str
    times_s: Array
    states: Array
    controls: Array
    costates: Array
    multipliers: Mapping[str, Array] = field(default_factory=dict)


def limit_name(component: str) -> str:
    """What the multiplier of a state's or control's limits is called: positive presses at the
    upper limit, negative at the lower one."""
    return f"limit_{component}"


def path_name(constraint: str, row: int) -> str:
    """What the multiplier of a row of a path constraint g ≤ 0 is called."""
    return f"path_{constraint}_{row}"


def path_names(constraint: str, among: Iterable[str]) -> list[str]:
    """Those of the rows of a constraint that are among the names, in order."""
    known = set(among)
    found: list[str] = []
    while (name := path_name(constraint, len(found))) in known:
        found.append(name)
    return found


@dataclass(frozen=True)
class SeparationCostate:
    """The multiplier of one separation row.

    Attributes:
        phase, pair: names. time_s: of the row.
        multiplier: ν, of the cost in physical units, a metre of clearance.
        jumps: vehicle → (nx,) what the costate before has more than the one after: the gradient
            of −ν times the clearance in the native state.
    """

    phase: str
    pair: str
    time_s: float
    multiplier: float
    jumps: Mapping[str, Array]


@dataclass(frozen=True)
class Plan:
    """A trajectory with the record of how it was found; it claims nothing about safety.

    Attributes:
        cost_per_margin: by how much the least cost rises with all margins, per metre, from the
            multipliers of the separation rows; None where they are not known.
        separations: the multipliers of separation rows.
    """

    scenario_name: str
    phases: tuple[PhaseTrajectory, ...]
    nodes: tuple[VehicleNodes, ...]
    formulation: str
    scheme: str
    cost: float
    iterations: int
    seed: int
    backoff_m: float
    wall_time_s: Mapping[str, float] = field(default_factory=dict)
    cost_per_margin: float | None = None
    separations: tuple[SeparationCostate, ...] = ()

    @property
    def node_count(self) -> int:
        """Nodes of the first vehicle over all phases."""
        first = self.nodes[0].vehicle
        return sum(len(n.times_s) for n in self.nodes if n.vehicle == first)
