"""Separation at instants that are variables: where a pair comes nearest, whenever that is.

A row at a fixed time lets an edge slip past between two of them; a row at the instant of least
clearance does not, and needs no neighbours. The instant is a variable s of its segment. In the row
gap(n, x(s)) ≥ d, with multiplier λ > 0, stationarity in s is λ ∂gap/∂s = 0: the instant is one at
which the clearance neither falls nor rises. So the conditions of optimality, taken as equations,
hold where the clearance is least, though a minimiser left free to choose s would choose the
greatest: these programmes are for Newton's method, not for a minimiser.

How the clearance's least value moves with the motion, the shift of its instant included, is then
in the derivatives exactly: a path past a corner may slide along itself at no cost.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import casadi as ca
import numpy as np

from berthing.geometry.arrays import Array
from berthing.proximity.formulation import PairFormulation
from berthing.scenario.pair import Pair
from berthing.scenario.vehicle import Vehicle
from berthing.sym import Sym
from berthing.transcription.elements import Index
from berthing.transcription.inputs import Inputs
from berthing.transcription.layout import PhaseLayout, VehicleLayout
from berthing.transcription.packing import Block
from berthing.transcription.separation import PairKernel, SiteRows, homotopy_name, margin_name
from berthing.transcription.sites import Site


@dataclass(frozen=True)
class Instant:
    """What belongs to one site that moves.

    Attributes:
        place: name of the block with its local coordinate s.
        variables: all of its own, s included; rows: likewise.
        gap: the row of its separation.
    """

    place: str
    variables: Index
    rows: Index
    gap: int


def add_instants(
    layout: PhaseLayout,
    pairs: Sequence[Pair],
    formulations: Sequence[PairFormulation],
    sites: Sequence[Site],
) -> tuple[SiteRows, tuple[Instant, ...]]:
    """Append variables and rows of every site, its s among them."""
    name = layout.phase.name
    layout.parameters.add(margin_name(name), (max(len(sites), 1), 1))
    layout.parameters.add(homotopy_name(name), (1, 1))
    kernels: dict[int, PairKernel] = {}
    blocks: list[str] = []
    instants: list[Instant] = []
    lifted: dict[tuple[str, int, float], str] = {}
    for i, site in enumerate(sites):
        pair, form = pairs[site.pair], formulations[site.pair]
        if site.pair not in kernels:
            kernels[site.pair] = PairKernel(layout, pair, form, 0.0, _moving_fraction)
        key = f"{name}/{pair.name}, instant {i}"
        place = layout.variables.add(f"{key}, s", (1, 1))
        poses = {
            owner.name: _lift(layout, layout.vehicles[owner.name], site, place, key)
            for owner in (pair.owner_a, pair.owner_b)
            if isinstance(owner, Vehicle)
        }
        block, rows, gap = _add_site(layout, kernels[site.pair], i, site, place, poses, key)
        own = [place, block, *(pose for pose, _ in poses.values())]
        instants.append(
            Instant(
                place.name,
                np.concatenate([b.indices.ravel() for b in own]),
                np.concatenate([rows, *(r for _, r in poses.values())]),
                gap,
            )
        )
        blocks.append(block.name)
        lifted |= {(v, site.segment, site.s): pose.name for v, (pose, _) in poses.items()}
    rows_of = tuple(instant.gap for instant in instants)
    return SiteRows(tuple(sites), tuple(blocks), lifted, rows_of), tuple(instants)


def _moving_fraction(inputs: Inputs) -> Sym:
    s = inputs.variable("s", 1)
    return inputs.constant("begin") + 0.5 * inputs.constant("width") * (s + 1.0)


def _add_site(
    layout: PhaseLayout, kernel: PairKernel, i: int, site: Site, place: Block,
    poses: dict[str, tuple[Block, Index]], key: str,
) -> tuple[Block, Index, int]:  # fmt: skip
    """The block of a site's plane, its rows, and which of them is the separation."""
    pair, variables = kernel.pair, kernel.form.variables
    block = layout.variables.add(
        key, (len(variables), 1), lower=variables.lower, upper=variables.upper
    )
    label = f"separation[{pair.label}, instant {i}]"
    rows = layout.rows.add(
        len(kernel.lower), kernel.lower, kernel.upper, partial(_label, label),
        unit_scale=layout.scale.length_m, unit="m", key=key,
    )  # fmt: skip
    breaks = layout.mesh.breaks
    margins = layout.parameters.blocks[margin_name(layout.phase.name)]
    eps = layout.parameters.blocks[homotopy_name(layout.phase.name)]
    values = layout.shared_indices(1) | {
        "v": block.indices.ravel(), "margin": margins.indices[i], "eps": eps.indices.ravel(),
        "s": place.indices.ravel(), "begin": [breaks[site.segment]],
        "width": [breaks[site.segment + 1] - breaks[site.segment]],
    }  # fmt: skip
    for side, owner in (("a", pair.owner_a), ("b", pair.owner_b)):
        if owner.name in poses:
            values[side] = poses[owner.name][0].indices.ravel()
    kernel.inputs.add(layout.elements, kernel.kernel, values, rows)
    return block, rows, int(rows[kernel.separation])


def _lift(
    layout: PhaseLayout, owner: VehicleLayout, site: Site, place: Block, key: str
) -> tuple[Block, Index]:
    """The pose's components at the instant, tied to the points of its segment; and those rows."""
    columns, scale = list(owner.pose_columns), owner.scale
    nodes, offset = layout.mesh.node_set(site.segment), layout.mesh.point_offset(site.segment)
    count = len(nodes.points)
    block = layout.variables.add(
        f"{key}, pose of {owner.vehicle.name}", (len(columns), 1),
        scale=scale.state[columns], shift=scale.state_shift[columns],
    )  # fmt: skip
    label = partial(_label, f"interpolation[{owner.vehicle.name}, {key}]")
    rows = layout.rows.add(len(columns), 0.0, 0.0, label, key=block.name)
    inputs = Inputs()
    s, pose = inputs.variable("s", 1), inputs.variable("pose", len(columns))
    points = ca.reshape(inputs.variable("points", len(columns) * count), len(columns), count)
    # Stored values will do: weights sum to one, so that shifts drop out.
    kernel = inputs.kernel(ca.mtimes(points, lagrange_weights(nodes.points, s)) - pose)
    indices = owner.state.indices[np.ix_(columns, range(offset, offset + count))]
    values = {"s": place.indices.ravel(), "pose": block.indices.ravel(),
              "points": indices.ravel(order="F")}  # fmt: skip
    inputs.add(layout.elements, kernel, values, rows)
    return block, rows


def lagrange_weights(points: Array, s: Sym) -> Sym:
    """Weights (n, 1) of the values at the points (n,) in the value at s, as polynomials of s."""
    gaps = points[:, None] - points[None, :]
    np.fill_diagonal(gaps, 1.0)
    scale = np.prod(gaps, axis=1)
    return ca.vertcat(
        *(
            ca.SX(ca.mtimes([s - p for j, p in enumerate(points) if j != i])) / scale[i]
            for i in range(len(points))
        )
    )


def _label(name: str, _: int) -> str:
    return name
