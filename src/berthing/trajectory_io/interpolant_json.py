"""interpolant.json: the canonical trajectory, to the last bit.

Numbers are printed with as many digits as it takes to read the same one back, 17 at most.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from berthing.errors import InputError
from berthing.trajectory import BASIS, PhaseTrajectory, Segment, VehicleTrajectory
from berthing.trajectory_io.strict_json import (
    array,
    names,
    number,
    objects,
    read_versioned,
    text,
)

SCHEMA_VERSION = 1

HOW_TO_READ = (
    "On [t0_s, t1_s] a component is sum_k c[k][component] T_k(s), T_k the Chebyshev polynomials "
    "of the first kind and s = (2 t - t0_s - t1_s)/(t1_s - t0_s). Columns are in the order of "
    "state_names and control_names. The controls are what flies: on a segment they are, as "
    "control_interpolation says, polynomials, linear or constant."
)


@dataclass(frozen=True)
class Interpolant:
    """What the file says.

    Attributes:
        scenario_sha256: fingerprint of the scenario document that the trajectory was planned for.
        phases: in order of time.
    """

    scenario_sha256: str
    phases: tuple[PhaseTrajectory, ...]


def write_interpolant(path: Path, phases: Sequence[PhaseTrajectory], scenario_sha256: str) -> None:
    """Write the trajectory of every phase; ``scenario_sha256`` ties it to its scenario."""
    document = {
        "schema_version": SCHEMA_VERSION,
        "scenario_sha256": scenario_sha256,
        "basis": BASIS,
        "how_to_read": HOW_TO_READ,
        "phases": [
            {"phase": p.phase, "vehicles": [_vehicle_document(own) for own in p.vehicles]}
            for p in phases
        ],
    }
    path.write_text(json.dumps(document, allow_nan=False) + "\n", encoding="utf-8")


def read_interpolant(path: Path) -> Interpolant:
    """Read it back.

    Raises:
        InputError: the file is missing, malformed, of another schema, or holds numbers that are
            not finite.
    """
    document, where = read_versioned(path, SCHEMA_VERSION), str(path)
    basis = text(document, "basis", where)
    if basis != BASIS:
        raise InputError(f"{where}.basis", f"is {basis!r}", BASIS)
    phases = [
        PhaseTrajectory(
            text(phase, "phase", f"{where}.phases[{i}]"),
            tuple(
                _vehicle(own, f"{where}.phases[{i}].vehicles[{j}]")
                for j, own in enumerate(objects(phase, "vehicles", f"{where}.phases[{i}]"))
            ),
        )
        for i, phase in enumerate(objects(document, "phases", where))
    ]
    return Interpolant(text(document, "scenario_sha256", where), tuple(phases))


def _vehicle_document(own: VehicleTrajectory) -> dict[str, Any]:
    return {
        "vehicle": own.vehicle,
        "model": own.model,
        "state_names": list(own.state_names),
        "control_names": list(own.control_names),
        "control_interpolation": own.control_interpolation,
        "segments": [
            {
                "t0_s": float(s.t0_s),
                "t1_s": float(s.t1_s),
                "state": s.state.tolist(),
                "control": s.control.tolist(),
            }
            for s in own.segments
        ],
    }


def _vehicle(document: Mapping[str, Any], where: str) -> VehicleTrajectory:
    states, controls = (names(document, f"{kind}_names", where) for kind in ("state", "control"))
    return VehicleTrajectory(
        text(document, "vehicle", where),
        text(document, "model", where),
        states,
        controls,
        tuple(
            _segment(segment, len(states), len(controls), f"{where}.segments[{k}]")
            for k, segment in enumerate(objects(document, "segments", where))
        ),
        text(document, "control_interpolation", where),
    )


def _segment(document: Mapping[str, Any], nx: int, nu: int, where: str) -> Segment:
    state, control = (array(document, key, 2, where) for key in ("state", "control"))
    for key, found, wanted in (("state", state, nx), ("control", control, nu)):
        if found.shape[1] != wanted:
            raise InputError(f"{where}.{key}", f"has {found.shape[1]} columns", str(wanted))
    return Segment(number(document, "t0_s", where), number(document, "t1_s", where), state, control)
