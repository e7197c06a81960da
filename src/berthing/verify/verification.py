"""All checks of a plan together, and the one verdict."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np

from berthing.geometry.arrays import Array
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.user_model import UserModel
from berthing.trajectory import PhaseTrajectory, Plan
from berthing.verify.boundary import EndErrors, end_errors
from berthing.verify.certificate import Certificate, certify, without_proof
from berthing.verify.claims import Claims
from berthing.verify.continuity import (
    clock_faults,
    continuity_faults,
    gap_faults,
    linkage_faults,
)
from berthing.verify.extremal import Extremality
from berthing.verify.fit import require_fit
from berthing.verify.limits import Excess, excesses
from berthing.verify.optimality import drift_of
from berthing.verify.path_constraints import path_excesses
from berthing.verify.recheck import check_claims
from berthing.verify.replay import Replay, replay
from berthing.verify.settings import DEFAULT_CERTIFICATE, CertificateSettings
from berthing.verify.tube import tubes_of
from berthing.verify.verdict import UNDECIDED, PairVerdict

INDEPENDENT, SAME_SOURCE = "independent", "same_source"


@dataclass(frozen=True)
class Verification:
    """What is known of a plan, apart from the solver.

    Attributes:
        clearance_lower_bound_m: proven, of what flies, for every pair at every instant at which
            its margin is the scenario's default or more; +∞ where there is nothing to keep clear
            of, −∞ where nothing is proven. Where overrides lower a margin, ``pairs`` says what is
            proven.
        required_clearance_m: the default margin.
        backoff_m: what the planner added to the margins; recorded, not checked.
        closest_pair, closest_time_s, closest_distance_m: of the least distance met while a margin
            holds; None where there is no pair. The true minimum may lie a little below.
        replay_position_error_m, replay_attitude_error_rad: bounds, over all vehicles and
            instants, on how far the dynamics flown under its controls are from the interpolant.
        hamiltonian_relative_drift: of ``hamiltonian``, (max − min)/mean |H|, the worst phase;
            None without costates.
        limits_ok: controls, states and quaternion norms stay within their limits between nodes,
            and the user's path constraints hold there.
        model_check: ``independent``: the equations of motion used here are not the solver's;
            ``same_source``: those of a vehicle are the user's own, which both have used.
        certified: nothing was found wrong, and all that must be proven is.
        reasons: why not; each names what, where, when and by how much.
        pairs: a verdict for every pair and phase.
        ends: how far start and goal are missed. replays: of each vehicle and phase.
        hamiltonian: phase, times (k,) and H(t) − ∫ ∂H/∂t dt (k,) at the nodes.
        tube_m: the most that bounds on clearance lose to the replay error: what flies, not the
            interpolant alone, is certified.
        certificates: of each phase, with the evidence.
        optimality: residuals of its conditions, where a folder was checked that has costates.
    """

    clearance_lower_bound_m: float
    required_clearance_m: float
    backoff_m: float
    closest_pair: str | None
    closest_time_s: float | None
    closest_distance_m: float | None
    replay_position_error_m: float
    replay_attitude_error_rad: float
    hamiltonian_relative_drift: float | None
    limits_ok: bool
    model_check: str
    certified: bool
    reasons: tuple[str, ...]
    pairs: tuple[PairVerdict, ...]
    ends: tuple[EndErrors, ...]
    replays: tuple[Replay, ...]
    hamiltonian: tuple[tuple[str, Array, Array], ...]
    tube_m: float = 0.0
    certificates: tuple[Certificate, ...] = ()
    optimality: Extremality | None = None

    @property
    def undecided(self) -> bool:
        """Whether all that is missing is the decision on pairs that may well be clear."""
        return not self.certified and len(self.reasons) == sum(
            pair.verdict == UNDECIDED for pair in self.pairs
        )

    def with_reasons(self, more: Iterable[str]) -> Verification:
        """The same, found wanting for more reasons."""
        reasons = (*self.reasons, *more)
        return replace(self, reasons=reasons, certified=self.certified and not reasons)

    def to_json(self) -> dict[str, Any]:
        """As plan.json holds it; what is not finite becomes null."""
        whole = asdict(replace(self, hamiltonian=(), certificates=(), optimality=None))
        for name in ("hamiltonian", "certificates", "optimality"):
            del whole[name]
        found: dict[str, Any] = _finite(whole)
        return found


def with_costates_of(scenario: Scenario, plan: Plan, verification: Verification) -> Verification:
    """The verification of a plan that has got other costates, and is otherwise the same."""
    found = [(phase.name, *drift_of(scenario, plan, phase)) for phase in scenario.phases]
    return replace(
        verification,
        hamiltonian=tuple((name, times, values) for name, times, values, _ in found),
        hamiltonian_relative_drift=_most(drift for *_, drift in found),
    )


def _most(drifts: Iterable[float | None]) -> float | None:
    return max((drift for drift in drifts if drift is not None), default=None)


def verify(
    scenario: Scenario,
    plan: Plan,
    *,
    backoff_m: float | None = None,
    settings: CertificateSettings = DEFAULT_CERTIFICATE,
    claims: Claims | None = None,
) -> Verification:
    """Check a plan against its scenario, sharing nothing with the solver.

    Args:
        backoff_m: to record in place of the plan's own.
        settings: of the search for a certificate.
        claims: are checked in place of a search; what they do not prove is not certified.

    Raises:
        InputError: the plan does not belong to the scenario (phases, vehicles, columns), or its
            numbers are not finite.
        CapabilityError: a model, motion or shape that the checks do not know.
    """
    require_fit(scenario, plan)
    with np.errstate(all="ignore"):
        # Absurd coefficients may overflow; what is not a number proves nothing here.
        backoff = plan.backoff_m if backoff_m is None else backoff_m
        return _verify(scenario, plan, _Prover(settings, claims), backoff)


@dataclass(frozen=True)
class _Prover:
    """How clearance is proven: by a search, or from claims where there are any."""

    settings: CertificateSettings
    claims: Claims | None

    def __call__(
        self,
        scenario: Scenario,
        phase: Phase,
        trajectory: PhaseTrajectory,
        replays: Sequence[Replay],
    ) -> Certificate:
        tubes = tubes_of(replays)
        if self.claims is None:
            return certify(scenario, phase, trajectory, self.settings, tubes)
        return check_claims(scenario, phase, trajectory, self.claims.phase(phase.name), tubes)


@dataclass(frozen=True)
class _PhaseFindings:
    certificate: Certificate
    ends: list[EndErrors]
    replays: list[Replay]
    excesses: list[Excess]
    hamiltonian: tuple[str, Array, Array]
    drift: float | None

    @property
    def reasons(self) -> list[str]:
        return [
            *self.certificate.notes,
            *(pair.reason for pair in self.certificate.verdicts if pair.reason),
            *(reason for end in self.ends for reason in end.reasons),
            *(reason for own in self.replays for reason in own.reasons),
            *(excess.reason for excess in self.excesses),
        ]


def _phase_findings(
    scenario: Scenario,
    phase: Phase,
    trajectory: PhaseTrajectory,
    plan: Plan,
    prove: _Prover,
) -> _PhaseFindings:
    # Pieces that overlap or leave gaps are no motion: nothing is proven of them.
    sound = not any(gap_faults(own) for own in trajectory.vehicles)
    vehicles = [(phase.vehicle(own.vehicle), own) for own in trajectory.vehicles]
    replays = [replay(vehicle.model, own) for vehicle, own in vehicles] if sound else []
    times, values, drift = drift_of(scenario, plan, phase)
    return _PhaseFindings(
        prove(scenario, phase, trajectory, replays)
        if sound
        else without_proof(scenario, phase, trajectory),
        end_errors(scenario, phase, trajectory),
        replays,
        [
            excess
            for vehicle, own in vehicles
            for excess in (*excesses(vehicle, own), *path_excesses(vehicle, own))
        ],
        (phase.name, times, values),
        drift,
    )


def _verify(scenario: Scenario, plan: Plan, prove: _Prover, backoff_m: float) -> Verification:
    found = [
        _phase_findings(scenario, phase, own, plan, prove)
        for phase, own in zip(scenario.phases, plan.phases, strict=True)
    ]
    replays = tuple(r for f in found for r in f.replays)
    closest = min(
        (f.certificate.closest for f in found if f.certificate.closest),
        key=lambda least: least[2],
        default=(None, None, None),
    )
    reasons = (
        *clock_faults(scenario, plan.phases),
        *(fault for p in plan.phases for own in p.vehicles for fault in continuity_faults(own)),
        *(fault for pair in pairwise(plan.phases) for fault in linkage_faults(*pair)),
        *(reason for f in found for reason in f.reasons),
    )
    return Verification(
        clearance_lower_bound_m=min(
            f.certificate.bound_where_required(scenario.margins.default_m) for f in found
        ),
        required_clearance_m=scenario.margins.default_m,
        backoff_m=backoff_m,
        closest_pair=closest[0],
        closest_time_s=closest[1],
        closest_distance_m=closest[2],
        replay_position_error_m=max((r.position_error_m for r in replays), default=math.inf),
        replay_attitude_error_rad=max((r.attitude_error_rad for r in replays), default=math.inf),
        hamiltonian_relative_drift=_most(f.drift for f in found),
        limits_ok=not any(f.excesses for f in found),
        model_check=_model_check(scenario),
        certified=not reasons,
        reasons=reasons,
        pairs=tuple(v for f in found for v in f.certificate.verdicts),
        ends=tuple(e for f in found for e in f.ends),
        replays=replays,
        hamiltonian=tuple(f.hamiltonian for f in found),
        tube_m=max(f.certificate.tube_m for f in found) if replays else math.inf,
        certificates=tuple(f.certificate for f in found),
    )


def _model_check(scenario: Scenario) -> str:
    own = any(isinstance(v.model, UserModel) for p in scenario.phases for v in p.vehicles)
    return SAME_SOURCE if own else INDEPENDENT


def _finite(value: Any) -> Any:
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, Mapping):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(item) for item in value]
    return value
