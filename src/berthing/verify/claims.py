"""What certificate.json claims: intervals with normals and bounds, and how wide the tubes are.

Nothing here is believed by whoever checks it: bounds follow from normals and the interpolant.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from berthing.errors import InputError
from berthing.geometry.arrays import Array
from berthing.trajectory_io.strict_json import array, number, objects, read_versioned, text
from berthing.verify.certificate import Certificate
from berthing.verify.leaves import Leaves, Status
from berthing.verify.tube import Tube

SCHEMA_VERSION = 1

# t0_s, t1_s, bound_m and the normals at both ends.
COLUMNS = 9
NO_ROWS = np.empty((0, COLUMNS))

HOW_TO_READ = (
    "For each pair 'a|b' rows of t0_s, t1_s, bound_m, n0 (3), n1 (3): for every t in [t0_s, t1_s] "
    "the normal n(t), linear from n0 to n1, proves that what flies keeps the clearance bound_m. "
    "Normals point from a to b, in the frame of b's body, or in inertial axes where b rests. The "
    "bound follows from the normals, the interpolant and the shapes; docs/certificate.md says how."
)


@dataclass(frozen=True)
class PairClaim:
    """Of one pair: intervals (k,), what they are said to prove, and by which normals (k, 2, 3)."""

    pair: str
    t0: Array
    t1: Array
    bound: Array
    normals: Array


@dataclass(frozen=True)
class PhaseClaims:
    """Of one phase: tubes by vehicle, and pairs."""

    phase: str
    tubes: Mapping[str, Tube]
    pairs: tuple[PairClaim, ...]


@dataclass(frozen=True)
class Claims:
    """The whole file, tied to its scenario by a fingerprint."""

    scenario_sha256: str
    phases: tuple[PhaseClaims, ...]

    def phase(self, name: str) -> PhaseClaims:
        """What is claimed of the phase; nothing where the file is silent about it."""
        for claims in self.phases:
            if claims.phase == name:
                return claims
        return PhaseClaims(name, {}, ())


def claims_of(certificates: Sequence[Certificate], scenario_sha256: str) -> Claims:
    """What certificates have proven, with their evidence."""
    return Claims(scenario_sha256, tuple(_phase_claims(own) for own in certificates))


def _phase_claims(certificate: Certificate) -> PhaseClaims:
    pairs = [
        _pair_claim(name, e.leaves.take(e.leaves.pair == i))
        for e in certificate.evidence
        for i, name in enumerate(e.pairs)
    ]
    return PhaseClaims(certificate.phase, certificate.tubes, tuple(pairs))


def _pair_claim(name: str, leaves: Leaves) -> PairClaim:
    """Proven intervals in order of time."""
    proven = leaves.take(leaves.status == int(Status.CERTIFIED))
    own = proven.take(np.argsort(proven.t0, kind="stable"))
    return PairClaim(name, own.t0, own.t1, own.bound, own.normals)


def write_claims(path: Path, claims: Claims) -> None:
    """Write certificate.json."""
    document = {
        "schema_version": SCHEMA_VERSION,
        "scenario_sha256": claims.scenario_sha256,
        "how_to_read": HOW_TO_READ,
        "phases": [_phase_document(own) for own in claims.phases],
    }
    path.write_text(json.dumps(document, allow_nan=False) + "\n", encoding="utf-8")


def read_claims(path: Path) -> Claims:
    """Read it back.

    Raises:
        InputError: the file is missing, malformed, of another schema, or holds numbers that are
            not finite.
    """
    document, where = read_versioned(path, SCHEMA_VERSION), str(path)
    phases = [
        _phase(own, f"{where}.phases[{i}]")
        for i, own in enumerate(objects(document, "phases", where, empty=True))
    ]
    return Claims(text(document, "scenario_sha256", where), tuple(phases))


def _phase_document(own: PhaseClaims) -> dict[str, Any]:
    return {
        "phase": own.phase,
        "tubes": [
            {"vehicle": vehicle, "position_m": tube.position_m, "attitude_rad": tube.attitude_rad}
            for vehicle, tube in own.tubes.items()
            if np.isfinite([tube.position_m, tube.attitude_rad]).all()
        ],
        "pairs": [{"pair": claim.pair, "intervals": _rows(claim)} for claim in own.pairs],
    }


def _rows(claim: PairClaim) -> list[list[float]]:
    ends = np.stack([claim.t0, claim.t1, claim.bound], axis=1)
    rows: list[list[float]] = np.hstack([ends, claim.normals.reshape(-1, 6)]).tolist()
    return rows


def _phase(document: Mapping[str, Any], where: str) -> PhaseClaims:
    tubes = {
        text(own, "vehicle", f"{where}.tubes[{i}]"): _tube(own, f"{where}.tubes[{i}]")
        for i, own in enumerate(objects(document, "tubes", where, empty=True))
    }
    pairs = [
        _pair(own, f"{where}.pairs[{i}]")
        for i, own in enumerate(objects(document, "pairs", where, empty=True))
    ]
    return PhaseClaims(text(document, "phase", where), tubes, tuple(pairs))


def _tube(document: Mapping[str, Any], where: str) -> Tube:
    position, attitude = (number(document, key, where) for key in ("position_m", "attitude_rad"))
    for key, value in (("position_m", position), ("attitude_rad", attitude)):
        if value < 0.0:
            raise InputError(f"{where}.{key}", f"is {value:g}", "0 or more")
    return Tube(position, attitude)


def _pair(document: Mapping[str, Any], where: str) -> PairClaim:
    name = text(document, "pair", where)
    # A pair of which nothing is proven has no intervals.
    rows = array(document, "intervals", 2, where) if document.get("intervals") != [] else NO_ROWS
    if rows.shape[1] != COLUMNS:
        raise InputError(f"{where}.intervals", f"have {rows.shape[1]} columns", str(COLUMNS))
    return PairClaim(name, rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 3:].reshape(-1, 2, 3))
