"""From the leaves and samples of one pair of parts to its verdict."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from berthing.geometry.arrays import Array
from berthing.verify.leaves import Leaves, Samples, Status
from berthing.verify.settings import CertificateSettings

CERTIFIED, VIOLATED, UNDECIDED, EXEMPT = "certified", "violated", "undecided", "exempt"
# Of a pair that certificate.json does not prove; whether it is clear was not asked.
UNPROVEN = "unproven"


@dataclass(frozen=True)
class PairVerdict:
    """What is known of one pair over one phase.

    Attributes:
        phase: its name.
        pair: ``owner.part|owner.part``.
        verdict: ``certified``, ``violated``, ``undecided``, ``unproven`` where claims were to
            prove it and do not, or ``exempt`` where the pair may touch throughout.
        lower_bound_m: proven of what flies for every instant at which a margin holds; −∞ where
            nothing is proven, +∞ for an exempt pair.
        required_m: the margin of the interval that falls shortest of its own, or clears it by
            least; None for an exempt pair.
        excess_m: bound less margin on that interval: at least 0 exactly when certified.
        time_s: its middle; for a violated pair the time of the deepest sample.
        depth_m: how far the deepest sample falls short of its margin; 0 unless violated.
        violations_s: the time of the deepest sample of each stretch that violates.
        tube_m: how much nearer than the interpolant says may be what flies; part of every bound.
        gap_s: of an unproven pair the first stretch that the claims do not prove.
        lost_to_tube: the interpolant is nowhere found too near, but what flies may be: the
            dynamics want a finer mesh.
    """

    phase: str
    pair: str
    verdict: str
    lower_bound_m: float
    required_m: float | None
    excess_m: float
    time_s: float
    depth_m: float = 0.0
    violations_s: tuple[float, ...] = ()
    tube_m: float = 0.0
    gap_s: tuple[float, float] | None = None
    lost_to_tube: bool = False

    @property
    def label(self) -> str:
        """The pair as messages print it."""
        return self.pair.replace("|", ", ")

    @property
    def reason(self) -> str:
        """Why the pair is not certified; empty where it is."""
        if self.verdict == VIOLATED:
            overlap_m = self.depth_m - (self.required_m or 0.0)
            overlap = f": they overlap by {overlap_m:.3g} m" if overlap_m > 0.0 else ""
            return (
                f"clearance[{self.label}, t = {self.time_s:.6g} s] is short of "
                f"{self.required_m:g} m by {self.depth_m:.3g} m" + overlap
            )
        if self.gap_s is not None:
            return (
                f"clearance[{self.label}] of {self.required_m:g} m is not proven by "
                f"certificate.json from t = {self.gap_s[0]:.6g} to {self.gap_s[1]:.6g} s"
            )
        if self.verdict == UNDECIDED:
            blame = f"; the replay takes {self.tube_m:.3g} m" if self.lost_to_tube else ""
            return (
                f"clearance[{self.label}, t = {self.time_s:.6g} s] is undecided: no less than "
                f"{self.lower_bound_m:.9g} m is proven where {self.required_m:g} m is required"
                + blame
            )
        return ""


def certified(phase: str, pair: str, leaves: Leaves, tube_m: float) -> PairVerdict:
    """A pair whose leaves (at least one) are all proven."""
    excess = leaves.bound - leaves.required
    worst = int(np.argmin(excess))
    return PairVerdict(
        phase,
        pair,
        CERTIFIED,
        float(np.min(leaves.bound)),
        float(leaves.required[worst]),
        float(excess[worst]),
        float(0.5 * (leaves.t0[worst] + leaves.t1[worst])),
        tube_m=tube_m,
    )


def exempt(phase: str, pair: str, t0_s: float) -> PairVerdict:
    """A pair that may touch throughout."""
    return PairVerdict(phase, pair, EXEMPT, np.inf, None, np.inf, t0_s)


def unproven(phase: str, pair: str, t_s: float, required_m: float) -> PairVerdict:
    """A pair of which nothing is proven."""
    return PairVerdict(phase, pair, UNDECIDED, -np.inf, required_m, -np.inf, t_s)


def without_claim(
    phase: str, pair: str, gap_s: tuple[float, float], required_m: float, tube_m: float
) -> PairVerdict:
    """A pair that claims leave unproven over a gap."""
    nothing, time = -np.inf, gap_s[0]
    return PairVerdict(
        phase, pair, UNPROVEN, nothing, required_m, nothing, time, tube_m=tube_m, gap_s=gap_s
    )


def judge(
    phase: str,
    pair: str,
    leaves: Leaves,
    samples: Samples,
    tube_m: float,
    settings: CertificateSettings,
) -> PairVerdict:
    """The verdict of one pair from its own leaves (at least one) and samples.

    The proof rules: a sample that contradicts certified leaves is an error of the query, of some
    1e-9 m, for it is exact on the other side only up to the solver behind it.
    """
    verdict = certified(phase, pair, leaves, tube_m)
    if np.all(leaves.status == int(Status.CERTIFIED)):
        return verdict
    depth = samples.required - samples.distance
    if not np.any(depth > settings.violation_m):
        lost = bool(np.any(depth + tube_m > settings.violation_m))
        return replace(verdict, verdict=UNDECIDED, lost_to_tube=lost)
    deepest = int(np.argmax(depth))
    return replace(
        verdict,
        verdict=VIOLATED,
        required_m=float(samples.required[deepest]),
        time_s=float(samples.t[deepest]),
        depth_m=float(depth[deepest]),
        violations_s=_stretches(samples.t, depth, settings.violation_m),
    )


def _stretches(t: Array, depth: Array, threshold: float) -> tuple[float, ...]:
    """Times of the deepest sample of each run of consecutive samples deeper than the threshold."""
    order = np.argsort(t, kind="stable")
    t, depth = t[order], depth[order]
    deep = depth > threshold
    starts = np.flatnonzero(deep & ~np.append(False, deep[:-1]))
    ends = np.flatnonzero(deep & ~np.append(deep[1:], False)) + 1
    return tuple(
        float(t[i + int(np.argmax(depth[i:j]))]) for i, j in zip(starts, ends, strict=True)
    )
