"""The nonlinear programme of one phase: assembled here, from rows that live in their own files."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from berthing.dynamics.motion import symbolic_motion
from berthing.geometry.arrays import Array
from berthing.geometry.convex_set import ConvexSet
from berthing.geometry.pose import Pose
from berthing.proximity.formulation import PairFormulation, Sweeping
from berthing.proximity.formulations import formulate
from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.transcription.cost import phase_cost
from berthing.transcription.defects import add_cost, add_defects
from berthing.transcription.elements import Index
from berthing.transcription.ends import add_ends, end_parameters
from berthing.transcription.instants import Instant, add_instants
from berthing.transcription.lagrange import interpolation_matrix
from berthing.transcription.layout import (
    PhaseLayout,
    control_name,
    horizon_name,
    lay_out,
    state_name,
)
from berthing.transcription.limit_costates import LimitRows, PathRows
from berthing.transcription.limits import add_limits
from berthing.transcription.mesh import Mesh
from berthing.transcription.norm_slack import slack_name
from berthing.transcription.path_constraints import add_path_constraints
from berthing.transcription.scaling import phase_scale
from berthing.transcription.separation import (
    Normals,
    Places,
    SiteRows,
    add_separation,
    homotopy_name,
    margin_name,
)
from berthing.transcription.sites import Site, site_margins, site_times
from berthing.transcription.sweeps import Shares, Sweep, add_sweeps

DEFAULT_REGULARISER = 1e-3
"""Weight of the multipliers' mean square against a cost of order one: it picks one multiplier
where many will do. At 1e-3 Scenario A's cost moves by less than 1e-6 of itself."""


ShapesOf = Callable[[Pair], tuple[ConvexSet, ConvexSet]]
"""What stands for the two parts of a pair in a programme."""


def planned_shapes(pair: Pair) -> tuple[ConvexSet, ConvexSet]:
    """Their models."""
    return pair.part_a.planning_shape, pair.part_b.planning_shape


def true_shapes(pair: Pair) -> tuple[ConvexSet, ConvexSet]:
    """Themselves."""
    return pair.part_a.shape, pair.part_b.shape


INACTIVE_MARGIN_M = -1e3
"""Where a pair may touch: the row then holds with a zero normal."""


@dataclass(frozen=True)
class Motion:
    """Numbers of one phase in physical units: a guess, or what a solution says.

    Attributes:
        duration_s: of the phase.
        states: (nx, points) by vehicle.
        controls: (nu, controls) by vehicle.
    """

    duration_s: float
    states: Mapping[str, Array]
    controls: Mapping[str, Array]


