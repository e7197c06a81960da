"""One plane from site to site, so that no solution steps through a corner between them.

Rows at instants only let the best plane turn freely in between, and a solution gains by passing an
edge through just there: on Scenario A it dips by centimetres between nodes. If the plane of a
site must part the pair at the next site too, what remains between the two is the bending of the
motion itself, acceleration times time squared over eight: a hundredth of a millimetre for
A's 0.3 s. It errs on the safe side by what the best plane turns meanwhile, which shrinks as the
square of the time between the sites.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import numpy as np

from berthing.proximity.formulation import PairFormulation, Sweeping
from berthing.scenario.pair import Pair
from berthing.scenario.vehicle import Vehicle
from berthing.transcription.elements import Index
from berthing.transcription.inputs import Inputs
from berthing.transcription.layout import PhaseLayout
from berthing.transcription.mesh import Mesh
from berthing.transcription.separation import Places, SiteRows, margin_name, part_pose
from berthing.transcription.sites import Site, node_sites

Shares = Callable[[Site, Site], bool]
"""Whether two neighbouring sites of a pair are to share a plane."""

ROUNDING = 1e-9
"""Of sums of fractions."""


@dataclass(frozen=True)
class Sweep:
    """The plane of site ``first`` holds at site ``last`` too; indices into the sites.

    Attributes:
        block: name of its variables; row: of its separation.
    """

    first: int
    last: int
    block: str
    row: int


def neighbours(sites: Sequence[Site], mesh: Mesh, within: float) -> list[tuple[int, int]]:
    """Indices of sites of one pair that follow each other within a fraction of the phase."""
    at = [mesh.fraction(site.segment, site.s) for site in sites]
    order = sorted(range(len(sites)), key=lambda i: (sites[i].pair, at[i]))
    return [
        (i, j)
        for i, j in pairwise(order)
        if sites[i].pair == sites[j].pair and at[j] - at[i] <= within
    ]


def longest_step(mesh: Mesh) -> float:
    """The longest step (a fraction of the phase) from one node's site to the next: neighbours that
    are no further apart are all that there are, where sites stand at every node."""
    at = [mesh.fraction(site.segment, site.s) for site in node_sites(mesh, 1)]
    return (1.0 + ROUNDING) * float(np.max(np.diff(at), initial=0.0))


def add_sweeps(
    layout: PhaseLayout,
    pairs: Sequence[Pair],
    formulations: Sequence[PairFormulation],
    separation: SiteRows,
    places: Places,
    within: float,
    shares: Shares,
    regulariser: float,
) -> tuple[Sweep, ...]:
    """Append a sweep for neighbouring sites of every pair whose formulation has planes."""
    sites = separation.sites
    near = neighbours(sites, layout.mesh, within)
    joined = [(i, j) for i, j in near if shares(sites[i], sites[j])]
    out: list[Sweep] = []
    for p, (pair, form) in enumerate(zip(pairs, formulations, strict=True)):
        here = [(i, j) for i, j in joined if sites[i].pair == p]
        if here and isinstance(form, Sweeping):
            out += _add_pair(layout, pair, form, separation, here, places, regulariser / len(sites))
    return tuple(out)


def _add_pair(
    layout: PhaseLayout, pair: Pair, form: Sweeping, separation: SiteRows,
    joined: Sequence[tuple[int, int]], places: Places, regulariser: float,
) -> list[Sweep]:  # fmt: skip
    inputs = Inputs()
    v = inputs.variable("v", len(form.variables))
    tau = inputs.variable("tau", form.sweep_size)
    margin, fraction = inputs.parameter("margin", 1), inputs.constant("fraction")
    t = layout.t0_s + layout.declare_duration(inputs) * fraction
    pose_a = part_pose(layout, inputs, "a", pair.owner_a, pair.part_a, t)
    pose_b = part_pose(layout, inputs, "b", pair.owner_b, pair.part_b, t)
    made = form.sweep_rows(v, tau, pose_a, pose_b, margin, layout.scale.length_m)
    kernel = inputs.kernel(made.expression, regulariser * made.regulariser)
    margins = layout.parameters.blocks[margin_name(layout.phase.name)]
    columns: dict[str, list[Index]] = {"v": [], "tau": [], "margin": [], "a": [], "b": []}
    fractions, lines, out = [], [], []
    for i, j in joined:
        site, last = separation.sites[i], separation.sites[j]
        at = layout.mesh.fraction(last.segment, last.s)
        key = f"{pair.name} from {site.segment}:{site.s!r} to {last.segment}:{last.s!r}"
        block = layout.variables.add(f"{layout.phase.name}/{key}", (form.sweep_size, 1))
        rows = layout.rows.add(
            len(made.lower), made.lower, made.upper,
            partial(_label, pair.label, layout.nominal_time(at)),
            unit_scale=layout.scale.length_m, unit="m", key=key,
        )  # fmt: skip
        columns["v"].append(layout.variables.blocks[separation.blocks[i]].indices.ravel())
        columns["tau"].append(block.indices.ravel())
        columns["margin"].append(margins.indices[j])
        for side, owner in (("a", pair.owner_a), ("b", pair.owner_b)):
            if isinstance(owner, Vehicle):
                columns[side].append(places.indices(owner.name, last))
        fractions.append(at)
        lines.append(rows)
        out.append(Sweep(i, j, block.name, int(rows[made.separation])))
    values = layout.shared_indices(len(joined)) | columns | {"fraction": fractions}
    inputs.add(layout.elements, kernel, values, np.vstack(lines))
    return out


def _label(pair: str, time_s: float, _: int) -> str:
    return f"separation[{pair}, until t = {time_s:.1f} s]"
