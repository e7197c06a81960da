"""A small scenario document to vary, and the message that a bad one gives."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from berthing.errors import InputError
from berthing.scenario.files import from_document

Document = dict[str, Any]
Change = Callable[[Document], None]


def box(*size_m: float) -> Document:
    return {"type": "box", "size_m": list(size_m)}


@pytest.fixture
def document() -> Document:
    """A spacecraft and a block in space, in the shorthand of one phase."""
    return {
        "schema_version": 1,
        "name": "test",
        "horizon": {"duration_s": 150},
        "margins": {"default_m": 0.1},
        "vehicles": [
            {
                "name": "spacecraft",
                "parts": [{"name": "hull", "shape": box(4, 2, 2)}],
                "dynamics": {"model": "rigid-body", "mass_kg": 3, "inertia_kg_m2": [5, 5, 5]},
                "limits": {"max_force_n": 0.02, "max_torque_nm": 0.01},
                "start": {"position_m": [0, 0, 0]},
                "goal": {"position_m": [10, 3, 0]},
            }
        ],
        "structures": [
            {
                "name": "block",
                "position_m": [5, 0, 0],
                "parts": [{"name": "core", "shape": box(2, 6, 6)}],
            }
        ],
    }


@pytest.fixture
def planar() -> Document:
    """A point mass with a disc and a wall in the plane."""
    return {
        "schema_version": 1,
        "name": "planar",
        "horizon": {"duration_s": 100},
        "margins": {"default_m": 0.1},
        "vehicles": [
            {
                "name": "disc",
                "parts": [{"name": "rim", "shape": {"type": "sphere", "radius_m": 0.5}}],
                "dynamics": {"model": "point-mass", "mass_kg": 2},
                "limits": {"max_force_n": [0.1, 0.2]},
                "start": {"position_m": [0, 0]},
                "goal": {"position_m": [6, 0]},
            }
        ],
        "structures": [
            {
                "name": "wall",
                "position_m": [3, 1],
                "angle_rad": 0.5,
                "parts": [
                    {"name": "bar", "shape": box(2, 0.5)},
                    {
                        "name": "tip",
                        "position_m": [1, 0],
                        "shape": {"type": "polytope", "vertices_m": [[0, -1], [1, 0], [0, 1]]},
                    },
                ],
            }
        ],
    }


@pytest.fixture
def refused() -> Callable[[Document], str]:
    """The message of the InputError that reading a document raises; fails if it raises none."""

    def message(document: Document) -> str:
        with pytest.raises(InputError) as caught:
            from_document(document, "test.yaml")
        return str(caught.value)

    return message
