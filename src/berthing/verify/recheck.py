"""Checking a certificate without searching: bounds from its normals, and whether they cover.

A wrong normal only weakens the bound that it gives, and a claim that is missing leaves a gap, so
that no claims, however forged, certify what is not clear.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.trajectory import PhaseTrajectory
from berthing.verify.bounds import Bounds, by_pair
from berthing.verify.certificate import Certificate, Evidence, least, nothing
from berthing.verify.claimed_bounds import joined, no_leaves, proven_bounds
from berthing.verify.claims import PairClaim, PhaseClaims
from berthing.verify.closest import with_nearest
from berthing.verify.grouping import (
    Motions,
    Windows,
    by_bodies,
    frame_of,
    parts_of,
    windows_of,
)
from berthing.verify.leaves import Leaves, Samples
from berthing.verify.polynomial_motion import UnboundedAttitudeError
from berthing.verify.settings import (
    CHECKED_CERTIFICATE,
    CLAIM_TOLERANCE_M,
    TUBE_TOLERANCE,
    CertificateSettings,
)
from berthing.verify.tube import EXACT, Tube, pair_tube
from berthing.verify.verdict import PairVerdict, certified, exempt, without_claim


def check_claims(
    scenario: Scenario,
    phase: Phase,
    trajectory: PhaseTrajectory,
    claims: PhaseClaims,
    tubes: Mapping[str, Tube],
    settings: CertificateSettings = CHECKED_CERTIFICATE,
) -> Certificate:
    """The certificate of a phase as far as the claims prove it.

    Args:
        trajectory: of this phase; each vehicle's segments contiguous, coefficients finite.
        tubes: as the replay found them; wider ones that are claimed are taken instead.

    Raises:
        CapabilityError: a model, motion law or shape that the certificate does not know.
    """
    motions = Motions.along(trajectory)
    windows = windows_of(scenario, phase, motions.span_s)
    tubes, notes = _widest(tubes, claims)
    notes += _strangers(claims, windows)
    claimed = {claim.pair: claim for claim in claims.pairs}
    verdicts: dict[str, PairVerdict] = {}
    evidence: list[Evidence] = []
    closest: list[tuple[str, float, float]] = []
    for group in by_bodies(scenario.pairs(phase), windows):
        names = tuple(p.name for p in group)
        try:
            found = _checked(group, motions, windows, claimed, tubes, settings)
        except UnboundedAttitudeError as error:
            notes.append(f"{group[0].owner_a.name}: {error}")
            verdicts.update((p.name, nothing(phase, p, windows, error.t_s)) for p in group)
            continue
        for i, (name, width) in enumerate(zip(names, found.widths_m, strict=True)):
            mine = found.leaves.take(found.leaves.pair == i)
            verdicts[name] = _verdict(phase.name, name, windows, mine, width)
        notes += found.notes
        evidence.append(Evidence(group[0].owner_a.name, frame_of(group[0]), names, found.leaves))
        if found.nearest is not None:
            closest.append(found.nearest)
    start = motions.span_s[0]
    return Certificate(
        phase.name,
        tuple(verdicts.get(name) or exempt(phase.name, name, start) for name in windows),
        tuple(evidence),
        min(closest, key=lambda near: near[2], default=None),
        tuple(notes),
        tubes,
    )


def _widest(found: Mapping[str, Tube], claims: PhaseClaims) -> tuple[dict[str, Tube], list[str]]:
    """By vehicle the wider of both tubes, and what is claimed to be narrower than it is."""
    tubes, faults = {}, []
    for name, own in found.items():
        said = claims.tubes.get(name, EXACT)
        tubes[name] = Tube(
            max(own.position_m, said.position_m), max(own.attitude_rad, said.attitude_rad)
        )
        if claims.pairs and not (
            own.position_m <= said.position_m + TUBE_TOLERANCE
            and own.attitude_rad <= said.attitude_rad + TUBE_TOLERANCE
        ):
            faults.append(
                f"certificate.json gives {name} a tube of {said.position_m:.3g} m, "
                f"{said.attitude_rad:.3g} rad; the replay asks for {own.position_m:.3g} m, "
                f"{own.attitude_rad:.3g} rad"
            )
    return tubes, faults


def _strangers(claims: PhaseClaims, windows: Windows) -> list[str]:
    """Pairs that are not the scenario's, or that the file has twice."""
    names = [claim.pair for claim in claims.pairs]
    wrong = sorted({name for name in names if name not in windows or names.count(name) > 1})
    return [f"certificate.json has the pair {name[:80]!r} twice or wrongly" for name in wrong]


