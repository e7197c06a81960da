"""Checking a plan folder from its files alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

from berthing.errors import InputError
from berthing.scenario.files import from_document
from berthing.scenario.normal import document_sha256
from berthing.scenario.scenario import Scenario
from berthing.trajectory import Plan, SeparationCostate
from berthing.trajectory_io import (
    read_interpolant,
    read_nodes,
    read_trajectory,
    read_versioned,
)
from berthing.trajectory_io.separation_costates import KEY, read_separations
from berthing.trajectory_io.strict_json import number, text, whole
from berthing.verify.agreement import node_faults, table_faults
from berthing.verify.claims import Claims, read_claims
from berthing.verify.extremal import checked_extremality
from berthing.verify.settings import DEFAULT_CERTIFICATE, CertificateSettings
from berthing.verify.size_limits import require_modest_scenario
from berthing.verify.verification import Verification, verify

PLAN_JSON, INTERPOLANT_JSON = "plan.json", "interpolant.json"
NODES_CSV, TRAJECTORY_CSV = "nodes.csv", "trajectory.csv"
CERTIFICATE_JSON = "certificate.json"
SCHEMA_VERSION = 1


def verify_folder(
    folder: str | Path,
    *,
    search: bool = False,
    settings: CertificateSettings = DEFAULT_CERTIFICATE,
    trust: bool = False,
) -> Verification:
    """Check the plan in a folder: the trajectory, and that its files agree with each other.

    What plan.json itself claims of the plan is not believed. Clearance is what certificate.json
    proves; without that file nothing is, unless a search finds it anew. Residuals of the conditions
    of optimality are found anew from nodes.csv and the multipliers in plan.json; they decide
    nothing.

    Args:
        search: prove clearance anew in place of checking certificate.json.
        settings: of that search.
        trust: run code of the user's own that the folder holds.

    Raises:
        InputError: a file is missing, malformed or of another schema, the plan does not belong
            to its scenario, or that holds code which is not trusted.
        CapabilityError: a model, motion or shape that the checks do not know.
    """
    own = _read(Path(folder), trust)
    table = read_trajectory(Path(folder) / TRAJECTORY_CSV)
    claims, doubts = (None, []) if search else _claims(Path(folder), own.sha256)
    verification = verify(own.scenario, own.plan, settings=settings, claims=claims)
    tables = table_faults(own.scenario, own.plan, table)
    strange = node_faults(own.plan)
    verification = verification.with_reasons([*own.faults, *doubts, *tables, *strange])
    # Of nodes that are not the trajectory's nothing follows.
    if strange or own.faults:
        return verification
    return replace(verification, optimality=checked_extremality(own.scenario, own.plan))


def _claims(folder: Path, sha256: str) -> tuple[Claims, list[str]]:
    """What certificate.json claims, and what is wrong with the file as a whole."""
    if not (folder / CERTIFICATE_JSON).exists():
        return Claims("", ()), [f"{CERTIFICATE_JSON} is missing"]
    claims = read_claims(folder / CERTIFICATE_JSON)
    return claims, _strangers({CERTIFICATE_JSON: claims.scenario_sha256}, sha256)


def _strangers(said: Mapping[str, str], found: str) -> list[str]:
    """Files, by name with their fingerprints, that are not of the scenario in plan.json."""
    return [
        f"scenario: {name} was made for the scenario {sha[:12]}…, plan.json holds {found[:12]}…"
        for name, sha in said.items()
        if sha != found
    ]


def read_plan(folder: str | Path, *, trust: bool = False) -> tuple[Scenario, Plan]:
    """The scenario and the plan in a folder, unchecked.

    Raises:
        InputError: as for ``verify_folder``.
    """
    own = _read(Path(folder), trust)
    return own.scenario, own.plan


class _Folder(NamedTuple):
    """What the files say; ``faults`` is where they are not of the scenario with this SHA-256."""

    scenario: Scenario
    plan: Plan
    sha256: str
    faults: list[str]


def _read(folder: Path, trust: bool) -> _Folder:
    if not folder.is_dir():
        raise InputError(str(folder), "is not a folder", "a plan folder")
    record, where = read_versioned(folder / PLAN_JSON, SCHEMA_VERSION), str(folder / PLAN_JSON)
    document = record.get("scenario")
    if not isinstance(document, dict):
        raise InputError(f"{where}.scenario", "is not a scenario", "the whole scenario")
    if not document:
        raise InputError(
            f"{where}.scenario",
            "is empty: it was put together in Python and has no document to check the plan by",
            "a scenario from a file, or one made by from_document",
        )
    require_modest_scenario(document, f"{where}.scenario")
    scenario = from_document(document, f"{where}.scenario", trust=trust)
    interpolant = read_interpolant(folder / INTERPOLANT_JSON)
    plan = Plan(
        scenario.name,
        interpolant.phases,
        read_nodes(folder / NODES_CSV, scenario),
        text(record, "formulation", where),
        text(record, "scheme", where),
        number(record, "cost", where),
        whole(record, "iterations", where),
        whole(record, "seed", where),
        _backoff(record, where),
        cost_per_margin=_slope(record, where),
        separations=_separations(record, scenario, where),
    )
    sha256, said = _sha256(document, where), {INTERPOLANT_JSON: interpolant.scenario_sha256}
    if "scenario_sha256" in record:
        said[PLAN_JSON] = text(record, "scenario_sha256", where)
    return _Folder(scenario, plan, sha256, _strangers(said, sha256))


def _backoff(record: Mapping[str, Any], where: str) -> float:
    verification = record.get("verification")
    if not isinstance(verification, dict):
        raise InputError(f"{where}.verification", "is not an object")
    return number(verification, "backoff_m", f"{where}.verification")


def _slope(record: Mapping[str, Any], where: str) -> float | None:
    """Recorded, not checked."""
    key = "cost_per_margin"
    return None if record.get(key) is None else number(record, key, where)


def _separations(
    record: Mapping[str, Any], scenario: Scenario, where: str
) -> tuple[SeparationCostate, ...]:
    """Multipliers are claims like normals: wrong ones only make the conditions worse."""
    optimality = record.get("optimality")
    if optimality is None:
        return ()
    if not isinstance(optimality, dict):
        raise InputError(f"{where}.optimality", "is not an object")
    if KEY not in optimality:
        return ()
    return read_separations(optimality, scenario, f"{where}.optimality")


def _sha256(document: Mapping[str, Any], where: str) -> str:
    try:
        return document_sha256(document)
    except ValueError:
        raise InputError(f"{where}.scenario", "holds text that is not Unicode") from None
