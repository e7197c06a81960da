"""The certificate: for every pair of parts, at every instant, a lower bound on clearance."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from berthing.geometry.arrays import Array
from berthing.geometry.body import Part
from berthing.geometry.pose import Pose
from berthing.scenario.motion import Fixed
from berthing.scenario.pair import Pair
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.structure import Structure
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import PhaseTrajectory
from berthing.verify.bisection import Bisection
from berthing.verify.body_motion import BodyMotion
from berthing.verify.closest import with_nearest
from berthing.verify.frames import structure_motion, vehicle_motion
from berthing.verify.leaves import Intervals, Leaves, Samples
from berthing.verify.pair_motion import BodyPair
from berthing.verify.part_pair import PartPair
from berthing.verify.polynomial_motion import UnboundedAttitudeError
from berthing.verify.settings import DEFAULT_CERTIFICATE, CertificateSettings
from berthing.verify.verdict import PairVerdict, exempt, judge, unproven

INERTIAL = ""

Windows = Mapping[str, Sequence[tuple[float, float, float | None]]]


@dataclass(frozen=True)
class Evidence:
    """What proves the verdicts of the pairs of two bodies.

    Attributes:
        moving, frame: names of the owners; normals are in the frame of the second and point from
            the first to it. All structures at rest share the inertial frame, ``INERTIAL``.
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
        closest: name of the pair, time (s) and distance (m) of the least distance met while a
            margin holds; None where no pair has one.
        notes: why nothing could be proven, where that is so.
    """

    verdicts: tuple[PairVerdict, ...]
    evidence: tuple[Evidence, ...]
    closest: tuple[str, float, float] | None
    notes: tuple[str, ...] = ()

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
) -> Certificate:
    """Prove the clearance of every pair over the phase, as far as it can be proven.

    Args:
        trajectory: of this phase; each vehicle's segments contiguous, coefficients finite.

    Raises:
        CapabilityError: a model, motion law or shape that the certificate does not know.
    """
    pairs, motions = scenario.pairs(phase), _Motions(trajectory)
    windows: Windows = {
        p.name: scenario.margins.windows(p.ref_a, p.ref_b, motions.span_s) for p in pairs
    }
    verdicts: dict[str, PairVerdict] = {}
    evidence: list[Evidence] = []
    closest: list[tuple[str, float, float]] = []
    notes: list[str] = []
    for group in _by_bodies(pairs, windows):
        a, frame = group[0].owner_a, _frame(group[0])
        try:
            bodies = BodyPair(motions.of(a), motions.of(group[0].owner_b))
        except UnboundedAttitudeError as error:
            notes.append(f"{a.name}: {error}")
            verdicts.update((p.name, _nothing(phase, p, windows, error.t_s)) for p in group)
            continue
        names = tuple(p.name for p in group)
        search = Bisection(bodies, [PartPair(p.part_a, _in_frame(p)) for p in group], settings)
        leaves, samples = search.run(_roots(bodies.edges_s, [windows[n] for n in names]))
        for i, name in enumerate(names):
            mine = leaves.take(leaves.pair == i), samples.take(samples.pair == i)
            verdicts[name] = judge(phase.name, name, *mine, settings)
        evidence.append(Evidence(a.name, frame, names, leaves))
        closest.append(_least(names, with_nearest(samples, search.far, search.distances)))
    return Certificate(
        tuple(
            verdicts.get(name) or exempt(phase.name, name, motions.span_s[0]) for name in windows
        ),
        tuple(evidence),
        min(closest, key=lambda found: found[2], default=None),
        tuple(notes),
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
    return Certificate(tuple(verdicts), (), None)


class _Motions:
    """Motions of the frames, each built once."""

    def __init__(self, trajectory: PhaseTrajectory) -> None:
        self._trajectory = trajectory
        self.span_s = trajectory.t0_s, trajectory.t1_s
        self._built: dict[str, BodyMotion] = {}

    def of(self, owner: Vehicle | Structure) -> BodyMotion:
        if owner.name not in self._built:
            self._built[owner.name] = self._build(owner)
        return self._built[owner.name]

    def _build(self, owner: Vehicle | Structure) -> BodyMotion:
        if _rests(owner):
            return structure_motion(Fixed(Pose.identity()), self.span_s)
        if isinstance(owner, Structure):
            return structure_motion(owner.motion, self.span_s)
        return vehicle_motion(owner.model, self._trajectory.vehicle(owner.name))


def _by_bodies(pairs: Sequence[Pair], windows: Windows) -> list[list[Pair]]:
    """Pairs that some margin concerns, those of the same two bodies together."""
    groups: dict[tuple[str, str], list[Pair]] = {}
    for pair in pairs:
        if any(margin is not None for _, _, margin in windows[pair.name]):
            groups.setdefault((pair.owner_a.name, _frame(pair)), []).append(pair)
    return list(groups.values())


def _rests(owner: Vehicle | Structure) -> bool:
    return isinstance(owner, Structure) and isinstance(owner.motion, Fixed)


def _frame(pair: Pair) -> str:
    return INERTIAL if _rests(pair.owner_b) else pair.owner_b.name


def _in_frame(pair: Pair) -> Part:
    """The second part in the frame that its body is taken in."""
    owner, part = pair.owner_b, pair.part_b
    if isinstance(owner, Structure) and isinstance(owner.motion, Fixed):
        return Part(part.name, part.shape, owner.motion.fixed_pose.compose(part.placement))
    return part


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


def _least(names: Sequence[str], samples: Samples) -> tuple[str, float, float]:
    i = int(np.argmin(samples.distance))
    return names[samples.pair[i]], float(samples.t[i]), float(samples.distance[i])


def _nothing(phase: Phase, pair: Pair, windows: Windows, t_s: float) -> PairVerdict:
    required = max(margin for _, _, margin in windows[pair.name] if margin is not None)
    return unproven(phase.name, pair.name, t_s, required)
