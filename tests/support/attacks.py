"""Plans that fly freely, whose nearest approach is known in closed form, and what is said of them.

Without force a body keeps its velocity, and one of equal moments of inertia keeps its rate too, so
that a plan of any speed and spin is a true solution of the dynamics: whatever refuses it refuses
it for its clearance.
"""

from __future__ import annotations

import json
import runpy
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from berthing.errors import CapabilityError, InputError
from berthing.geometry import quaternion
from berthing.scenario.files import from_document
from berthing.scenario.normal import document_sha256
from berthing.scenario.scenario import Scenario
from berthing.trajectory import Plan, Segment, VehicleNodes, VehicleTrajectory
from berthing.verify.folder import verify_folder
from support import hand_made

Document = dict[str, Any]
Array = np.ndarray

EXAMPLES = Path(__file__).parents[2] / "examples"
CHECK, FLY = (
    runpy.run_path(str(EXAMPLES / name), run_name="example")["main"]
    for name in ("09_check_certificate.py", "10_fly_the_controls.py")
)
# What the examples' own entry points turn into a message.
REFUSALS = (ArithmeticError, LookupError, OSError, StopIteration, TypeError, ValueError)
DEGREE = 16


@dataclass(frozen=True)
class Flight:
    """A body that drifts and spins about an axis of its own: shape, motion, duration."""

    shape: Document
    start_m: Sequence[float]
    velocity_m_s: Sequence[float]
    axis: Sequence[float] = (0.0, 0.0, 1.0)
    rate_rad_s: float = 0.0
    duration_s: float = 10.0
    segments: int = 10

    def states(self, t: Array) -> Array:
        """Native states (k, 13)."""
        axis = np.array(self.axis) / np.linalg.norm(self.axis)
        q = quaternion.from_axis_angle(axis, self.rate_rad_s * t)
        ones = np.ones((len(t), 1))
        v = np.array(self.velocity_m_s, dtype=float)
        r = np.array(self.start_m, dtype=float) + t[:, None] * v
        return np.hstack([r, ones * v, q, ones * self.rate_rad_s * axis])

    def document(self, structures: Sequence[Document], margin_m: float) -> Document:
        """The scenario that this flight answers."""
        ends = []
        for row in self.states(np.array([0.0, self.duration_s])).tolist():
            ends.append(
                {
                    "position_m": row[:3],
                    "velocity_m_s": row[3:6],
                    "attitude": row[6:10],
                    "rate_rad_s": row[10:],
                }
            )
        craft = {
            "name": "craft",
            "parts": [{"name": "hull", "shape": self.shape}],
            "dynamics": {"model": "rigid-body", "mass_kg": 3, "inertia_kg_m2": [5, 5, 5]},
            "start": ends[0],
            "goal": ends[1],
        }
        return {
            "schema_version": 1,
            "name": "flight",
            "horizon": {"duration_s": self.duration_s},
            "margins": {"default_m": margin_m},
            "vehicles": [craft],
            "structures": list(structures),
        }

    def plan(self, whole: Scenario) -> Plan:
        """The motion, to rounding."""
        own = whole.phases[0].vehicles[0]
        model, nothing = own.model, np.zeros((1, 6))
        pieces = tuple(
            Segment(float(a), float(b), hand_made.fitted(self.states, a, b, DEGREE), nothing)
            for a, b in pairwise(np.linspace(0.0, self.duration_s, self.segments + 1))
        )
        flown = VehicleTrajectory(
            own.name, model.kind, model.state_names, model.control_names, pieces
        )
        t = np.linspace(0.0, self.duration_s, 3 * self.segments + 1)
        x = flown.state(t)
        nodes = VehicleNodes("main", own.name, t, x, np.zeros((len(t), 6)), np.full_like(x, np.nan))
        return hand_made.plan([flown], [nodes])

    def write(self, folder: Path, structures: Sequence[Document], margin_m: float) -> None:
        """A plan folder with the certificate of whatever can be proven."""
        whole = from_document(self.document(structures, margin_m), "attack")
        hand_made.write_folder(folder, whole, self.plan(whole))


def block(size_m: Sequence[float], position_m: Sequence[float], name: str = "block") -> Document:
    """A box at rest."""
    shape = {"type": "box", "size_m": list(size_m)}
    return {
        "name": name,
        "parts": [{"name": "face", "shape": shape}],
        "position_m": list(position_m),
    }


def certified(folder: Path, *, search: bool = False) -> tuple[bool, str]:
    """Whether ``berthing verify`` certifies the folder, and its reasons or its error."""
    try:
        found = verify_folder(folder, search=search)
    except (InputError, CapabilityError) as error:
        return False, str(error)
    return found.certified, "; ".join(found.reasons)


def accepted(folder: Path) -> tuple[bool, str]:
    """Whether both small checkers accept the folder, and why not."""
    for main in (CHECK, FLY):
        try:
            with np.errstate(all="ignore"):
                main(str(folder))
        except REFUSALS as error:
            return False, f"{type(error).__name__}: {error}"
    return True, ""


def edit(path: Path, change: Callable[[Document], object]) -> None:
    """Change a JSON file in place."""
    document = json.loads(path.read_text(encoding="utf-8"))
    change(document)
    path.write_text(json.dumps(document), encoding="utf-8")


def reseal(folder: Path) -> None:
    """Give all files the fingerprint of the scenario that plan.json now has, as a forger would."""
    plan = json.loads((folder / "plan.json").read_text(encoding="utf-8"))
    own: Mapping[str, str] = {"scenario_sha256": document_sha256(plan["scenario"])}
    for name in ("plan.json", "interpolant.json", "certificate.json"):
        edit(folder / name, lambda d: d.update(own))