@dataclass(frozen=True)
class Problem:
    """A programme min f(x, p) with rows g(x, p), and the key to its vectors.

    Attributes:
        nlp: casadi expressions ``x``, ``p``, ``f``, ``g`` and the functions of their derivatives.
        defect_rows: vehicle → rows (collocated nodes, nx) of each segment's defects.
        separation: the sites and their rows; sweeps: planes shared by two of them.
        limit_rows, path_rows: those of limits and of path constraints.
        instants: of the sites, where these are free to move within their segments.
    """

    scenario: Scenario
    phase: Phase
    mesh: Mesh
    pairs: tuple[Pair, ...]
    formulations: tuple[PairFormulation, ...]
    layout: PhaseLayout
    nlp: Mapping[str, Any]
    defect_rows: Mapping[str, Sequence[Index]]
    separation: SiteRows
    sweeps: tuple[Sweep, ...]
    limit_rows: tuple[LimitRows, ...] = ()
    path_rows: tuple[PathRows, ...] = ()
    instants: tuple[Instant, ...] = ()

    @property
    def homotopy(self) -> tuple[float, ...]:
        """Falling values of ε to solve with one after the other; one of zero where none relaxes."""
        return max((form.homotopy for form in self.formulations), key=len, default=()) or (0.0,)

    def parameter_vector(
        self, scenario: Scenario, backoff_m: float, duration_s: float, eps: float | None = None
    ) -> Array:
        """Parameters for ``scenario``, which may differ from the one built for in its numbers
        only: ends, poses of structures, margins, horizon.

        ``eps`` is the stage of the homotopy, the last one where None.
        """
        phase = scenario.phase(self.phase.name)
        values: dict[str, Any] = {
            horizon_name(phase.name): duration_s,
            homotopy_name(phase.name): self.homotopy[-1] if eps is None else eps,
        }
        for vehicle in phase.vehicles:
            for kind, end in (("start", vehicle.start), ("goal", vehicle.goal)):
                values.update(end_parameters(f"{phase.name}/{vehicle.name}/{kind}", end))
        for structure in scenario.structures:
            base = symbolic_motion(structure.motion).base(structure.motion)
            values[f"{phase.name}/{structure.name}/position"] = base.position
            values[f"{phase.name}/{structure.name}/rotation"] = base.rotation
        sites = list(self.separation.sites)
        times = site_times(sites, self.mesh, self.layout.t0_s, duration_s)
        margins = [
            INACTIVE_MARGIN_M if m is None else m + backoff_m
            for m in site_margins(scenario, phase, sites, times)
        ]
        values[margin_name(phase.name)] = np.array(margins or [0.0])
        return self.layout.parameters.join(values)

    def start_vector(
        self, scenario: Scenario, motion: Motion, normals: Normals, eps: float | None = None
    ) -> Array:
        """Variables at ``motion``, the separation's own started from its poses.

        ``eps`` is the stage of the homotopy, the last one where None.
        """
        eps = self.homotopy[-1] if eps is None else eps
        name = self.phase.name
        values: dict[str, Any] = {}
        if self.phase.horizon.is_free:
            values[horizon_name(name)] = motion.duration_s
        for vehicle in self.phase.vehicles:
            values[state_name(name, vehicle.name)] = motion.states[vehicle.name]
            values[control_name(name, vehicle.name)] = motion.controls[vehicle.name]
            values[slack_name(name, vehicle.name)] = 0.0
        sites = self.separation.sites
        values.update({own.place: site.s for own, site in zip(self.instants, sites, strict=False)})
        values.update(self._site_values(scenario, motion, normals, eps))
        values.update(self._sweep_values(scenario, motion, values))
        for vehicle in self.phase.vehicles:
            places = [place for place in self.separation.lifted if place[0] == vehicle.name]
            x = states_at(self.mesh, motion.states[vehicle.name], [place[1:] for place in places])
            columns = list(self.layout.vehicles[vehicle.name].pose_columns)
            values.update(
                {self.separation.lifted[p]: v for p, v in zip(places, x[:, columns], strict=True)}
            )
        return self.layout.variables.join(values)

    def motion(self, x: Array, duration_s: float) -> Motion:
        """The phase's numbers in a vector of variables; ``duration_s`` where it is fixed."""
        name, values = self.phase.name, self.layout.variables.split(x)
        if self.phase.horizon.is_free:
            duration_s = float(values[horizon_name(name)][0, 0])
        vehicles = [v.name for v in self.phase.vehicles]
        return Motion(
            duration_s,
            {v: values[state_name(name, v)] for v in vehicles},
            {v: values[control_name(name, v)] for v in vehicles},
        )

    def settled(self, x: Array) -> Problem:
        """With the sites where a vector of variables moves them to."""
        values, old = self.layout.variables.split(x), self.separation
        at = [float(values[own.place][0, 0]) for own in self.instants]
        sites = tuple(replace(q, s=s) for q, s in zip(old.sites, at, strict=True))
        there = {(q.segment, q.s): site.s for q, site in zip(old.sites, sites, strict=True)}
        lifted = {(v, k, there[k, s]): block for (v, k, s), block in old.lifted.items()}
        return replace(self, separation=replace(old, sites=sites, lifted=lifted))

    def cost(self, motion: Motion) -> float:
        """The phase's cost of ``motion`` in physical units, regularisers excluded."""
        return phase_cost(self.layout, motion.duration_s, motion.states, motion.controls)

    def _site_values(
        self, scenario: Scenario, motion: Motion, normals: Normals, eps: float
    ) -> dict[str, Array]:
        """Starting values of every site's own variables, by block."""
        sites = list(self.separation.sites)
        times = site_times(sites, self.mesh, self.layout.t0_s, motion.duration_s)
        values: dict[str, Array] = {}
        for p, (pair, form) in enumerate(zip(self.pairs, self.formulations, strict=True)):
            here = [i for i, site in enumerate(sites) if site.pair == p]
            if not here:
                continue
            a, b = self._part_poses(scenario, motion, pair, [sites[i] for i in here], times[here])
            starts = form.start(a, b, normals(p, a, b), eps)
            values.update({self.separation.blocks[i]: v for i, v in zip(here, starts, strict=True)})
        return values

    def _sweep_values(
        self, scenario: Scenario, motion: Motion, values: Mapping[str, Array]
    ) -> dict[str, Array]:
        """Starting values of every sweep, its plane being that of its first site."""
        sites, out = self.separation.sites, {}
        lasts = [sites[sweep.last] for sweep in self.sweeps]
        times = site_times(lasts, self.mesh, self.layout.t0_s, motion.duration_s)
        for p, (pair, form) in enumerate(zip(self.pairs, self.formulations, strict=True)):
            here = [i for i, site in enumerate(lasts) if site.pair == p]
            if not here:
                continue
            assert isinstance(form, Sweeping)
            a, b = self._part_poses(scenario, motion, pair, [lasts[i] for i in here], times[here])
            for k, i in enumerate(here):
                plane = values[self.separation.blocks[self.sweeps[i].first]]
                out[self.sweeps[i].block] = form.sweep_start(plane, a[k], b[k])
        return out

    def _part_poses(
        self, scenario: Scenario, motion: Motion, pair: Pair, sites: Sequence[Site], times_s: Array
    ) -> tuple[Pose, Pose]:
        a, b = (
            self._poses(scenario, motion, owner, sites, times_s).compose(part.placement)
            for owner, part in ((pair.owner_a, pair.part_a), (pair.owner_b, pair.part_b))
        )
        return a, b

    def _poses(
        self, scenario: Scenario, motion: Motion, owner: Vehicle | Structure,
        sites: Sequence[Site], times_s: Array,
    ) -> Pose:  # fmt: skip
        if isinstance(owner, Structure):
            return scenario.structure(owner.name).motion.pose(times_s)
        places = [(site.segment, site.s) for site in sites]
        return owner.model.pose(states_at(self.mesh, motion.states[owner.name], places))


