"""Small scenario documents, and the scenarios that they make."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from berthing.scenario.files import from_document
from berthing.scenario.scenario import Scenario

Document = dict[str, Any]

DURATION_S = 100.0


def box(*size_m: float) -> Document:
    return {"type": "box", "size_m": list(size_m)}


def spacecraft(name: str = "spacecraft", **changes: Any) -> Document:
    """A rigid body of 3 kg and 5 kg·m² about each axis, 10 m along x from its goal, no limits."""
    return {
        "name": name,
        "parts": [{"name": "hull", "shape": box(4, 2, 2)}],
        "dynamics": {"model": "rigid-body", "mass_kg": 3, "inertia_kg_m2": [5, 5, 5]},
        "start": {"position_m": [0, 0, 0]},
        "goal": {"position_m": [10, 0, 0]},
        **changes,
    }


def puck(name: str = "puck", **changes: Any) -> Document:
    """A planar disc of 2 kg, 6 m along x from its goal, no limits."""
    return {
        "name": name,
        "parts": [{"name": "rim", "shape": {"type": "sphere", "radius_m": 0.5}}],
        "dynamics": {"model": "point-mass", "mass_kg": 2},
        "start": {"position_m": [0, 0]},
        "goal": {"position_m": [6, 0]},
        **changes,
    }


def structure(name: str, position_m: Sequence[float], shape: Document, **more: Any) -> Document:
    """One part called core."""
    parts = [{"name": "core", "shape": shape}]
    return {"name": name, "position_m": list(position_m), "parts": parts, **more}


def scenario(
    *vehicles: Document, structures: Sequence[Document] = (), margin_m: float = 0.1, **changes: Any
) -> Scenario:
    """One phase of ``DURATION_S``; further keys of the file as arguments."""
    document = {
        "schema_version": 1,
        "name": "test",
        "horizon": {"duration_s": DURATION_S},
        "vehicles": list(vehicles) or [spacecraft()],
        "structures": list(structures),
        "margins": {"default_m": margin_m},
        **changes,
    }
    return from_document(document, "test.yaml")
