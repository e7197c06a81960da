"""Separation rows at the sites, by whichever formulation is asked for.

A site at a point of the mesh uses the state there. Elsewhere the pose's components are variables
of the site, tied to the mesh by interpolation: that keeps the Hessian's blocks as small as at a
point, where substituting would couple every point of the segment with every other.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import casadi as ca
import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.body import Part
from berthing.geometry.pose import Pose
from berthing.proximity.formulation import PairFormulation, SymPose
from berthing.scenario.pair import Pair
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.sym import Sym
from berthing.transcription.elements import Index
from berthing.transcription.inputs import Inputs
from berthing.transcription.layout import PhaseLayout
from berthing.transcription.packing import Block
from berthing.transcription.sites import Site

Normals = Callable[[int, Pose, Pose], Array]
"""(pair, poses of its parts) → unit normals (n, d), world, from A to B, that part them best."""


@dataclass(frozen=True)
class SiteRows:
    """Sites of one phase with their blocks and rows.

    Attributes:
        blocks: name of each site's block of separation variables.
        lifted: vehicle → (segment, s) → name of the block with the pose's components there.
        rows: each site's separation row in the programme.
    """

    sites: tuple[Site, ...]
    blocks: tuple[str, ...]
    lifted: dict[tuple[str, int, float], str]
    rows: tuple[int, ...]


def margin_name(phase: str) -> str:
    return f"{phase}/margins_m"


def homotopy_name(phase: str) -> str:
    return f"{phase}/homotopy"


def site_key(pair: Pair, site: Site, form: PairFormulation) -> str:
    """The same for one pair at one place of one mesh in one form, whatever other sites there are.

    Forms are told apart, for their variables and rows are not each other's, even where their
    numbers agree.
    """
    return f"{pair.name} at {site.segment}:{site.s!r}, {type(form).__name__}"


def add_separation(
    layout: PhaseLayout,
    pairs: Sequence[Pair],
    formulations: Sequence[PairFormulation],
    sites: Sequence[Site],
    places: Places,
    regulariser: float,
) -> SiteRows:
    """Append variables and rows of every site; the margin of each is a parameter.

    ``regulariser`` weighs the mean over the sites of the formulation's own in the objective.
    """
    margins = layout.parameters.add(margin_name(layout.phase.name), (max(len(sites), 1), 1))
    eps = layout.parameters.add(homotopy_name(layout.phase.name), (1, 1))
    blocks, separation_rows = [""] * len(sites), [0] * len(sites)
    for p, (pair, form) in enumerate(zip(pairs, formulations, strict=True)):
        here = {i: site for i, site in enumerate(sites) if site.pair == p}
        if here:
            kernel = PairKernel(layout, pair, form, regulariser / len(sites), fixed_fraction)
            for i, block, row in _add_pair(layout, kernel, here, places, margins, eps):
                blocks[i], separation_rows[i] = block.name, row
    return SiteRows(tuple(sites), tuple(blocks), places.names, tuple(separation_rows))


def _add_pair(
    layout: PhaseLayout,
    kernel: PairKernel,
    sites: Mapping[int, Site],
    places: Places,
    margins: Block,
    eps: Block,
) -> list[tuple[int, Block, int]]:
    """Append the sites of one pair: (number of the site, its block, its separation row)."""
    pair, variables = kernel.pair, kernel.form.variables
    columns: dict[str, list[Index]] = {"v": [], "margin": [], "eps": [], "a": [], "b": []}
    fractions, lines, out = [], [], []
    for i, site in sites.items():
        fraction = layout.mesh.fraction(site.segment, site.s)
        block = layout.variables.add(
            f"{layout.phase.name}/{site_key(pair, site, kernel.form)}", (len(variables), 1),
            lower=variables.lower, upper=variables.upper,
        )  # fmt: skip
        rows = layout.rows.add(
            len(kernel.lower), kernel.lower, kernel.upper,
            partial(_label, pair.label, layout.nominal_time(fraction)),
            unit_scale=layout.scale.length_m, unit="m",
            key=site_key(pair, site, kernel.form),
        )  # fmt: skip
        columns["v"].append(block.indices.ravel())
        columns["margin"].append(margins.indices[i])
        columns["eps"].append(eps.indices.ravel())
        for side, owner in (("a", pair.owner_a), ("b", pair.owner_b)):
            if isinstance(owner, Vehicle):
                columns[side].append(places.indices(owner.name, site))
        fractions.append(fraction)
        lines.append(rows)
        out.append((i, block, int(rows[kernel.separation])))
    values = layout.shared_indices(len(sites)) | columns | {"fraction": fractions}
    kernel.inputs.add(layout.elements, kernel.kernel, values, np.vstack(lines))
    return out


def fixed_fraction(inputs: Inputs) -> Sym:
    """The fraction of the phase as a number that each site brings along."""
    return inputs.constant("fraction")


class PairKernel:
    """The rows of one pair: its variables, margin, fraction of the phase, and what places it.

    ``declare_fraction`` declares what the fraction follows from, and returns it.
    """

    def __init__(
        self, layout: PhaseLayout, pair: Pair, form: PairFormulation, regulariser: float,
        declare_fraction: Callable[[Inputs], Sym],
    ) -> None:  # fmt: skip
        self.pair, self.form = pair, form
        self.inputs = Inputs()
        v = self.inputs.variable("v", len(form.variables))
        margin, fraction = self.inputs.parameter("margin", 1), declare_fraction(self.inputs)
        t = layout.t0_s + layout.declare_duration(self.inputs) * fraction
        pose_a = part_pose(layout, self.inputs, "a", pair.owner_a, pair.part_a, t)
        pose_b = part_pose(layout, self.inputs, "b", pair.owner_b, pair.part_b, t)
        eps = self.inputs.parameter("eps", 1) if form.homotopy else 0.0
        made = form.rows(v, pose_a, pose_b, margin, layout.scale.length_m, eps)
        self.lower, self.upper, self.separation = made.lower, made.upper, made.separation
        self.kernel = self.inputs.kernel(made.expression, regulariser * made.regulariser)


def part_pose(
    layout: PhaseLayout, inputs: Inputs, side: str, owner: Vehicle | Structure, part: Part, t: Sym
) -> SymPose:
    """Declare what places ``owner`` under the name ``side`` and return the pose of its part."""
    if isinstance(owner, Structure):
        frame = layout.declare_frame(inputs, owner.name, t)
        return _placed(frame.position, frame.rotation, part.placement)
    vehicle = layout.vehicles[owner.name]
    columns = list(vehicle.pose_columns)
    scale = vehicle.scale
    values = inputs.variable(side, len(columns), scale.state[columns], scale.state_shift[columns])
    x = ca.SX.zeros(vehicle.nx)
    x[columns] = values
    body = vehicle.kinematics(x)
    return _placed(body.position, body.rotation, part.placement)


class Places:
    """Indices of the pose's components of a vehicle wherever a site needs them."""

    def __init__(self, layout: PhaseLayout) -> None:
        self.layout = layout
        self.names: dict[tuple[str, int, float], str] = {}
        self.columns = {name: list(v.pose_columns) for name, v in layout.vehicles.items()}

    def indices(self, vehicle: str, site: Site) -> Index:
        points, weights = self.layout.interpolation(site.segment, site.s)
        columns, state = self.columns[vehicle], self.layout.vehicles[vehicle].state
        if len(points) == 1:
            return state.indices[columns, points[0]]
        key = (vehicle, site.segment, site.s)
        if key not in self.names:
            self.names[key] = self._lift(vehicle, site, points, weights).name
        return self.layout.variables.blocks[self.names[key]].indices.ravel()

    def _lift(self, vehicle: str, site: Site, points: Index, weights: Array) -> Block:
        layout, columns = self.layout, self.columns[vehicle]
        owner = layout.vehicles[vehicle]
        name = f"{layout.phase.name}/{vehicle}/pose at {site.segment}:{site.s!r}"
        block = layout.variables.add(
            name, (len(columns), 1),
            scale=owner.scale.state[columns], shift=owner.scale.state_shift[columns],
        )  # fmt: skip
        time = layout.nominal_time(layout.mesh.fraction(site.segment, site.s))
        label = partial(_lift_label, vehicle, time)
        rows = layout.rows.add(len(columns), 0.0, 0.0, label, key=name)
        # Weights sum to one, so that the shift is the same on both sides and drops out.
        layout.elements.add_linear(rows, block.indices.ravel(), -1.0)
        layout.elements.add_linear(
            rows[:, None], owner.state.indices[np.ix_(np.array(columns), points)], weights[None]
        )
        return block


def _placed(position: Sym, rotation: Sym, placement: Pose) -> SymPose:
    # Zero offsets and identities are left out, so that the expression stays as small as it is.
    if np.any(placement.position):
        position = position + ca.mtimes(rotation, ca.DM(placement.position))
    if not np.array_equal(placement.rotation, np.eye(placement.dim)):
        rotation = ca.mtimes(rotation, ca.DM(placement.rotation))
    return position, rotation


def _label(pair: str, time_s: float, _: int) -> str:
    return f"separation[{pair}, t = {time_s:.1f} s]"


def _lift_label(vehicle: str, time_s: float, _: int) -> str:
    return f"interpolation[{vehicle}, t = {time_s:.1f} s]"