def states_at(mesh: Mesh, states: Array, places: Sequence[tuple[int, float]]) -> Array:
    """States (n, nx) at n places (segment, local coordinate) from the states (nx, points)."""
    out = np.empty((len(places), len(states)))
    for k in {segment for segment, _ in places}:
        here = [i for i, (segment, _) in enumerate(places) if segment == k]
        nodes, offset = mesh.node_set(k), mesh.point_offset(k)
        weights = interpolation_matrix(nodes.points, np.array([places[i][1] for i in here]))
        out[here] = weights @ states[:, offset : offset + len(nodes.points)].T
    return out


def build(
    scenario: Scenario,
    phase: Phase,
    mesh: Mesh,
    sites: Sequence[Site],
    formulation: str,
    *,
    shapes_of: ShapesOf = planned_shapes,
    sweep_within: float = 0.0,
    shares: Shares = lambda first, last: True,
    regulariser: float = DEFAULT_REGULARISER,
    t0_s: float = 0.0,
    moving: bool = False,
) -> Problem:
    """Assemble the programme of ``phase`` with separation at ``sites``.

    Args:
        moving: whether sites are free to move within their segments, each to where its pair comes
            nearest; nothing then holds planes but their rows, and none are shared.
        shapes_of: what stands for the parts of a pair.
        sweep_within: sites of a pair that follow each other within this fraction of the phase
            share planes, where the formulation has any and ``shares`` says so.

    Raises:
        InputError: no such formulation.
        CapabilityError: the formulation cannot take a shape of the scenario.
    """
    pairs = scenario.pairs(phase)
    # Sets are hashed by identity: parts share a formulation where they share their shapes.
    shapes = [shapes_of(pair) for pair in pairs]
    forms = {both: formulate(formulation, *both) for both in shapes}
    formulations = tuple(forms[both] for both in shapes)
    scale = phase_scale(scenario, phase)
    layout = lay_out(phase, scenario.structures, mesh, scale, t0_s)
    defect_rows = add_defects(layout)
    add_cost(layout, scale.cost)
    add_ends(layout)
    limit_rows, path_rows = add_limits(layout), add_path_constraints(layout)
    places = Places(layout)
    instants: tuple[Instant, ...] = ()
    sweeps: tuple[Sweep, ...] = ()
    if moving:
        separation, instants = add_instants(layout, pairs, formulations, sites)
    else:
        separation = add_separation(layout, pairs, formulations, sites, places, regulariser)
        sweeps = add_sweeps(
            layout, pairs, formulations, separation, places, sweep_within, shares, regulariser
        )
    nlp = layout.elements.programme(layout.variables.size, layout.parameters.size, layout.rows.size)
    return Problem(
        scenario, phase, mesh, pairs, formulations, layout, nlp, defect_rows, separation, sweeps,
        limit_rows, path_rows, instants,
    )  # fmt: skip
