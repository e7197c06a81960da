"""The certificate: for every pair of parts, at every instant, a lower bound on clearance."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.trajectory import PhaseTrajectory
from berthing.verify.bisection import Bisection
from berthing.verify.bounds import Bounds
from berthing.verify.closest import with_nearest
from berthing.verify.grouping import (
    Motions,
    Windows,
    by_bodies,
    frame_of,
    parts_of,
    windows_of,
)
from berthing.verify.leaves import Intervals, Leaves, Samples
from berthing.verify.polynomial_motion import UnboundedAttitudeError
from berthing.verify.settings import DEFAULT_CERTIFICATE, CertificateSettings
from berthing.verify.tube import Tube, pair_tube
from berthing.verify.verdict import PairVerdict, exempt, judge, unproven

NO_TUBES: Mapping[str, Tube] = {}


@dataclass(frozen=True)
class Evidence:
    """What proves the verdicts of the pairs of two bodies.

    Attributes:
        moving, frame: names of the owners; normals are in the frame of the second and point from
            the first to it. All structures at rest share one frame, ``grouping.INERTIAL``.
        pairs: names of the pairs of parts that ``leaves.pair`` counts.
    """

    moving: str
    frame: str
    pairs: tuple[str, ...]
    leaves: Leaves


@dataclass(frozen=True)
class Certificate:
    """Verdicts on one phase, in the order of ``Scenario.pairs``, and what they rest on.

    Attributes:
        phase: its name.
        closest: name of the pair, time (s) and distance (m) of the least distance of the
            interpolant met while a margin holds; None where no pair has one.
        notes: why something could not be proven, where that is so.
        tubes: around the interpolant, by vehicle.
    """

    phase: str
    verdicts: tuple[PairVerdict, ...]
    evidence: tuple[Evidence, ...]
    closest: tuple[str, float, float] | None
    notes: tuple[str, ...] = ()
    tubes: Mapping[str, Tube] = field(default_factory=dict)

    @property
    def tube_m(self) -> float:
        """The widest tube that enters a bound."""
        return max((verdict.tube_m for verdict in self.verdicts), default=0.0)

    def bound_where_required(self, margin_m: float) -> float:
        """Least bound over intervals whose margin is at least ``margin_m``; +∞ for none."""
        bounds = [e.leaves.bound[e.leaves.required >= margin_m] for e in self.evidence]
        nothing = any(v.excess_m == -np.inf for v in self.verdicts)
        return -np.inf if nothing else float(np.min(np.concatenate([[np.inf], *bounds])))


def certify(
    scenario: Scenario,
    phase: Phase,
    trajectory: PhaseTrajectory,
    settings: CertificateSettings = DEFAULT_CERTIFICATE,
    tubes: Mapping[str, Tube] | None = None,
) -> Certificate:
    """Prove the clearance of every pair over the phase, as far as it can be proven.

    Args:
        trajectory: of this phase; each vehicle's segments contiguous, coefficients finite.
        tubes: around the interpolant, by vehicle; what flies stays inside. None where the
            interpolant itself is meant.

    Raises:
        CapabilityError: a model, motion law or shape that the certificate does not know.
    """
    motions = Motions.along(trajectory)
    windows = windows_of(scenario, phase, motions.span_s)
    return certify_motions(scenario, phase, motions, windows, settings, tubes or {})


def certify_motions(
    scenario: Scenario,
    phase: Phase,
    motions: Motions,
    windows: Windows,
    settings: CertificateSettings = DEFAULT_CERTIFICATE,
    tubes: Mapping[str, Tube] = NO_TUBES,
) -> Certificate:
    """The same of motions that are no interpolant of a plan, with the margins of ``windows``.

    Raises:
        CapabilityError: as above.
    """
    verdicts: dict[str, PairVerdict] = {}
    evidence: list[Evidence] = []
    closest: list[tuple[str, float, float]] = []
    notes: list[str] = []
    for group in by_bodies(scenario.pairs(phase), windows):
        names = tuple(p.name for p in group)
        widths = [pair_tube(p, tubes) for p in group]
        try:
            bounds = Bounds(motions.bodies(group[0]), [*map(parts_of, group)], widths, settings)
        except UnboundedAttitudeError as error:
            notes.append(f"{group[0].owner_a.name}: {error}")
            verdicts.update((p.name, nothing(phase, p, windows, error.t_s)) for p in group)
            continue
        search = Bisection(bounds, widths, settings)
        leaves, samples = search.run(_roots(bounds.bodies.edges_s, [windows[n] for n in names]))
        for i, name in enumerate(names):
            mine = leaves.take(leaves.pair == i), samples.take(samples.pair == i)
            verdicts[name] = judge(phase.name, name, *mine, widths[i], settings)
        evidence.append(Evidence(group[0].owner_a.name, frame_of(group[0]), names, leaves))
        closest.append(least(names, with_nearest(samples, search.far, bounds.distances)))
    return Certificate(
        phase.name,
        tuple(
            verdicts.get(name) or exempt(phase.name, name, motions.span_s[0]) for name in windows
        ),
        tuple(evidence),
        min(closest, key=lambda found: found[2], default=None),
        tuple(notes),
        tubes,
    )


def without_proof(scenario: Scenario, phase: Phase, trajectory: PhaseTrajectory) -> Certificate:
    """Of a trajectory that is no motion: nothing is proven."""
    span = trajectory.t0_s, trajectory.t1_s
    verdicts = []
    for p in scenario.pairs(phase):
        margins = [m for _, _, m in scenario.margins.windows(p.ref_a, p.ref_b, span)]
        required = max((m for m in margins if m is not None), default=None)
        verdicts.append(
            exempt(phase.name, p.name, span[0])
            if required is None
            else unproven(phase.name, p.name, span[0], required)
        )
    return Certificate(phase.name, tuple(verdicts), (), None)


def _roots(
    edges: Array, windows: Sequence[Sequence[tuple[float, float, float | None]]]
) -> Intervals:
    """Intervals between edges and ends of windows of each pair, without those of no margin."""
    pairs, starts, ends, required = [], [], [], []
    for i, own in enumerate(windows):
        for t0, t1, margin in own:
            if margin is not None:
                cuts = np.concatenate([[t0], edges[(edges > t0) & (edges < t1)], [t1]])
                count = len(cuts) - 1
                pairs.append(np.full(count, i))
                starts.append(cuts[:-1])
                ends.append(cuts[1:])
                required.append(np.full(count, margin))
    return Intervals.unasked(*map(np.concatenate, (pairs, starts, ends, required)))


def least(names: Sequence[str], samples: Samples) -> tuple[str, float, float]:
    """Pair, time and distance of the nearest of the samples, of which there is at least one."""
    i = int(np.argmin(samples.distance))
    return names[samples.pair[i]], float(samples.t[i]), float(samples.distance[i])


def nothing(phase: Phase, pair: Pair, windows: Windows, t_s: float) -> PairVerdict:
    """The verdict on a pair of which nothing can be said from the time t on."""
    required = max(margin for _, _, margin in windows[pair.name] if margin is not None)
    return unproven(phase.name, pair.name, t_s, required)
