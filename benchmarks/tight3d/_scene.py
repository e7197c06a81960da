"""What the families share: vehicles, walls, and a case put together from a motion."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.tight3d._motion import ORIGIN, At, Leg, first, flown, last, peaks, placed, witness
from berthing.geometry import quaternion
from berthing.geometry.arrays import Array
from berthing.scenario.files import from_document
from berthing.scenario.scenario import Scenario
from berthing.trajectory import Plan
from support.documents import box

Document = dict[str, Any]

DIGITS = 9
"""To which numbers in documents are rounded, so that they are the same on every machine."""

SPARE = 1.3
"""Largest force and torque allowed, over those of the witness."""

ARM = 0.1
"""Of the vehicle's radius: thrusters that far off the middle turn it at least."""

DENSITY = (60.0, 250.0)
"""kg/m³ of the box around a vehicle: tanks and modules are mostly empty."""


@dataclass(frozen=True)
class Case:
    """A scenario and a motion that solves it.

    Attributes:
        document: of the scenario, as files have it.
        legs: of the witness, by vehicle.
    """

    family: str
    seed: int
    document: Document
    legs: dict[str, Sequence[Leg]]

    @property
    def name(self) -> str:
        return self.document["name"]

    def scenario(self) -> Scenario:
        """Read from the document."""
        return from_document(self.document, self.name)

    def witness(self, scenario: Scenario) -> Plan:
        """The motion from which the case was built; ``scenario`` may be a changed one."""
        return witness(scenario, self.legs)


@dataclass(frozen=True)
class Craft:
    """A vehicle: its parts, and the box (3,) around them, centred at its reference point."""

    parts: list[Document]
    size: Array

    @property
    def radius(self) -> float:
        """Of a ball about the reference point that holds the vehicle."""
        return 0.5 * float(np.linalg.norm(self.size))


@dataclass(frozen=True)
class Flight:
    """A vehicle, how it flies in the frame of the scene, and its name."""

    craft: Craft
    legs: list[Leg]
    name: str = "spacecraft"


def part(name: str, shape: Document, at: At | Sequence[float] = (0, 0, 0)) -> Document:
    """A placed shape."""
    at = at if isinstance(at, At) else At(np.asarray(at, dtype=float))
    return {"name": name, "shape": shape, **where(at)}


def where(at: At) -> Document:
    """A pose in a document."""
    return {"position_m": at.r, "attitude": at.q}


def rod(radius: float, length: float, axis: str = "x", kind: str = "cylinder") -> Document:
    """A cylinder, or another shape with the same keys."""
    return {"type": kind, "radius_m": radius, "length_m": length, "axis": axis}


def ring(
    name: str, hole: Sequence[float], depth: float, outer: Sequence[float], at: At = ORIGIN
) -> list[Document]:
    """Four boxes around a hole (y, z) whose axis is x, ``depth`` deep, ``outer`` (y, z) in all."""
    y, z = (0.5 * (o - h) for o, h in zip(outer, hole, strict=True))
    out = []
    for sign, side in ((1, "plus"), (-1, "minus")):
        beside = At(np.array([0.0, sign * 0.5 * (hole[0] + y), 0.0])).seen_from(at)
        above = At(np.array([0.0, 0.0, sign * 0.5 * (hole[1] + z)])).seen_from(at)
        out += [
            part(f"{name}-y-{side}", box(depth, y, outer[1]), beside),
            part(f"{name}-z-{side}", box(depth, hole[0], z), above),
        ]
    return out


def along_x(x: float) -> At:
    """A place on the x axis."""
    return At(np.array([x, 0.0, 0.0]))


def structure(name: str, parts: list[Document], at: At) -> Document:
    """A body at rest."""
    return {"name": name, "parts": parts, **where(at)}


def random_turn(rng: np.random.Generator, most_rad: float = math.pi) -> Array:
    """A quaternion about a random axis, by an angle up to ``most_rad``."""
    axis = rng.normal(size=3)
    angle = np.asarray(rng.uniform(0.0, most_rad))
    return np.asarray(quaternion.from_axis_angle(axis / np.linalg.norm(axis), angle))


def about(axis: str, angle_rad: float) -> Array:
    """A quaternion about a coordinate axis."""
    return np.asarray(
        quaternion.from_axis_angle(np.eye(3)["xyz".index(axis)], np.asarray(angle_rad))
    )


def random_frame(rng: np.random.Generator) -> At:
    """Where a scene lies in inertial space: anywhere, in any attitude."""
    return At(rng.uniform(-5.0, 5.0, 3), random_turn(rng))


def case(
    family: str, seed: int, rng: np.random.Generator, margin_m: float, frame: At,
    flights: Sequence[Flight], structures: list[Document], description: str,
) -> Case:  # fmt: skip
    """The case in which ``flights``, given in ``frame``, are a solution.

    Mass properties are drawn; limits follow from what the flights need.
    """
    legs = {flight.name: placed(flight.legs, frame) for flight in flights}
    vehicles = [_vehicle(flight, legs[flight.name], rng) for flight in flights]
    horizon = max(sum(leg.duration_s for leg in own) for own in legs.values())
    document = plain(
        {
            "schema_version": 1, "name": f"{family}-{seed:03d}", "description": description,
            "horizon": {"duration_s": round(horizon, 1)}, "margins": {"default_m": margin_m},
            "vehicles": vehicles, "structures": structures,
        }
    )  # fmt: skip
    scenario = from_document(document, document["name"])
    for vehicle, own in zip(document["vehicles"], scenario.phases[0].vehicles, strict=True):
        force, torque = peaks(flown(own, legs[own.name]))
        arm = ARM * own.body.bounding_radius
        vehicle["limits"] = {
            "max_force_n": _rounded_up(SPARE * force),
            "max_torque_nm": _rounded_up(SPARE * max(torque, arm * force)),
        }
    return Case(family, seed, document, legs)


def _vehicle(flight: Flight, legs: Sequence[Leg], rng: np.random.Generator) -> Document:
    size = flight.craft.size
    mass = float(np.prod(size)) * rng.uniform(*DENSITY)
    squares = size**2
    # A uniform box's moments, and somewhat less: mass gathers about the middle.
    moments = mass / 12.0 * (np.sum(squares) - squares) * rng.uniform(0.6, 1.0)
    return {
        "name": flight.name, "parts": flight.craft.parts,
        "dynamics": {
            "model": "rigid-body", "mass_kg": round(mass, 2),
            "inertia_kg_m2": [round(float(m), 3) for m in moments],
        },
        "start": where(first(legs)), "goal": where(last(legs)),
    }  # fmt: skip


def plain(value: Any) -> Any:
    """As JSON has it, numbers rounded."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, np.ndarray | list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, float | np.floating):
        # Without the sign of zero.
        return round(float(value), DIGITS) + 0.0
    return value


def _rounded_up(value: float) -> float:
    """To two significant digits."""
    unit = 10.0 ** (math.floor(math.log10(value)) - 1)
    return float(f"{math.ceil(value / unit) * unit:.3g}")
