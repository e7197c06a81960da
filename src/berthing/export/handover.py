"""What is handed over: a plan folder as the formats see it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from berthing.errors import InputError
from berthing.export.formats import Format
from berthing.export.meta import Meta
from berthing.export.samples import Samples, even_times, sample
from berthing.scenario.normal import document_sha256
from berthing.scenario.phase import Phase
from berthing.scenario.scenario import Scenario
from berthing.scenario.suggest import did_you_mean
from berthing.scenario.vehicle import Vehicle
from berthing.trajectory import Plan, VehicleTrajectory
from berthing.trajectory_io import read_interpolant, read_object
from berthing.trajectory_io.strict_json import text
from berthing.verify.continuity import clock_faults, gap_faults
from berthing.verify.fit import require_fit
from berthing.verify.folder import INTERPOLANT_JSON, PLAN_JSON, read_plan


@dataclass(frozen=True, eq=False)
class Track:
    """One vehicle in one phase.

    Attributes:
        phase: with its name.
        vehicle: as it is in that phase.
        trajectory: its polynomials.
        samples: at whole microseconds, breaks among them.
    """

    phase: Phase
    vehicle: Vehicle
    trajectory: VehicleTrajectory
    samples: Samples

    @property
    def name(self) -> str:
        """Of the vehicle."""
        return self.vehicle.name


@dataclass(frozen=True, eq=False)
class Handover:
    """A plan on its way to somebody else.

    Attributes:
        scenario: the whole of it.
        outcome: what plan.json says of the plan, unchecked.
        meta: clock, frame and identities.
        tracks: by phase in order of time, then by vehicle.
    """

    scenario: Scenario
    outcome: str
    meta: Meta
    tracks: tuple[Track, ...]

    @property
    def vehicles(self) -> tuple[str, ...]:
        """Names, each once."""
        return tuple(dict.fromkeys(track.name for track in self.tracks))

    def of(self, vehicle: str) -> tuple[Track, ...]:
        """The tracks of one vehicle, in order of time."""
        return tuple(track for track in self.tracks if track.name == vehicle)

    @property
    def span_s(self) -> tuple[float, float]:
        """From the first instant to the last."""
        return (
            min(track.trajectory.t0_s for track in self.tracks),
            max(track.trajectory.t1_s for track in self.tracks),
        )


def read_handover(
    folder: Path,
    kind: Format,
    *,
    vehicle: str | None,
    extra_meta: Mapping[str, Any],
    trust: bool = False,
) -> Handover:
    """Read a plan folder for one format, and refuse what that format cannot carry.

    Args:
        folder: the plan folder.
        kind: the format.
        vehicle: only this one; None for all.
        extra_meta: keys that overrule those of the scenario.
        trust: run code of the user's own that the folder holds.

    Raises:
        InputError: no plan, code that is not trusted, files that do not belong together, no such
            vehicle, several where the format holds one, no attitude where it holds nothing else,
            or ``meta:`` lacks a key.
    """
    scenario, plan = read_plan(folder, trust=trust)
    _check(scenario, plan, folder)
    tracks = _tracks(scenario, plan, vehicle)
    meta = Meta({**scenario.meta, **extra_meta}, f"{scenario.name}: meta")
    outcome = text(read_object(folder / PLAN_JSON), "outcome", str(folder / PLAN_JSON))
    handover = Handover(scenario, outcome, meta, tracks)
    _check_carries(handover, kind)
    meta.require(kind.needs, handover.vehicles, kind.name)
    if meta.epoch is not None:
        meta.epoch.check_span(handover.span_s[1])
    return handover


def _check(scenario: Scenario, plan: Plan, folder: Path) -> None:
    """Refuse a trajectory that is not of this scenario, or not one motion."""
    said = read_interpolant(folder / INTERPOLANT_JSON).scenario_sha256
    if said != document_sha256(scenario.document):
        what = "was made for another scenario than the one in plan.json"
        raise InputError(str(folder / INTERPOLANT_JSON), what, "files of one plan")
    require_fit(scenario, plan)
    faults = clock_faults(scenario, plan.phases)
    faults += [fault for p in plan.phases for own in p.vehicles for fault in gap_faults(own)]
    if faults:
        raise InputError(str(folder / INTERPOLANT_JSON), faults[0], "one motion without gaps")


def _tracks(scenario: Scenario, plan: Plan, only: str | None) -> tuple[Track, ...]:
    names = [own.vehicle for phase in plan.phases for own in phase.vehicles]
    if only is not None and only not in names:
        hint = did_you_mean(only, names)
        options = "" if hint else f"one of: {', '.join(dict.fromkeys(names))}"
        raise InputError("--vehicle", f"is {only!r}, which the plan has not{hint}", options)
    return tuple(
        _track(scenario.phase(phase.phase), own)
        for phase in plan.phases
        for own in phase.vehicles
        if only in (None, own.vehicle)
    )


def _track(phase: Phase, own: VehicleTrajectory) -> Track:
    vehicle = phase.vehicle(own.vehicle)
    return Track(phase, vehicle, own, sample(vehicle.model, own, even_times(own)))


def _check_carries(handover: Handover, kind: Format) -> None:
    names = handover.vehicles
    if kind.single and len(names) > 1:
        what = f"is missing: a file of --to {kind.name} holds one vehicle"
        raise InputError("--vehicle", what, f"one of: {', '.join(names)}")
    still = [t for t in handover.tracks if not t.vehicle.model.turns]
    if kind.attitude_only and still:
        what = f"{still[0].name} is {still[0].vehicle.model.noun}, which has no attitude"
        raise InputError(f"--to {kind.name}", what, "a vehicle with attitude, by --vehicle")
    silent = [t.name for t in handover.tracks if not t.samples.tells_rates]
    if kind.rates and silent:
        what = f"the state of {silent[0]} does not tell its velocity and rate"
        raise InputError(f"--to {kind.name}", what, "another format, such as mat")