@dataclass(frozen=True)
class _Checked:
    """Of the pairs of two bodies: tubes, the intervals that serve, what is false, the nearest."""

    widths_m: list[float]
    leaves: Leaves
    notes: list[str]
    nearest: tuple[str, float, float] | None


def _checked(
    group: Sequence[Pair],
    motions: Motions,
    windows: Windows,
    claimed: Mapping[str, PairClaim],
    tubes: Mapping[str, Tube],
    settings: CertificateSettings,
) -> _Checked:
    names = [p.name for p in group]
    widths = [pair_tube(p, tubes) for p in group]
    bounds = Bounds(motions.bodies(group[0]), [*map(parts_of, group)], widths, settings)
    said = joined([(i, claimed[name]) for i, name in enumerate(names) if name in claimed])
    proven, values = proven_bounds(bounds, said)
    leaves, samples = [no_leaves()], [Samples.none()]
    for i, rows in by_pair(said.pair):
        for t0, t1, margin in windows[names[i]]:
            if margin is not None:
                serves = (proven[rows] >= margin) & (said.t0[rows] < t1) & (said.t1[rows] > t0)
                here = rows[serves]
                leaves.append(_serving(said.take(here), proven[here], margin))
                samples.append(_ends(said.take(here), values[here], margin, (t0, t1)))
    known = with_nearest(Samples.none(), Samples.join(samples), bounds.distances)
    nearest = least(names, known) if len(known.pair) else None
    return _Checked(widths, Leaves.join(leaves), _false(names, said, proven), nearest)


def _false(names: Sequence[str], said: Leaves, proven: Array) -> list[str]:
    """What is claimed beyond what the normals prove: of every pair the worst, if any."""
    beyond, found = said.bound - proven, []
    for i, rows in by_pair(said.pair):
        worst = rows[int(np.argmax(beyond[rows]))]
        if beyond[worst] > CLAIM_TOLERANCE_M:
            found.append(
                f"certificate.json claims {said.bound[worst]:.9g} m for {names[i]} from "
                f"t = {said.t0[worst]:.6g} to {said.t1[worst]:.6g} s, where its normals prove "
                f"{proven[worst]:.9g} m"
            )
    return found


def _serving(said: Leaves, proven: Array, margin: float) -> Leaves:
    """The same with what is proven, and the margin that it serves."""
    return replace(said, bound=proven, required=np.full(len(proven), margin))


def _ends(said: Leaves, values: Array, margin: float, window: tuple[float, float]) -> Samples:
    """Lower bounds on the distances at the ends of intervals, as far as they lie in the window."""
    t, value = np.concatenate([said.t0, said.t1]), values.T.ravel()
    ends = Samples(np.tile(said.pair, 2), t, value, np.full(len(t), margin))
    return ends.take((t >= window[0]) & (t <= window[1]))


def _verdict(
    phase: str, pair: str, windows: Windows, leaves: Leaves, width_m: float
) -> PairVerdict:
    """Certified where the intervals that serve cover each window, else the first gap."""
    needed = [(t0, t1, margin) for t0, t1, margin in windows[pair] if margin is not None]
    for t0, t1, margin in needed:
        mine = leaves.take((leaves.required == margin) & (leaves.t0 < t1) & (leaves.t1 > t0))
        gap = _gap(mine, t0, t1)
        if gap is not None:
            return without_claim(phase, pair, gap, margin, width_m)
    return certified(phase, pair, leaves, width_m)


def _gap(leaves: Leaves, t0: float, t1: float) -> tuple[float, float] | None:
    """The first stretch of [t0, t1] that no interval covers; None where all is covered."""
    order = np.argsort(leaves.t0, kind="stable")
    starts, ends = leaves.t0[order], np.maximum.accumulate(leaves.t1[order])
    covered = np.append(t0, np.maximum(ends, t0))
    uncovered = np.flatnonzero(np.append(starts, np.inf) > covered)
    first = int(uncovered[0])
    if covered[first] >= t1:
        return None
    return float(covered[first]), float(np.append(starts, t1)[first])
